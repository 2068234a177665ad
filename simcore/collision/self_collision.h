// Points of the sheet keep a distance from each other (physics.md of the course's model, phase 3).
#pragma once

#include "simcore/collision/cell_grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace clothlab {

// For every unpinned point, the mean of the vectors that would put it at `distance` from each point nearer
// than that, times `share`. All corrections come from the given positions. Neighbours are summed in
// ascending order of index, so that every way to find them gives the same bits. A pair at the very same
// place has no direction to part in and counts for nothing.
//
// The plain reading: all pairs.
void selfCollisionBruteForce(const PointArray& position, const std::vector<std::uint8_t>& pinned,
                             double distance, double share, PointArray& correction);

// The same bits in linear time. Points next to each other in the grid are always compared; other pairs are
// listed that are within the distance and a skin (Verlet 1967), and the lists hold until two points may have
// come nearer to each other by as much as the skin. The result does not depend on when they were made. Pairs
// are gone through in the order of their ends, which is ascending for both of them.
//
// The sheet is cut into bands of rows, for as many threads: each function that takes a band works on that
// band, at the same time as on the others if need be. All bands must have ended one function before any
// begins the next. Holds its buffers, so that a step allocates nothing unless the sheet crowds more than ever
// before.
class SelfCollision {
public:
    explicit SelfCollision(const Kernels& kernels) : m_kernels(&kernels) {}

    void setSheet(const RowLayout& layout, const std::vector<RowRange>& bands); // forgets all lists
    void setPinned(const std::uint8_t* pinned) { m_pinned = pinned; } // by slot, 1 or 0; must outlive this
    void setDistance(double distance) { m_distance = distance; }      // m; greater than 0

    // 1, before a step moves any point: how far the band is going to have moved since the lists were made.
    void foretell(int band, ConstPointRows position, ConstPointRows last);
    // 2: how far its points have, rows after rows of it.
    void measure(int band, ConstPointRows position, RowRange rows);

    // 3: whether the lists hold; the same for all bands. Where they do not, they are made anew: by one
    // thread, then by all.
    bool listsHold(int band);
    void sortIntoCells(ConstPointRows position);
    void list(int band, ConstPointRows position);

    // 4: which pairs are too near, what they ask of each point, and its being done.
    void findPairs(int band, ConstPointRows position);
    bool anyPairs() const;
    void addUp(int band, ConstPointRows position);
    void apply(int band, PointRows position, double share);

    std::size_t bytes() const;

private:
    // What a point's neighbours ask of it.
    struct Push {
        double x, y, z;
        double neighbours;
    };
    // The first `count` are in use.
    struct Pairs {
        std::vector<SlotPair> pairs;
        std::size_t count = 0;
        void reserve(std::size_t needed);
    };
    struct alignas(64) Band {
        RowRange rows;
        double listedDistance = -1;           // for which the lists were made; negative: there are none
        double skin = 0;                      // of the lists, as a share of the distance
        int age = 0;                          // of the lists, in steps
        std::array<double, 3> foretold{};     // sum of the motions of a few points since
        std::array<double, 3> commonMotion{}; // of all points; that does not count in the next
        double farthestSquared = 0;           // that a point has moved
        bool crowded = false;                 // too many pairs to list
        // Within the skin, above the block's point and not next to it in the grid: block after block.
        std::vector<std::uint32_t> listEnd;
        std::vector<NearBlock> listed;
        Pairs adjacent, apart; // too near: next to each other in the grid, and not
        CellGrid::Search search;
        std::vector<std::uint32_t> neighbours; // of one point
    };
    std::array<double, 3> foretoldMotion() const;
    bool crowded() const;
    std::size_t listBlock(Band& band, ConstPointRows position, int x, int y, std::size_t at) const;
    bool owns(const Band& band, std::uint32_t slot) const;
    void add(ConstPointRows position, std::uint32_t a, std::uint32_t b, bool toA, bool toB);
    bool manyPairs() const;
    void addUpCrowded(Band& band, ConstPointRows position);
    void move(std::uint32_t slot, PointRows position, double share);

    const Kernels* m_kernels;
    RowLayout m_layout;
    const std::uint8_t* m_pinned = nullptr;
    double m_distance = 0;
    RowArrays m_arrays;
    PointRows m_listedAt; // where the points were when the lists were made
    CellGrid m_cells;
    double m_skin = 0.5;      // of the lists to make next
    std::vector<Push> m_push; // by slot; all zero between steps
    std::vector<Band> m_bands;
};

} // namespace clothlab
