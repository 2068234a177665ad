#include "simcore/collision/cell_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace clothlab {
namespace {

template <typename Visit>
void forEachSlot(const RowLayout& layout, Visit visit) {
    for (int y = 0; y < layout.height; ++y)
        for (int x = 0; x < layout.width; ++x)
            visit(layout.slot(x, y));
}

} // namespace

// Far out, where no integer could tell, all is one cell.
std::int64_t CellGrid::coordinate(int axis, double value) const {
    const double cells = (value - m_lowest[std::size_t(axis)]) / m_cellSize;
    return static_cast<std::int64_t>(std::clamp(cells, 0.0, 1e15));
}

std::int64_t CellGrid::mostCells() const {
    return 2 * std::int64_t(m_layout.width) * m_layout.height + 64;
}

// As large as the sheet, so that no two cells share a place, but of no more cells than a few for each point.
void CellGrid::chooseSize(ConstPointRows position) {
    const std::array<const double*, 3> coordinates{position.x, position.y, position.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double lowest = coordinates[axis][0];
        double highest = lowest;
        forEachSlot(m_layout, [&](int slot) {
            lowest = std::min(lowest, coordinates[axis][slot]);
            highest = std::max(highest, coordinates[axis][slot]);
        });
        m_lowest[axis] = lowest;
        const double cells = std::clamp((highest - lowest) / m_cellSize + 1, 1.0, 1e6);
        m_size[axis] = std::int64_t(std::bit_ceil(std::uint64_t(cells)));
    }
    while (m_size[0] * m_size[1] * m_size[2] > mostCells())
        *std::max_element(m_size.begin(), m_size.end()) /= 2;
}

// Counting sort of the points by cell.
void CellGrid::sort(ConstPointRows position, const RowLayout& layout, double cellSize) {
    m_layout = layout;
    m_cellSize = cellSize;
    chooseSize(position);
    const auto n = std::size_t(layout.width) * std::size_t(layout.height);
    m_begin.reserve(std::size_t(mostCells()) + 1);
    m_begin.assign(std::size_t(m_size[0] * m_size[1] * m_size[2]) + 1, 0);
    for (std::vector<double>* sorted : {&m_x, &m_y, &m_z})
        sorted->resize(n);
    m_slot.resize(n);
    m_cell.resize(n);
    std::size_t point = 0;
    forEachSlot(layout, [&](int slot) {
        const std::int64_t x = coordinate(0, position.x[slot]) & (m_size[0] - 1);
        const std::int64_t y = coordinate(1, position.y[slot]) & (m_size[1] - 1);
        const std::int64_t z = coordinate(2, position.z[slot]) & (m_size[2] - 1);
        const auto cell = std::size_t((z * m_size[1] + y) * m_size[0] + x);
        m_cell[point++] = std::uint32_t(cell);
        ++m_begin[cell];
    });
    std::uint32_t end = 0;
    for (std::uint32_t& begin : m_begin)
        begin = end += begin;
    forEachSlot(layout, [&](int slot) { // from the end of each cell down
        const std::uint32_t to = --m_begin[m_cell[--point]];
        slot = layout.slotCount() - layout.stride + layout.width - 1 - slot;
        m_slot[to] = std::uint32_t(slot);
        m_x[to] = position.x[slot];
        m_y[to] = position.y[slot];
        m_z[to] = position.z[slot];
    });
}

CellGrid::CellRange CellGrid::cellsAround(int axis, const double* coordinates, int count,
                                          double reach) const {
    const auto [lowest, highest] = std::minmax_element(coordinates, coordinates + count);
    // A little more than the reach, for the rounding of these sums.
    const double margin = reach * (1 + 1e-8) + 1e-15 * (std::abs(*lowest) + std::abs(*highest));
    const CellRange range{coordinate(axis, *lowest - margin), coordinate(axis, *highest + margin)};
    // No cell is looked at twice, however far apart the points are.
    return {range.first, std::min(range.last, range.first + m_size[std::size_t(axis)] - 1)};
}

// The points of a cell are in ascending order.
void CellGrid::start(Search& search, int y) const {
    search.runs.reserve(256); // more than a block of any sheet that holds together is near
    search.begin.reserve(m_begin.capacity());
    search.begin = m_begin;
    for (std::size_t point = 0; point < std::size_t(y) * std::size_t(m_layout.width); ++point)
        ++search.begin[m_cell[point]];
}

void CellGrid::pass(int x, int y, Search& search) const {
    const std::size_t row = std::size_t(y) * std::size_t(m_layout.width);
    for (int end = std::min(x + RowLayout::kLanes, m_layout.width); x < end; ++x)
        ++search.begin[m_cell[row + std::size_t(x)]];
}

std::size_t CellGrid::near(const Kernels& kernels, ConstPointRows position, int x, int y, double reach,
                           Search& search) const {
    const int slot = m_layout.slot(x, y);
    const int count = std::min(RowLayout::kLanes, m_layout.width - x);
    const CellRange cx = cellsAround(0, position.x + slot, count, reach);
    const CellRange cy = cellsAround(1, position.y + slot, count, reach);
    const CellRange cz = cellsAround(2, position.z + slot, count, reach);
    const std::int64_t first = cx.first & (m_size[0] - 1);
    const std::int64_t last = cx.last & (m_size[0] - 1);
    std::size_t candidates = 0;
    search.runs.clear();
    const auto add = [&](std::int64_t row, std::int64_t from, std::int64_t to) {
        for (auto cell = std::size_t(row + from); cell <= std::size_t(row + to); ++cell) {
            const PlaceRun run{search.begin[cell], m_begin[cell + 1]};
            candidates += run.end - run.begin;
            if (!search.runs.empty() && search.runs.back().end == run.begin)
                search.runs.back().end = run.end;
            else if (run.begin != run.end)
                search.runs.push_back(run);
        }
    };
    for (std::int64_t z = cz.first; z <= cz.last; ++z)
        for (std::int64_t row = cy.first; row <= cy.last; ++row) {
            const std::int64_t begin =
                ((z & (m_size[2] - 1)) * m_size[1] + (row & (m_size[1] - 1))) * m_size[0];
            if (first <= last) {
                add(begin, first, last);
            } else { // around the end of the row of cells
                add(begin, first, m_size[0] - 1);
                add(begin, 0, last);
            }
        }
    if (search.found.size() < candidates + 1)
        search.found.resize(2 * candidates + 1);
    const SortedPlaces places{m_x.data(), m_y.data(), m_z.data(), m_slot.data()};
    return kernels.nearBlock(position, slot, reach, places, search.runs.data(), search.runs.size(),
                             search.found.data());
}

std::size_t CellGrid::bytes() const {
    return 4 * (m_begin.capacity() + m_slot.capacity() + m_cell.capacity()) +
           8 * (m_x.capacity() + m_y.capacity() + m_z.capacity());
}

} // namespace clothlab
