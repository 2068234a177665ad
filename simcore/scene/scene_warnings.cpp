// What is likely a mistake although it can be simulated.
#include "simcore/scene/json_text.h"
#include "simcore/scene/scene_checks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace clothlab {
namespace {

// The sheet at its start, without the unevenness of a vertical one.
struct StartRectangle {
    Vec3 corner;
    Vec3 across; // unit vector along a row of points
    Vec3 down;   // unit vector along a column
    double width;
    double height;
    double dx; // m between neighbours
    double dy;

    explicit StartRectangle(const Cloth& cloth)
        : corner(0, cloth.orientation == Orientation::Horizontal ? 1 : 0, 0), across(1, 0, 0),
          down(cloth.orientation == Orientation::Horizontal ? Vec3(0, 0, 1) : Vec3(0, 1, 0)),
          width(cloth.width), height(cloth.height), dx(cloth.width / (cloth.numWidthPoints - 1)),
          dy(cloth.height / (cloth.numHeightPoints - 1)) {}

    Vec3 at(double u, double v) const { return corner + u * across + v * down; }
    double u(const Vec3& p) const { return std::clamp((p - corner).dot(across), 0.0, width); }
    double v(const Vec3& p) const { return std::clamp((p - corner).dot(down), 0.0, height); }
    Vec3 nearest(const Vec3& p) const { return at(u(p), v(p)); }
    Vec3 nearestPointMass(const Vec3& p) const {
        return at(std::round(u(p) / dx) * dx, std::round(v(p) / dy) * dy);
    }
    std::array<Vec3, 4> corners() const { return {at(0, 0), at(width, 0), at(0, height), at(width, height)}; }
};

void warnOfPins(const Cloth& cloth, Report& report) {
    if (cloth.pinned.empty())
        return;
    std::vector<bool> seen(static_cast<std::size_t>(cloth.pointCount()));
    std::size_t distinct = 0;
    for (std::size_t i = 0; i < cloth.pinned.size(); ++i) {
        const GridPoint p = cloth.pinned[i];
        const auto index = static_cast<std::size_t>(p.y * cloth.numWidthPoints + p.x);
        distinct += seen[index] ? 0 : 1;
        if (seen[index] && distinct + 1 == i + 1) // once is enough
            report.warn("cloth.pinned[" + std::to_string(i) + "]",
                        "[" + std::to_string(p.x) + ", " + std::to_string(p.y) + "] is pinned twice",
                        "remove one of the two");
        seen[index] = true;
    }
    if (distinct == seen.size())
        report.warn("cloth.pinned", "all points are pinned, so nothing moves", "remove some of them");
}

void warnOfSprings(const Cloth& cloth, Report& report) {
    if (!cloth.enableStructural && !cloth.enableShearing && !cloth.enableBending)
        report.warn("cloth", "has no springs, so it falls apart into points", "enable a type of springs");
}

void warnOfThickness(const Cloth& cloth, const StartRectangle& start, Report& report) {
    const double spacing = std::min(start.dx, start.dy);
    if (2 * cloth.thickness > spacing)
        report.warn("cloth.thickness",
                    "twice the thickness is more than the " + json::numberText(spacing) +
                        " m between neighbours, so the sheet pushes itself apart",
                    "give less than " + json::numberText(spacing / 2) + ", or fewer points");
}

void warnOfOverlap(const Scene& scene, const StartRectangle& start, Report& report) {
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        if ((start.nearestPointMass(sphere.origin) - sphere.origin).norm() < sphere.radius)
            report.warn("sphere" + (scene.spheres.size() == 1 ? "" : "[" + std::to_string(i) + "]"),
                        "the sheet starts inside the sphere and is thrown out of it", "move the sphere");
    }
    constexpr double kTolerance = 1e-9; // m
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
        const Plane& plane = scene.planes[i];
        double lowest = 0;
        double highest = 0;
        for (const Vec3& corner : start.corners()) {
            const double height = (corner - plane.point).dot(plane.normal.normalized());
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
        if (lowest < -kTolerance && highest > kTolerance)
            report.warn("plane" + (scene.planes.size() == 1 ? "" : "[" + std::to_string(i) + "]"),
                        "the sheet starts on both sides of the plane, and each part stays on its side",
                        "move the plane");
    }
}

// Does the sheet, moved along the unit vector `fall`, meet the sphere? Alternates between the nearest place
// on the sheet and the nearest height of fall; both are convex, so it converges.
bool meets(const StartRectangle& start, const Vec3& fall, const Sphere& sphere) {
    double fallen = 0;
    for (int i = 0; i < 20; ++i) {
        const Vec3 place = start.nearest(sphere.origin - fallen * fall);
        if ((place + fallen * fall - sphere.origin).norm() < sphere.radius)
            return true;
        fallen = std::max(0.0, (sphere.origin - place).dot(fall));
    }
    return false;
}

bool meets(const StartRectangle& start, const Vec3& fall, const Plane& plane) {
    const double speed = plane.normal.dot(fall);
    const auto corners = start.corners();
    return std::any_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
        const double distance = plane.normal.dot(plane.point - corner);
        return speed != 0 && distance / speed >= 0;
    });
}

void warnOfFall(const Scene& scene, const StartRectangle& start, Report& report) {
    if (!scene.cloth.pinned.empty() || scene.simulation.gravity.norm() == 0)
        return;
    const Vec3 fall = scene.simulation.gravity.normalized();
    const auto stops = [&](const auto& collider) { return meets(start, fall, collider); };
    if (std::any_of(scene.planes.begin(), scene.planes.end(), stops) ||
        std::any_of(scene.spheres.begin(), scene.spheres.end(), stops))
        return;
    report.warn("cloth.pinned", "nothing holds the sheet and nothing is in its way, so it falls forever",
                "pin some points, or put a sphere or a plane below");
}

} // namespace

void findWarnings(const Scene& scene, Report& report) {
    const StartRectangle start(scene.cloth);
    warnOfPins(scene.cloth, report);
    warnOfSprings(scene.cloth, report);
    warnOfThickness(scene.cloth, start, report);
    warnOfOverlap(scene, start, report);
    warnOfFall(scene, start, report);
}

} // namespace clothlab
