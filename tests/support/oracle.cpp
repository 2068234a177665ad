#include "tests/support/oracle.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace clothlab::oracle {
namespace {

struct CellIndex {
    std::int64_t x, y, z;
    friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

struct CellHash {
    std::size_t operator()(const CellIndex& c) const {
        std::uint64_t h = std::uint64_t(c.x);
        h = h * 0x9E3779B97F4A7C15U + std::uint64_t(c.y);
        h = h * 0x9E3779B97F4A7C15U + std::uint64_t(c.z);
        return std::size_t(h ^ (h >> 29U));
    }
};

using CellMap = std::unordered_map<CellIndex, std::vector<int>, CellHash>;

double lengthSquared(const Vec3& v) {
    return v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
}

// Adds what the pair asks of the first point, if it is near enough.
void partFrom(const Vec3& point, const Vec3& other, double distance, Correction& correction) {
    const Vec3 apart = point - other;
    if (lengthSquared(apart) == 0 || lengthSquared(apart) >= distance * distance)
        return;
    const double length = std::sqrt(lengthSquared(apart));
    correction.vector += (distance - length) / length * apart;
    ++correction.neighbours;
}

void takeMean(Correction& correction, double share) {
    if (correction.neighbours > 0)
        correction.vector *= share / correction.neighbours;
}

} // namespace

std::vector<Correction> selfCollisionAllPairs(const std::vector<PointMass>& points, double distance,
                                              double share) {
    std::vector<Correction> corrections(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].pinned)
            continue;
        for (std::size_t j = 0; j < points.size(); ++j)
            if (i != j)
                partFrom(points[i].position, points[j].position, distance, corrections[i]);
        takeMean(corrections[i], share);
    }
    return corrections;
}

std::vector<Correction> selfCollisionHashed(const std::vector<PointMass>& points, double distance,
                                            double share) {
    // Twice the reach, so that what is within it lies in two cells at most along each axis.
    const double cellSize = 2 * distance;
    const auto cellOf = [&](const Vec3& p) {
        return CellIndex{std::int64_t(std::floor(p.x() / cellSize)),
                         std::int64_t(std::floor(p.y() / cellSize)),
                         std::int64_t(std::floor(p.z() / cellSize))};
    };
    CellMap map;
    map.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        map[cellOf(points[i].position)].push_back(int(i));

    // A little more than the reach, so that no rounding puts a point within it into a cell not looked at.
    const Vec3 reach = Vec3::Constant(1.01 * distance);
    std::vector<Correction> corrections(points.size());
    std::vector<int> near;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].pinned)
            continue;
        near.clear();
        const CellIndex low = cellOf(points[i].position - reach), high = cellOf(points[i].position + reach);
        for (std::int64_t x = low.x; x <= high.x; ++x)
            for (std::int64_t y = low.y; y <= high.y; ++y)
                for (std::int64_t z = low.z; z <= high.z; ++z)
                    if (const auto found = map.find({x, y, z}); found != map.end())
                        for (const int j : found->second)
                            if (j != int(i) &&
                                lengthSquared(points[i].position - points[std::size_t(j)].position) <
                                    distance * distance)
                                near.push_back(j);
        std::sort(near.begin(), near.end());
        for (const int j : near)
            partFrom(points[i].position, points[std::size_t(j)].position, distance, corrections[i]);
        takeMean(corrections[i], share);
    }
    return corrections;
}

void Cloth::step() {
    computeForces();
    moveByVerlet();
    moveApart();
    for (const Sphere& sphere : m_scene.spheres)
        collideWithSphere(sphere);
    for (const Plane& plane : m_scene.planes)
        collideWithPlane(plane);
    limitStrain();
}

bool Cloth::enabled(SpringType type) const {
    switch (type) {
    case SpringType::Structural:
        return m_scene.cloth.enableStructural;
    case SpringType::Shearing:
        return m_scene.cloth.enableShearing;
    case SpringType::Bending:
        return m_scene.cloth.enableBending;
    }
    return false;
}

