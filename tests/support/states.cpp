#include "tests/support/states.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clothlab {
namespace {

double distanceOrInfinity(const Vec3& a, const Vec3& b) {
    const double d = (a - b).norm();
    return std::isfinite(d) ? d : std::numeric_limits<double>::infinity();
}

} // namespace

double greatestDistance(const PointArray& a, const PointArray& b) {
    double greatest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
    for (int i = 0; i < int(std::min(a.size(), b.size())); ++i)
        greatest = std::max(greatest, distanceOrInfinity(a.at(i), b.at(i)));
    return greatest;
}

double greatestDistance(const PointArray& a, const std::vector<oracle::PointMass>& b) {
    double greatest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        greatest = std::max(greatest, distanceOrInfinity(a.at(int(i)), b[i].position));
    return greatest;
}

void throwSheet(const Scene& scene, ClothState& state, const VelocityField& velocity) {
    const std::vector<std::uint8_t> pinned = pinnedMask(scene.cloth);
    const double dt = scene.simulation.timeStep();
    for (int i = 0; i < int(state.size()); ++i) {
        const Vec3 position = state.position.at(i);
        const Vec3 v = pinned[std::size_t(i)] ? Vec3(0, 0, 0) : velocity(i, position);
        state.lastPosition.set(i, position - v * dt);
    }
}

void throwSheet(const Scene& scene, ClothState& state, const Vec3& velocity) {
    throwSheet(scene, state, [&](int, const Vec3&) { return velocity; });
}

void foldSheet(const Scene& scene, ClothState& state, double gap) {
    const double middle = scene.cloth.width / 2;
    const bool horizontal = scene.cloth.orientation == Orientation::Horizontal;
    const Vec3 aside = horizontal ? Vec3(0, gap, 0) : Vec3(0, 0, gap);
    for (int i = 0; i < int(state.size()); ++i) {
        Vec3 p = state.position.at(i);
        if (p.x() > middle)
            p = Vec3(2 * middle - p.x(), p.y(), p.z()) + aside;
        state.position.set(i, p);
    }
    state.lastPosition = state.position;
}

void copyState(const ClothState& from, std::vector<oracle::PointMass>& to) {
    for (int i = 0; i < int(from.size()); ++i) {
        to[std::size_t(i)].position = from.position.at(i);
        to[std::size_t(i)].lastPosition = from.lastPosition.at(i);
    }
}

ClothState mapState(const ClothState& state, const std::function<Vec3(const Vec3&)>& map) {
    ClothState mapped = state;
    for (int i = 0; i < int(state.size()); ++i) {
        mapped.position.set(i, map(state.position.at(i)));
        mapped.lastPosition.set(i, map(state.lastPosition.at(i)));
    }
    return mapped;
}

std::vector<oracle::PointMass> toPointMasses(const PointArray& positions,
                                             const std::vector<std::uint8_t>& pinned) {
    std::vector<oracle::PointMass> points(positions.size());
    for (int i = 0; i < int(positions.size()); ++i) {
        points[std::size_t(i)].position = positions.at(i);
        points[std::size_t(i)].lastPosition = positions.at(i);
        points[std::size_t(i)].pinned = pinned[std::size_t(i)] != 0;
    }
    return points;
}

} // namespace clothlab
