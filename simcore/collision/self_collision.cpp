#include "simcore/collision/self_collision.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace clothlab {
namespace {

constexpr double kSkin = 0.5; // as a share of the distance
// On average a point. A sheet that crowds more is looked through without lists, which would take too much
// memory.
constexpr std::size_t kMostNeighbours = 128;

// Adds up what one point's neighbours ask of it.
class Correction {
public:
    Correction(const PointArray& position, std::size_t point, double distance)
        : m_position(position), m_point(point), m_distance(distance) {}

    void add(std::size_t other) {
        const double dx = m_position.x[m_point] - m_position.x[other];
        const double dy = m_position.y[m_point] - m_position.y[other];
        const double dz = m_position.z[m_point] - m_position.z[other];
        const double lengthSquared = dx * dx + dy * dy + dz * dz;
        if (!(lengthSquared < m_distance * m_distance) || lengthSquared <= 0)
            return;
        const double length = std::sqrt(lengthSquared);
        const double push = (m_distance - length) / length;
        m_x += push * dx;
        m_y += push * dy;
        m_z += push * dz;
        ++m_count;
    }

    bool store(double share, PointArray& correction) const {
        const double scale = m_count > 0 ? share / m_count : 0;
        correction.x[m_point] = m_x * scale;
        correction.y[m_point] = m_y * scale;
        correction.z[m_point] = m_z * scale;
        return m_count > 0;
    }

private:
    const PointArray& m_position;
    std::size_t m_point;
    double m_distance;
    double m_x = 0, m_y = 0, m_z = 0;
    int m_count = 0;
};

// Clamping keeps places that no integer can hold apart by at most the cells they were apart.
std::int64_t cellCoordinate(double coordinate, double cellSize) {
    constexpr double limit = 1e15;
    return static_cast<std::int64_t>(std::floor(std::clamp(coordinate / cellSize, -limit, limit)));
}

} // namespace

void selfCollisionBruteForce(const PointArray& position, const std::vector<std::uint8_t>& pinned,
                             double distance, double share, PointArray& correction) {
    for (std::size_t i = 0; i < position.size(); ++i) {
        Correction sum(position, i, distance);
        for (std::size_t j = 0; j < position.size() && !pinned[i]; ++j)
            if (j != i)
                sum.add(j);
        sum.store(share, correction);
    }
}

std::size_t SelfCollision::bucket(const Cell& cell) const {
    // Large primes of Teschner et al.; the multiplication at the end mixes high bits into the low ones.
    const std::uint64_t mixed = (std::uint64_t(cell.x) * 73856093U) ^ (std::uint64_t(cell.y) * 19349663U) ^
                                (std::uint64_t(cell.z) * 83492791U);
    return ((mixed * 0x9E3779B97F4A7C15U) >> 32U) & (m_begin.size() - 2);
}

// Counting sort of the points by bucket.
void SelfCollision::sortIntoCells(const PointArray& position, double cellSize) {
    const std::size_t n = position.size();
    m_begin.assign(std::bit_ceil(2 * n + 2) + 1, 0);
    m_cells.resize(n);
    m_points.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        m_cells[i] = {cellCoordinate(position.x[i], cellSize), cellCoordinate(position.y[i], cellSize),
                      cellCoordinate(position.z[i], cellSize)};
        ++m_begin[bucket(m_cells[i])];
    }
    std::uint32_t end = 0;
    for (std::uint32_t& begin : m_begin)
        begin = end += begin;
    for (std::size_t i = n; i-- > 0;)
        m_points[--m_begin[bucket(m_cells[i])]] = std::uint32_t(i);
}

void SelfCollision::appendNeighbours(const PointArray& position, int point, double reach) {
    const Cell centre = m_cells[std::size_t(point)];
    const Vec3 p = position.at(point);
    const auto first = std::ptrdiff_t(m_neighbours.size());
    for (std::int64_t x = centre.x - 1; x <= centre.x + 1; ++x)
        for (std::int64_t y = centre.y - 1; y <= centre.y + 1; ++y)
            for (std::int64_t z = centre.z - 1; z <= centre.z + 1; ++z) {
                const Cell cell{x, y, z};
                const std::size_t b = bucket(cell);
                for (std::uint32_t k = m_begin[b]; k < m_begin[b + 1]; ++k) {
                    const std::uint32_t j = m_points[k];
                    // A bucket may hold points of other cells; each cell is looked at once.
                    if (int(j) != point && m_cells[j] == cell &&
                        (p - position.at(int(j))).squaredNorm() < reach * reach)
                        m_neighbours.push_back(j);
                }
            }
    std::sort(m_neighbours.begin() + first, m_neighbours.end());
}

void SelfCollision::makeLists(const PointArray& position, double distance) {
    const double reach = (1 + kSkin) * distance;
    // Cells a little wider than the reach: rounding in the division must not part two points within it.
    sortIntoCells(position, reach * (1 + 1e-9));
    m_distance = -1;
    m_neighbours.clear();
    m_listEnd.resize(position.size());
    for (std::size_t i = 0; i < position.size(); ++i) {
        appendNeighbours(position, int(i), reach);
        m_listEnd[i] = std::uint32_t(m_neighbours.size());
        if (m_neighbours.size() > kMostNeighbours * position.size())
            return;
    }
    m_listedAt = position;
    m_distance = distance;
}

// What all points have moved together brings none nearer to another, so a falling sheet keeps its lists.
bool SelfCollision::listsHold(const PointArray& position, double distance) const {
    const std::size_t n = position.size();
    if (distance != m_distance || m_listedAt.size() != n)
        return false;
    Vec3 together = Vec3::Zero();
    for (std::size_t i = 0; i < n; ++i) {
        together.x() += position.x[i] - m_listedAt.x[i];
        together.y() += position.y[i] - m_listedAt.y[i];
        together.z() += position.z[i] - m_listedAt.z[i];
    }
    together /= double(n);
    double farthestSquared = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double dx = position.x[i] - m_listedAt.x[i] - together.x();
        const double dy = position.y[i] - m_listedAt.y[i] - together.y();
        const double dz = position.z[i] - m_listedAt.z[i] - together.z();
        farthestSquared = std::max(farthestSquared, dx * dx + dy * dy + dz * dz);
    }
    // A little less than half the skin, for the rounding of these differences.
    const double slack = 0.499 * kSkin * distance - 1e-12 * together.norm();
    return slack > 0 && farthestSquared < slack * slack;
}

int SelfCollision::corrections(const PointArray& position, const std::vector<std::uint8_t>& pinned,
                               double distance, double share, PointArray& correction) {
    if (!listsHold(position, distance))
        makeLists(position, distance);
    const bool listed = m_distance >= 0;
    int corrected = 0;
    std::uint32_t begin = 0;
    for (std::size_t i = 0; i < position.size(); ++i) {
        Correction sum(position, i, distance);
        if (!listed) {
            m_neighbours.clear();
            appendNeighbours(position, int(i), distance);
        }
        const auto end = listed ? m_listEnd[i] : std::uint32_t(m_neighbours.size());
        for (std::uint32_t k = listed ? begin : 0; k < end && !pinned[i]; ++k)
            sum.add(m_neighbours[k]);
        begin = end;
        corrected += sum.store(share, correction) ? 1 : 0;
    }
    return corrected;
}

} // namespace clothlab
