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

// The same bits in linear time: a hash of cells as wide as the distance (Teschner et al. 2003, "Optimized
// spatial hashing for collision detection of deformable objects"). Holds its buffers, so that a step after
// the first allocates nothing.
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
    void sortIntoCells(const PointArray& position, double cellSize);
    void gatherNeighbours(const PointArray& position, int point, double distance);
    std::size_t bucket(const Cell& cell) const;

    std::vector<Cell> m_cells;               // of each point
    std::vector<std::uint32_t> m_begin;      // of each bucket in m_points, one more at the end
    std::vector<std::uint32_t> m_points;     // sorted by bucket
    std::vector<std::uint32_t> m_neighbours; // of the point at hand, ascending
};

} // namespace clothlab
