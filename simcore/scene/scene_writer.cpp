// Text from a scene, in the order and to the letter of the course's files where those can say it.
#include "simcore/scene/json_text.h"
#include "simcore/scene/scene_io.h"

#include <utility>

namespace clothlab {
namespace {

using json::numberText;

// The members of an object and the elements of a list are made before what holds them, so each is told how
// deep it will stand.
struct Entry {
    std::string key; // with quotes
    std::string value;
};
using Entries = std::vector<Entry>;

std::string newLine(int level) {
    return "\n" + std::string(static_cast<std::size_t>(2 * level), ' ');
}

std::string object(const Entries& entries, int level) {
    std::string text = "{";
    for (const Entry& entry : entries) {
        text += text.size() > 1 ? "," : "";
        text += newLine(level + 1) + entry.key + ": " + entry.value;
    }
    return text + newLine(level) + "}";
}

std::string list(const std::vector<std::string>& elements, int level) {
    std::string text = "[";
    for (const std::string& element : elements) {
        text += text.size() > 1 ? "," : "";
        text += newLine(level + 1) + element;
    }
    return text + (elements.empty() ? "" : newLine(level)) + "]";
}

void add(Entries& entries, std::string_view key, std::string value) {
    entries.push_back({json::quoted(key), std::move(value)});
}

std::string flag(bool value) {
    return value ? "true" : "false";
}

std::string triple(double a, double b, double c) {
    return "[" + numberText(a) + ", " + numberText(b) + ", " + numberText(c) + "]";
}

std::string triple(const Vec3& v) {
    return triple(v.x(), v.y(), v.z());
}

// On one line each: indenting what is nested could make a file many times longer.
void addUnknown(Entries& entries, const std::string& unknownKeys) {
    if (unknownKeys.empty())
        return;
    for (const json::Member& member : json::members(json::parse(unknownKeys)))
        entries.push_back({std::string(member.keyText), json::spaced(member.value.text)});
}

Entries entriesOf(const Cloth& cloth) {
    std::vector<std::string> pinned;
    pinned.reserve(cloth.pinned.size());
    for (const GridPoint p : cloth.pinned)
        pinned.push_back("[" + std::to_string(p.x) + ", " + std::to_string(p.y) + "]");

    Entries entries;
    add(entries, "damping", numberText(cloth.damping));
    add(entries, "density", numberText(cloth.density));
    add(entries, "ks", numberText(cloth.ks));
    add(entries, "enable_structural", flag(cloth.enableStructural));
    add(entries, "enable_shearing", flag(cloth.enableShearing));
    add(entries, "enable_bending", flag(cloth.enableBending));
    add(entries, "orientation", std::to_string(static_cast<int>(cloth.orientation)));
    add(entries, "width", numberText(cloth.width));
    add(entries, "height", numberText(cloth.height));
    add(entries, "num_width_points", std::to_string(cloth.numWidthPoints));
    add(entries, "num_height_points", std::to_string(cloth.numHeightPoints));
    add(entries, "thickness", numberText(cloth.thickness));
    add(entries, "pinned", list(pinned, 2));
    addUnknown(entries, cloth.unknownKeys);
    return entries;
}

Entries entriesOf(const Sphere& sphere) {
    Entries entries;
    add(entries, "origin", triple(sphere.origin));
    add(entries, "radius", numberText(sphere.radius));
    add(entries, "friction", numberText(sphere.friction));
    addUnknown(entries, sphere.unknownKeys);
    return entries;
}

Entries entriesOf(const Plane& plane) {
    Entries entries;
    add(entries, "point", triple(plane.point));
    add(entries, "normal", triple(plane.normal));
    add(entries, "friction", numberText(plane.friction));
    addUnknown(entries, plane.unknownKeys);
    return entries;
}

Entries entriesOf(const SimulationSettings& simulation) {
    const SimulationSettings byDefault;
    Entries entries;
    if (simulation.gravity != byDefault.gravity)
        add(entries, "gravity", triple(simulation.gravity));
    if (simulation.framesPerSecond != byDefault.framesPerSecond)
        add(entries, "frames_per_second", std::to_string(simulation.framesPerSecond));
    if (simulation.stepsPerFrame != byDefault.stepsPerFrame)
        add(entries, "steps_per_frame", std::to_string(simulation.stepsPerFrame));
    if (simulation.seed != byDefault.seed)
        add(entries, "seed", std::to_string(simulation.seed));
    addUnknown(entries, simulation.unknownKeys);
    return entries;
}

Entries springsDrawn(const Appearance& appearance) {
    const Appearance byDefault;
    Entries entries;
    if (appearance.springsDrawn != byDefault.springsDrawn) {
        add(entries, "structural", flag(appearance.springsDrawn[0]));
        add(entries, "shearing", flag(appearance.springsDrawn[1]));
        add(entries, "bending", flag(appearance.springsDrawn[2]));
    }
    addUnknown(entries, appearance.unknownSpringKeys);
    return entries;
}

Entries entriesOf(const Appearance& appearance) {
    const Appearance byDefault;
    Entries entries;
    if (appearance.shader != byDefault.shader)
        add(entries, "shader", json::quoted(appearance.shader));
    if (appearance.color != byDefault.color)
        add(entries, "color", triple(appearance.color[0], appearance.color[1], appearance.color[2]));
    if (const Entries springs = springsDrawn(appearance); !springs.empty())
        add(entries, "springs_drawn", object(springs, 2));
    if (appearance.springsOverSurface != byDefault.springsOverSurface)
        add(entries, "springs_over_surface", flag(appearance.springsOverSurface));
    addUnknown(entries, appearance.unknownKeys);
    return entries;
}

Entries entriesOf(const CameraView& camera) {
    Entries entries;
    add(entries, "target", triple(camera.target));
    add(entries, "distance", numberText(camera.distance));
    add(entries, "azimuth", numberText(camera.azimuth));
    add(entries, "elevation", numberText(camera.elevation));
    addUnknown(entries, camera.unknownKeys);
    return entries;
}

void addIfAny(Entries& entries, std::string_view key, const Entries& members) {
    if (!members.empty())
        add(entries, key, object(members, 1));
}

// One as an object, as the course's files have it; several as a list.
template <typename Collider>
void addColliders(Entries& entries, std::string_view key, const std::vector<Collider>& colliders) {
    if (colliders.size() == 1)
        return add(entries, key, object(entriesOf(colliders.front()), 1));
    std::vector<std::string> elements;
    elements.reserve(colliders.size());
    for (const Collider& collider : colliders)
        elements.push_back(object(entriesOf(collider), 2));
    if (!elements.empty())
        add(entries, key, list(elements, 1));
}

} // namespace

std::string writeScene(const Scene& scene) {
    Entries entries;
    add(entries, "cloth", object(entriesOf(scene.cloth), 1));
    addColliders(entries, "sphere", scene.spheres);
    addColliders(entries, "plane", scene.planes);
    addIfAny(entries, "simulation", entriesOf(scene.simulation));
    addIfAny(entries, "appearance", entriesOf(scene.appearance));
    if (scene.camera)
        add(entries, "camera", object(entriesOf(*scene.camera), 1));
    addUnknown(entries, scene.unknownKeys);
    return object(entries, 0) + "\n";
}

} // namespace clothlab
