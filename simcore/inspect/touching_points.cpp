#include "simcore/inspect/touching_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace clothlab {
namespace {

constexpr double kMostCells = 1e9;        // along an axis, before places are shared
constexpr std::uint32_t kLeastShared = 4; // places along an axis, so that a cell and its neighbours differ

std::uint32_t cellOf(double value, double lowest, double perCell) {
    return static_cast<std::uint32_t>(std::min((value - lowest) * perCell, kMostCells));
}

std::pair<double, double> ends(const std::vector<double>& values) {
    constexpr std::size_t lanes = 4; // that need not wait for each other
    std::array<double, lanes> lowest{};
    std::array<double, lanes> highest{};
    lowest.fill(values.front());
    highest.fill(values.front());
    for (std::size_t i = 0; i < values.size(); ++i) {
        lowest[i % lanes] = std::min(lowest[i % lanes], values[i]);
        highest[i % lanes] = std::max(highest[i % lanes], values[i]);
    }
    return {*std::min_element(lowest.begin(), lowest.end()),
            *std::max_element(highest.begin(), highest.end())};
}

constexpr std::size_t kAtOnce = 4; // points that are copied together

} // namespace

void TouchingPoints::Places::resize(std::size_t count) {
    for (std::vector<float>* values : {&x, &y, &z})
        values->resize(count + kAtOnce);
    point.resize(count + kAtOnce);
}

TouchingPoints::TouchingPoints(const Grid& grid)
    : m_width(grid.width), m_columnOf(std::size_t(grid.pointCount())),
      m_cellOf(std::size_t(grid.pointCount())) {
    m_places.resize(std::size_t(grid.pointCount()));
    for (int i = 0; i < grid.pointCount(); ++i)
        m_columnOf[std::size_t(i)] = grid.place(i).x;
}

// Without a division, as most points that are near each other are joined.
bool TouchingPoints::joined(int a, int b) const {
    const int across = m_columnOf[std::size_t(b)] - m_columnOf[std::size_t(a)];
    const int rowsApart = std::abs(b - a - across); // in points
    const int columnsApart = std::abs(across);
    return (columnsApart <= 1 && rowsApart <= m_width) || (columnsApart == 2 && rowsApart == 0) ||
           (columnsApart == 0 && rowsApart == 2 * m_width);
}

// One cell more than the sheet takes, which stays empty: beyond the ends there is nothing.
void TouchingPoints::measure(const PointArray& position, double distance) {
    std::size_t axis = 0;
    for (const std::vector<double>* values : {&position.x, &position.y, &position.z}) {
        const auto [lowest, highest] = ends(*values);
        m_lowest[axis] = lowest;
        m_size[axis] = std::bit_ceil(cellOf(highest, lowest, 1 / distance) + 2);
        ++axis;
    }
    const auto most = 4 * std::uint64_t(position.size()) + 64;
    while (std::uint64_t(m_size[0]) * m_size[1] > most ||
           std::uint64_t(m_size[0]) * m_size[1] * m_size[2] > most) {
        std::uint32_t& largest = *std::max_element(m_size.begin(), m_size.end());
        if (largest == kLeastShared)
            break;
        largest /= 2;
    }
}

void TouchingPoints::sort(const PointArray& position, double distance) {
    measure(position, distance);
    const double perCell = 1 / distance;
    m_begin.assign(std::size_t(m_size[0]) * m_size[1] * m_size[2] + 1, 0);
    for (std::size_t i = 0; i < position.size(); ++i) {
        const std::uint32_t x = cellOf(position.x[i], m_lowest[0], perCell) & (m_size[0] - 1);
        const std::uint32_t y = cellOf(position.y[i], m_lowest[1], perCell) & (m_size[1] - 1);
        const std::uint32_t z = cellOf(position.z[i], m_lowest[2], perCell) & (m_size[2] - 1);
        m_cellOf[i] = (z * m_size[1] + y) * m_size[0] + x;
        ++m_begin[m_cellOf[i]];
    }
    std::uint32_t end = 0;
    for (std::uint32_t& begin : m_begin)
        begin = end += begin;
    for (std::size_t i = position.size(); i-- > 0;) { // from the end of each cell down
        const std::size_t at = --m_begin[m_cellOf[i]];
        m_places.x[at] = float(position.x[i] - m_lowest[0]);
        m_places.y[at] = float(position.y[i] - m_lowest[1]);
        m_places.z[at] = float(position.z[i] - m_lowest[2]);
        m_places.point[at] = std::int32_t(i);
    }
}

