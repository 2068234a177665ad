// Points of the sheet keep a distance from each other.
#pragma once

#include "simcore/cloth/cloth_state.h"

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

// The same bits in linear time. Each point keeps a list of those within the distance and a skin (Verlet
// 1967); the lists hold until two points may have come nearer to each other by as much as the skin, and are
// then made anew by a hash of cells (Teschner et al. 2003, "Optimized spatial hashing for collision detection
// of deformable objects"). The result does not depend on when that was. Holds its buffers, so that a step
// allocates nothing unless the sheet crowds more than ever before.
class SelfCollision {
public:
    // Returns how many points were corrected; correction is zero for the others.
    int corrections(const PointArray& position, const std::vector<std::uint8_t>& pinned, double distance,
                    double share, PointArray& correction);

private:
    struct Cell {
        std::int64_t x, y, z;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    bool listsHold(const PointArray& position, double distance) const;
    void makeLists(const PointArray& position, double distance);
    void sortIntoCells(const PointArray& position, double cellSize);
    void appendNeighbours(const PointArray& position, int point, double reach);
    std::size_t bucket(const Cell& cell) const;

    double m_distance = -1; // for which the lists were made; negative: there are none
    PointArray m_listedAt;  // where the points were then
    std::vector<std::uint32_t>
        m_listEnd; // of each point's list in m_neighbours; it begins where the last ends
    std::vector<std::uint32_t> m_neighbours; // ascending within each list

    std::vector<Cell> m_cells;           // of each point
    std::vector<std::uint32_t> m_begin;  // of each bucket in m_points, one more at the end
    std::vector<std::uint32_t> m_points; // sorted by bucket
};

} // namespace clothlab
