// Which points of a sheet touch others of it, once and not step after step: simcore/collision keeps lists for
// many steps, which cost more than they save here.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <array>
#include <cstdint>
#include <vector>

namespace clothlab {

// Points sorted into cells as wide as the distance. Cells that are far apart may share a place (Teschner et
// al. 2003, "Optimized spatial hashing for collision detection of deformable objects"). Holds its buffers.
class TouchingPoints {
public:
    explicit TouchingPoints(const Grid& grid);

    // Sets touches[i] to 1 for each point that is nearer than distance to another that no spring joins with
    // it, switched on or not. Positions must be finite, distance greater than 0.
    void find(const PointArray& position, double distance, std::vector<std::uint8_t>& touches);

private:
    // Points in some order, and room for kAtOnce more. Single precision, from the lowest place of the sheet,
    // is as exact as the word touching.
    struct Places {
        std::vector<float> x, y, z;
        std::vector<std::int32_t> point;
        void resize(std::size_t count);
    };
    void measure(const PointArray& position, double distance);
    void sort(const PointArray& position, double distance);
    void gather(std::uint32_t begin, std::uint32_t end);
    void gatherRow(std::uint32_t row, std::uint32_t x);
    void gatherAround(std::uint32_t x, std::uint32_t y, std::uint32_t z);
    void compare(std::size_t own, float distanceSquared, std::vector<std::uint8_t>& touches);
    bool joined(int a, int b) const;

    int m_width;
    std::vector<std::int32_t> m_columnOf; // by point
    std::array<double, 3> m_lowest{};
    std::array<std::uint32_t, 3> m_size{2, 2, 2}; // cells; powers of two
    std::vector<std::uint32_t> m_begin;           // of each cell in m_places; one more at the end
    std::vector<std::uint32_t> m_cellOf;          // by point
    Places m_places;                              // by cell
    // Those that are compared with each other: of a cell, and of half of the cells around it.
    Places m_gathered;
    std::vector<std::int32_t> m_isNear;
    std::size_t m_gatheredCount = 0;
};

} // namespace clothlab