// A few at once, also beyond the end: most runs are short.
void TouchingPoints::gather(std::uint32_t begin, std::uint32_t end) {
    const std::size_t count = end - begin;
    if (m_gatheredCount + count > m_isNear.size()) {
        m_isNear.resize(2 * (m_gatheredCount + count) + 64);
        m_gathered.resize(m_isNear.size());
    }
    for (std::size_t i = 0; i < count; i += kAtOnce) {
        const std::size_t to = m_gatheredCount + i;
        std::memcpy(&m_gathered.x[to], &m_places.x[begin + i], kAtOnce * sizeof(float));
        std::memcpy(&m_gathered.y[to], &m_places.y[begin + i], kAtOnce * sizeof(float));
        std::memcpy(&m_gathered.z[to], &m_places.z[begin + i], kAtOnce * sizeof(float));
        std::memcpy(&m_gathered.point[to], &m_places.point[begin + i], kAtOnce * sizeof(std::int32_t));
    }
    m_gatheredCount += count;
}

// The three cells of a row that are next to x.
void TouchingPoints::gatherRow(std::uint32_t row, std::uint32_t x) {
    if (x > 0 && x + 1 < m_size[0]) {
        gather(m_begin[row + x - 1], m_begin[row + x + 2]);
        return;
    }
    for (const std::uint32_t near : {x - 1, x, x + 1}) { // around the end
        const std::uint32_t cell = row + (near & (m_size[0] - 1));
        gather(m_begin[cell], m_begin[cell + 1]);
    }
}

// Of two neighbouring cells one is gathered for the other.
void TouchingPoints::gatherAround(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    const auto row = [&](std::uint32_t rowY, std::uint32_t rowZ) {
        return ((rowZ & (m_size[2] - 1)) * m_size[1] + (rowY & (m_size[1] - 1))) * m_size[0];
    };
    const std::uint32_t right = row(y, z) + ((x + 1) & (m_size[0] - 1));
    gather(m_begin[right], m_begin[right + 1]);
    gatherRow(row(y + 1, z), x);
    for (const std::uint32_t rowY : {y - 1, y, y + 1})
        gatherRow(row(rowY, z + 1), x);
}

// The first `own` of what is gathered with all of it.
void TouchingPoints::compare(std::size_t own, float distanceSquared, std::vector<std::uint8_t>& touches) {
    const Places& g = m_gathered;
    const std::size_t count = m_gatheredCount;
    const float* const x = g.x.data();
    const float* const y = g.y.data();
    const float* const z = g.z.data();
    std::int32_t* const isNear = m_isNear.data();
    for (std::size_t i = 0; i < own; ++i) {
        std::int32_t any = 0;
        for (std::size_t j = i + 1; j < count; ++j) {
            const float dx = x[j] - x[i];
            const float dy = y[j] - y[i];
            const float dz = z[j] - z[i];
            isNear[j] = dx * dx + dy * dy + dz * dz < distanceSquared ? 1 : 0;
            any |= isNear[j];
        }
        for (std::size_t j = i + 1; any != 0 && j < count; ++j)
            if (isNear[j] != 0 && !joined(g.point[i], g.point[j])) {
                touches[std::size_t(g.point[i])] = 1;
                touches[std::size_t(g.point[j])] = 1;
            }
    }
}

void TouchingPoints::find(const PointArray& position, double distance, std::vector<std::uint8_t>& touches) {
    sort(position, distance);
    std::uint32_t cell = 0;
    for (std::uint32_t z = 0; z < m_size[2]; ++z)
        for (std::uint32_t y = 0; y < m_size[1]; ++y)
            for (std::uint32_t x = 0; x < m_size[0]; ++x, ++cell) {
                if (m_begin[cell] == m_begin[cell + 1])
                    continue;
                m_gatheredCount = 0;
                gather(m_begin[cell], m_begin[cell + 1]);
                const std::size_t own = m_gatheredCount;
                gatherAround(x, y, z);
                compare(own, float(distance * distance), touches);
            }
}

} // namespace clothlab