void Cloth::computeForces() {
    for (PointMass& p : points)
        p.force = m_pointMass * m_scene.simulation.gravity;
    for (const Spring& s : springs) {
        if (!enabled(s.type))
            continue;
        PointMass& a = points[std::size_t(s.a)];
        PointMass& b = points[std::size_t(s.b)];
        const Vec3 ab = b.position - a.position;
        const double length = std::sqrt(lengthSquared(ab));
        if (length == 0)
            continue; // no direction to pull in
        const Vec3 force = s.stiffness * (length - s.restLength) / length * ab;
        a.force += force;
        b.force -= force;
    }
}

void Cloth::moveByVerlet() {
    const SimulationSettings& settings = m_scene.simulation;
    const double dt = 1.0 / (double(settings.framesPerSecond) * double(settings.stepsPerFrame));
    const double kept = 1 - m_scene.cloth.damping / 100;
    for (PointMass& p : points) {
        if (p.pinned)
            continue;
        const Vec3 next = p.position + kept * (p.position - p.lastPosition) + dt * dt / m_pointMass * p.force;
        p.lastPosition = p.position;
        p.position = next;
    }
}

void Cloth::moveApart() {
    const double distance = 2 * m_scene.cloth.thickness;
    if (distance <= 0)
        return;
    const std::vector<Correction> corrections =
        selfCollisionHashed(points, distance, 1.0 / m_scene.simulation.stepsPerFrame);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].position += corrections[i].vector;
        counts.selfCollisions += corrections[i].neighbours > 0 ? 1 : 0;
    }
}

void Cloth::collideWithSphere(const Sphere& sphere) {
    for (PointMass& p : points) {
        const Vec3 out = p.position - sphere.origin;
        if (p.pinned || out.squaredNorm() >= sphere.radius * sphere.radius)
            continue;
        const double distance = out.norm();
        const Vec3 direction = distance == 0 ? Vec3(0, 1, 0) : Vec3(out / distance);
        const Vec3 tangent = sphere.origin + sphere.radius * direction;
        p.position = p.lastPosition + (1 - sphere.friction) * (tangent - p.lastPosition);
        ++counts.sphereContacts;
    }
}

void Cloth::collideWithPlane(const Plane& plane) {
    const double kAbove = 0.0001;
    const Vec3 normal = plane.normal.stableNormalized();
    for (PointMass& p : points) {
        const double height = normal.dot(p.position - plane.point);
        const double lastHeight = normal.dot(p.lastPosition - plane.point);
        // On the plane counts as above, at either time.
        const bool cameFromAbove = lastHeight >= 0;
        const bool crossed = cameFromAbove ? height < 0 : height >= 0;
        if (p.pinned || !crossed)
            continue;
        const double target = cameFromAbove ? kAbove : -kAbove;
        const Vec3 tangent = p.position + (target - height) * normal;
        p.position = p.lastPosition + (1 - plane.friction) * (tangent - p.lastPosition);
        ++counts.planeContacts;
    }
}

void Cloth::limitStrain() {
    for (const Spring& s : springs) {
        PointMass& a = points[std::size_t(s.a)];
        PointMass& b = points[std::size_t(s.b)];
        if (!enabled(s.type) || (a.pinned && b.pinned))
            continue;
        const Vec3 ab = b.position - a.position;
        const double limit = 1.1 * s.restLength;
        if (ab.squaredNorm() <= limit * limit)
            continue;
        const double length = ab.norm();
        const Vec3 excess = (length - limit) / length * ab;
        const double shareOfA = a.pinned ? 0 : b.pinned ? 1 : 0.5;
        a.position += shareOfA * excess;
        b.position -= (1 - shareOfA) * excess;
        ++counts.strainLimits;
    }
}

} // namespace clothlab::oracle
