// Finds the points near a place: a grid of cells that repeats itself in space, so that it needs no more
// memory for a sheet that is spread out.
#pragma once

#include "simcore/kernels/kernels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace clothlab {

// Cells whose coordinates differ by multiples of the grid's size share a place in it, as in a spatial hash
// (Teschner et al. 2003, "Optimized spatial hashing for collision detection of deformable objects"), but
// cells that are neighbours along x are neighbours in memory, too. Holds its buffers between uses.
class CellGrid {
public:
    // What a search works with; one for each thread.
    struct Search {
        std::vector<std::uint32_t> begin; // of each cell, less the points that were passed over
        std::vector<PlaceRun> runs;
        std::vector<NearBlock> found;
    };

    // Sorts all points of the layout. Places must be finite.
    void sort(ConstPointRows position, const RowLayout& layout, double cellSize);

    // Begins to search all points, or those of the rows from y on.
    void start(Search& search, int y = 0) const;

    // Those points nearer than reach to any of the points x … x + kLanes - 1 of row y, in no order: the first
    // of search.found, as many as are returned. Lanes beyond the end of the row mean nothing. The places must
    // be those that were sorted.
    std::size_t near(const Kernels& kernels, ConstPointRows position, int x, int y, double reach,
                     Search& search) const;

    // Passes over the points x … x + kLanes - 1 of row y from now on. All before them must have been.
    void pass(int x, int y, Search& search) const;

    std::size_t bytes() const;

private:
    struct CellRange {
        std::int64_t first, last;
    };
    std::int64_t coordinate(int axis, double value) const;
    std::int64_t mostCells() const;
    void chooseSize(ConstPointRows position);
    CellRange cellsAround(int axis, const double* coordinates, int count, double reach) const;

    RowLayout m_layout;
    double m_cellSize = 1;
    std::array<double, 3> m_lowest{};
    std::array<std::int64_t, 3> m_size{1, 1, 1}; // powers of two
    std::vector<std::uint32_t> m_begin;          // of each cell in the arrays below; one more at the end
    std::vector<double> m_x, m_y, m_z;           // by cell
    std::vector<std::uint32_t> m_slot;
    std::vector<std::uint32_t> m_cell; // of each point, row-major
};

} // namespace clothlab
