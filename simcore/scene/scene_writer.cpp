// Text from a scene, in the order and to the letter of the course's files where those can say it.
#include "simcore/scene/appearance_writer.h"
#include "simcore/scene/json_text.h"
#include "simcore/scene/object_writer.h"
#include "simcore/scene/scene_io.h"

namespace clothlab {
namespace {

using json::numberText;

Entries entriesOf(const Cloth& cloth) {
    std::vector<std::string> pinned;
    pinned.reserve(cloth.pinned.size());
    for (const GridPoint p : cloth.pinned)
        pinned.push_back("[" + std::to_string(p.x) + ", " + std::to_string(p.y) + "]");

    Entries entries;
    add(entries, "damping", numberText(cloth.damping));
    add(entries, "density", numberText(cloth.density));
    add(entries, "ks", numberText(cloth.ks));
    add(entries, "enable_structural", flagText(cloth.enableStructural));
    add(entries, "enable_shearing", flagText(cloth.enableShearing));
    add(entries, "enable_bending", flagText(cloth.enableBending));
    add(entries, "orientation", std::to_string(static_cast<int>(cloth.orientation)));
    add(entries, "width", numberText(cloth.width));
    add(entries, "height", numberText(cloth.height));
    add(entries, "num_width_points", std::to_string(cloth.numWidthPoints));
    add(entries, "num_height_points", std::to_string(cloth.numHeightPoints));
    add(entries, "thickness", numberText(cloth.thickness));
    add(entries, "pinned", listText(pinned, 2));
    addUnknown(entries, cloth.unknownKeys);
    return entries;
}

Entries entriesOf(const Sphere& sphere) {
    Entries entries;
    add(entries, "origin", tripleText(sphere.origin));
    add(entries, "radius", numberText(sphere.radius));
    add(entries, "friction", numberText(sphere.friction));
    addUnknown(entries, sphere.unknownKeys);
    return entries;
}

Entries entriesOf(const Plane& plane) {
    Entries entries;
    add(entries, "point", tripleText(plane.point));
    add(entries, "normal", tripleText(plane.normal));
    add(entries, "friction", numberText(plane.friction));
    addUnknown(entries, plane.unknownKeys);
    return entries;
}

Entries entriesOf(const SimulationSettings& simulation) {
    const SimulationSettings byDefault;
    Entries entries;
    if (simulation.gravity != byDefault.gravity)
        add(entries, "gravity", tripleText(simulation.gravity));
    if (simulation.framesPerSecond != byDefault.framesPerSecond)
        add(entries, "frames_per_second", std::to_string(simulation.framesPerSecond));
    if (simulation.stepsPerFrame != byDefault.stepsPerFrame)
        add(entries, "steps_per_frame", std::to_string(simulation.stepsPerFrame));
    if (simulation.seed != byDefault.seed)
        add(entries, "seed", std::to_string(simulation.seed));
    addUnknown(entries, simulation.unknownKeys);
    return entries;
}

Entries entriesOf(const CameraView& camera) {
    Entries entries;
    add(entries, "target", tripleText(camera.target));
    add(entries, "distance", numberText(camera.distance));
    add(entries, "azimuth", numberText(camera.azimuth));
    add(entries, "elevation", numberText(camera.elevation));
    addUnknown(entries, camera.unknownKeys);
    return entries;
}

void addIfAny(Entries& entries, std::string_view key, const Entries& members) {
    if (!members.empty())
        add(entries, key, objectText(members, 1));
}

// One as an object, as the course's files have it; several as a list.
template <typename Collider>
void addColliders(Entries& entries, std::string_view key, const std::vector<Collider>& colliders) {
    if (colliders.size() == 1)
        return add(entries, key, objectText(entriesOf(colliders.front()), 1));
    std::vector<std::string> elements;
    elements.reserve(colliders.size());
    for (const Collider& collider : colliders)
        elements.push_back(objectText(entriesOf(collider), 2));
    if (!elements.empty())
        add(entries, key, listText(elements, 1));
}

} // namespace

std::string writeScene(const Scene& scene) {
    Entries entries;
    add(entries, "cloth", objectText(entriesOf(scene.cloth), 1));
    addColliders(entries, "sphere", scene.spheres);
    addColliders(entries, "plane", scene.planes);
    addIfAny(entries, "simulation", entriesOf(scene.simulation));
    addIfAny(entries, "appearance", appearanceEntries(scene.appearance));
    if (scene.camera)
        add(entries, "camera", objectText(entriesOf(*scene.camera), 1));
    addUnknown(entries, scene.unknownKeys);
    return objectText(entries, 0) + "\n";
}

} // namespace clothlab
