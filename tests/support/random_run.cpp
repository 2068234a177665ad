#include "tests/support/random_run.h"
#include "tests/support/random.h"
#include "tests/support/states.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace clothlab {
namespace {

constexpr int kSteps = 300; // within which something has to happen

Vec3 randomVector(SplitMix64& random, double size) {
    const double x = random.real(-size, size);
    const double y = random.real(-size, size);
    return {x, y, random.real(-size, size)};
}

void chooseSettings(SplitMix64& random, SimulationSettings& settings) {
    settings.framesPerSecond = random.integer(40, 90);
    settings.stepsPerFrame = random.integer(8, 30);
    settings.seed = std::uint32_t(random.next());
    if (random.chance(0.4))
        settings.gravity += randomVector(random, 4);
}

void chooseSheet(SplitMix64& random, Trial trial, const SimulationSettings& settings, Cloth& cloth) {
    const bool small = random.chance(0.3) && trial != Trial::Thrown;
    const int least = trial == Trial::Thrown ? 12 : 2; // short springs, to be stretched too far
    cloth.numWidthPoints = random.integer(least, small ? 6 : 60);
    cloth.numHeightPoints = random.integer(least, small ? 6 : 40);
    if (cloth.numHeightPoints == cloth.numWidthPoints)
        ++cloth.numHeightPoints;
    cloth.width = random.real(0.3, 1.5);
    cloth.height = random.real(0.3, 1.5);
    cloth.orientation = random.chance(0.5) ? Orientation::Horizontal : Orientation::Vertical;
    cloth.damping = random.real(0, 1);
    cloth.density = random.real(20, 400);
    const double spacing =
        std::min(cloth.width / (cloth.numWidthPoints - 1), cloth.height / (cloth.numHeightPoints - 1));
    cloth.thickness = random.real(0.2, 0.47) * std::min(spacing, 0.1);

    // Eight springs of ks and four of ks/5 pull at a point, so its highest frequency squared is below
    // 17.6 ks/m; times dt² that must stay below 4.
    const double mass = cloth.width * cloth.height * cloth.density / cloth.pointCount();
    const double dt = settings.timeStep();
    cloth.ks = random.real(0.01, 0.1) * mass / (dt * dt);

    const int switchedOff = random.integer(0, 5); // three of these switch nothing off
    cloth.enableStructural = switchedOff != 0;
    cloth.enableShearing = switchedOff != 1;
    cloth.enableBending = switchedOff != 2;
}

void choosePins(SplitMix64& random, Cloth& cloth, int atLeast, int atMost) {
    const int count = random.integer(atLeast, atMost);
    for (int i = 0; i < count; ++i) {
        const int x = random.integer(0, cloth.numWidthPoints - 1);
        const GridPoint p{x, random.integer(0, cloth.numHeightPoints - 1)};
        if (std::find(cloth.pinned.begin(), cloth.pinned.end(), p) == cloth.pinned.end())
            cloth.pinned.push_back(p);
    }
}

// How far the sheet gets on its way with this speed, so that a collider can stand in it.
double reach(const Scene& scene, double speed) {
    const double duration = kSteps * scene.simulation.timeStep();
    return speed * duration + scene.simulation.gravity.norm() * duration * duration / 2;
}

double farthestAlong(const PointArray& points, const Vec3& direction) {
    double farthest = -INFINITY;
    for (int i = 0; i < int(points.size()); ++i)
        farthest = std::max(farthest, direction.dot(points.at(i)));
    return farthest;
}

// Under a random point of the sheet, on its way, with no point inside at the start.
Sphere sphereInTheWay(SplitMix64& random, const PointArray& points, const Vec3& way, double distance) {
    Sphere sphere;
    sphere.radius = random.real(0.1, 0.4);
    sphere.friction = random.chance(0.2) ? 0 : random.real(0, 1);
    const Vec3 target = points.at(random.integer(0, int(points.size()) - 1));
    sphere.origin = target + way * (farthestAlong(points, way) - way.dot(target));
    sphere.origin += way * (std::sqrt(3) / 2 * sphere.radius + 0.2 * distance);
    const auto inside = [&] {
        for (int i = 0; i < int(points.size()); ++i)
            if ((points.at(i) - sphere.origin).norm() < sphere.radius + 0.1 * distance)
                return true;
        return false;
    };
    while (inside())
        sphere.origin += way * 0.02 * sphere.radius;
    return sphere;
}

Plane planeInTheWay(SplitMix64& random, const PointArray& points, const Vec3& way, double distance) {
    Plane plane;
    plane.normal = random.chance(0.5) ? Vec3(-way) : way; // the sheet comes from either side
    plane.normal *= random.real(0.2, 3);
    plane.friction = random.chance(0.2) ? 0 : random.real(0, 1);
    plane.point = way * (farthestAlong(points, way) + random.real(0.05, 0.4) * distance);
    return plane;
}

void roughen(SplitMix64& random, double size, PointArray& points) {
    for (int i = 0; i < int(points.size()); ++i)
        points.set(i, points.at(i) + randomVector(random, size));
}

} // namespace

std::string_view name(Trial trial) {
    constexpr std::string_view kNames[kTrials] = {"hanging", "on a sphere", "on a plane", "folded", "thrown"};
    return kNames[int(trial)];
}

std::string RandomRun::describe() const {
    std::ostringstream out;
    out << "seed " << seed << ": " << name(trial) << ", " << scene.cloth.numWidthPoints << " x "
        << scene.cloth.numHeightPoints << ", " << scene.cloth.pinned.size() << " pinned, "
        << scene.spheres.size() << " spheres, " << scene.planes.size() << " planes, springs "
        << scene.cloth.enableStructural << scene.cloth.enableShearing << scene.cloth.enableBending;
    return out.str();
}

RandomRun randomRun(std::uint64_t seed) {
    SplitMix64 random(seed);
    RandomRun made;
    made.seed = seed;
    made.trial = Trial(seed % kTrials);
    Scene& scene = made.scene;
    chooseSettings(random, scene.simulation);
    chooseSheet(random, made.trial, scene.simulation, scene.cloth);
    const Trial trial = made.trial;
    if (trial == Trial::Hanging || trial == Trial::Thrown)
        choosePins(random, scene.cloth, 1, 6);
    made.start = startState(scene);
    if (trial == Trial::Folded) {
        foldSheet(scene, made.start, 1.1 * scene.cloth.thickness);
        roughen(random, 0.2 * scene.cloth.thickness, made.start.position);
        made.start.lastPosition = made.start.position;
    }
    const double speed = trial == Trial::Hanging || trial == Trial::Folded ? 0 : random.real(1, 3);
    const Vec3 way = (scene.simulation.gravity.normalized() + randomVector(random, 0.2)).normalized();
    if (trial == Trial::OnSphere || trial == Trial::Thrown)
        scene.spheres.push_back(sphereInTheWay(random, made.start.position, way, reach(scene, speed)));
    if (trial == Trial::OnPlane || trial == Trial::Folded)
        scene.planes.push_back(planeInTheWay(random, made.start.position, way, reach(scene, speed)));
    if (trial == Trial::OnPlane && random.chance(0.5))
        scene.spheres.push_back(sphereInTheWay(random, made.start.position, way, reach(scene, speed)));
    const double unevenness = trial == Trial::Thrown ? 0.5 * speed : 0.05 * speed;
    throwSheet(scene, made.start,
               [&](int, const Vec3&) { return Vec3(way * speed + randomVector(random, unevenness)); });
    return made;
}

} // namespace clothlab
