#include "simcore/scene/scene.h"

#include <algorithm>
#include <tuple>

namespace clothlab {
namespace {

// What makes the rest shape and the start of a sheet.
auto startValues(const Scene& s) {
    const Cloth& c = s.cloth;
    return std::tuple(c.width, c.height, c.numWidthPoints, c.numHeightPoints, c.orientation,
                      s.simulation.seed);
}

// What else moves the sheet. Unknown keys are not among it: this version cannot act on them.
auto motionValues(const Cloth& c) {
    return std::tie(c.thickness, c.damping, c.density, c.ks, c.enableStructural, c.enableShearing,
                    c.enableBending, c.pinned);
}

bool sameMotion(const Sphere& a, const Sphere& b) {
    return a.origin == b.origin && a.radius == b.radius && a.friction == b.friction;
}

bool sameMotion(const Plane& a, const Plane& b) {
    return a.point == b.point && a.normal == b.normal && a.friction == b.friction;
}

bool sameMotion(const SimulationSettings& a, const SimulationSettings& b) {
    return a.gravity == b.gravity && a.framesPerSecond == b.framesPerSecond &&
           a.stepsPerFrame == b.stepsPerFrame;
}

template <typename Collider>
bool sameMotion(const std::vector<Collider>& a, const std::vector<Collider>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Collider& x, const Collider& y) { return sameMotion(x, y); });
}

bool sameMotion(const Scene& a, const Scene& b) {
    return motionValues(a.cloth) == motionValues(b.cloth) && sameMotion(a.spheres, b.spheres) &&
           sameMotion(a.planes, b.planes) && sameMotion(a.simulation, b.simulation);
}

} // namespace

bool Cloth::enabled(SpringType type) const {
    switch (type) {
    case SpringType::Structural:
        return enableStructural;
    case SpringType::Shearing:
        return enableShearing;
    case SpringType::Bending:
        return enableBending;
    }
    return false;
}

bool operator==(const Sphere& a, const Sphere& b) {
    return sameMotion(a, b) && a.unknownKeys == b.unknownKeys;
}

bool operator==(const Plane& a, const Plane& b) {
    return sameMotion(a, b) && a.unknownKeys == b.unknownKeys;
}

bool operator==(const SimulationSettings& a, const SimulationSettings& b) {
    return sameMotion(a, b) && a.seed == b.seed && a.unknownKeys == b.unknownKeys;
}

bool operator==(const CameraView& a, const CameraView& b) {
    return a.target == b.target && a.distance == b.distance && a.azimuth == b.azimuth &&
           a.elevation == b.elevation && a.unknownKeys == b.unknownKeys;
}

SceneChange compareScenes(const Scene& before, const Scene& after) {
    if (startValues(before) != startValues(after))
        return SceneChange::Start;
    if (!sameMotion(before, after))
        return SceneChange::Motion;
    return before == after ? SceneChange::None : SceneChange::Appearance;
}

} // namespace clothlab
