// Scene from text: which key of which object means what.
#include "simcore/scene/appearance_reader.h"
#include "simcore/scene/json_check.h"
#include "simcore/scene/object_reader.h"
#include "simcore/scene/scene_checks.h"
#include "simcore/scene/scene_io.h"

#include <exception>

namespace clothlab {
namespace {

class SceneReader {
public:
    SceneReading read(std::string_view text) {
        if (auto fault = json::checkJson(text))
            return {std::nullopt, {std::move(*fault)}};
        readScene(ValueReader(json::parse(text), "", m_report));
        if (m_report.errors() == 0)
            findErrors(m_scene, m_report);
        if (m_report.errors() == 0)
            findWarnings(m_scene, m_report);
        const bool valid = m_report.errors() == 0;
        SceneReading reading{std::nullopt, m_report.take()};
        if (valid)
            reading.scene = std::move(m_scene);
        return reading;
    }

private:
    void readScene(const ValueReader& value);
    void readCloth(const ValueReader& value);
    void readPinned(const ValueReader& value);
    void readClothParameter(const ObjectReader& object, const Parameter& parameter);
    void readSphere(const ValueReader& value);
    void readPlane(const ValueReader& value);
    void readSimulation(const ValueReader& value);
    void readGravity(const ValueReader& value);
    void readCamera(const ValueReader& value);

    // One object, or a list of objects.
    template <typename Read>
    void readEach(const ValueReader& value, Read read) {
        if (value.type() != json::Type::Array)
            return read(value);
        json::Elements elements(value.value());
        std::size_t index = 0;
        while (const auto next = elements.next()) {
            // One too many is read, for the checks to find.
            if (m_report.full() || index > kMaxColliders)
                return;
            read(value.element(*next, index++));
        }
    }

    Scene m_scene;
    Report m_report;
};

void SceneReader::readScene(const ValueReader& value) {
    const ObjectReader object(value, kSceneKeys, m_report);
    if (m_report.errors() > 0)
        return;
    if (const auto cloth = object.require("cloth", "a cloth; without one there is nothing to simulate"))
        readCloth(*cloth);
    if (const auto sphere = object.find("sphere"))
        readEach(*sphere, [this](const ValueReader& v) { readSphere(v); });
    if (const auto plane = object.find("plane"))
        readEach(*plane, [this](const ValueReader& v) { readPlane(v); });
    if (const auto simulation = object.find("simulation"))
        readSimulation(*simulation);
    if (const auto appearance = object.find("appearance"))
        readAppearance(*appearance, m_scene, m_report);
    if (const auto camera = object.find("camera"))
        readCamera(*camera);
    m_scene.unknownKeys = object.unknownKeys();
}

std::optional<ValueReader> onlyElement(const ValueReader& list) {
    json::Elements elements(list.value());
    const auto first = elements.next();
    if (!first) {
        list.error("holds no cloth", "give one cloth");
        return std::nullopt;
    }
    if (elements.next()) {
        list.error("holds more than one cloth; this version simulates one sheet", "keep one of them");
        return std::nullopt;
    }
    return list.element(*first, 0);
}

void SceneReader::readCloth(const ValueReader& value) {
    const auto cloth = value.type() == json::Type::Array ? onlyElement(value) : value;
    if (!cloth)
        return;
    const ObjectReader object(*cloth, kClothKeys, m_report);
    for (const Parameter& parameter : parameters()) {
        if (parameter.object() == "cloth")
            readClothParameter(object, parameter);
    }
    if (const auto pinned = object.expect("pinned", "empty"))
        readPinned(*pinned);
    m_scene.cloth.unknownKeys = object.unknownKeys();
}

void SceneReader::readClothParameter(const ObjectReader& object, const Parameter& parameter) {
    // The table calls it a boolean, the course's files number it.
    const bool isFlag = parameter.kind == Parameter::Kind::Boolean && parameter.key() != "orientation";
    const double byDefault = parameter.defaultValue();
    const auto value = object.expect(parameter.key(), isFlag ? (byDefault != 0 ? "true" : "false")
                                                             : json::numberText(byDefault));
    if (!value)
        return;
    if (isFlag)
        parameter.set(m_scene, value->boolean().value_or(false) ? 1 : 0);
    else if (const auto number = value->number(rangeOf(parameter)))
        parameter.set(m_scene, *number);
}

void SceneReader::readPinned(const ValueReader& value) {
    if (!value.require(json::Type::Array, "a list of points of the grid, like [[0, 0], [49, 0]]"))
        return;
    json::Elements elements(value.value());
    auto& pinned = m_scene.cloth.pinned;
    while (const auto next = elements.next()) {
        auto point = toGridPoint(*next); // without words at first: there may be millions
        if (!point)
            point = value.element(*next, pinned.size()).gridPoint();
        if (!point) // the others are likely wrong in the same way
            return;
        pinned.push_back(*point);
    }
}

void SceneReader::readSphere(const ValueReader& value) {
    Sphere sphere;
    const ObjectReader object(value, kSphereKeys, m_report);
    if (value.type() != json::Type::Object)
        return;
    object.readVector("origin", "the centre as [x, y, z] in metres", sphere.origin);
    if (const auto radius = object.require("radius", "a number above 0, in metres"))
        sphere.radius = radius->number(kLength).value_or(sphere.radius);
    if (const auto friction = object.expect("friction", json::numberText(sphere.friction)))
        sphere.friction = friction->number(kShare).value_or(sphere.friction);
    sphere.unknownKeys = object.unknownKeys();
    m_scene.spheres.push_back(std::move(sphere));
}

void SceneReader::readPlane(const ValueReader& value) {
    Plane plane;
    const ObjectReader object(value, kPlaneKeys, m_report);
    if (value.type() != json::Type::Object)
        return;
    object.readVector("point", "a point on the plane as [x, y, z] in metres", plane.point);
    object.readVector("normal", "the direction of its upper side as [x, y, z]", plane.normal);
    if (const auto friction = object.expect("friction", json::numberText(plane.friction)))
        plane.friction = friction->number(kShare).value_or(plane.friction);
    plane.unknownKeys = object.unknownKeys();
    m_scene.planes.push_back(std::move(plane));
}

void SceneReader::readSimulation(const ValueReader& value) {
    const ObjectReader object(value, kSimulationKeys, m_report);
    if (const auto gravity = object.find("gravity"))
        readGravity(*gravity);
    readParameters(object, "simulation", m_scene);
    m_scene.simulation.unknownKeys = object.unknownKeys();
}

void SceneReader::readGravity(const ValueReader& value) {
    if (const auto numbers = value.numbers(3, "an acceleration as [x, y, z] in m/s²"))
        m_scene.simulation.gravity = toVec3(*numbers);
}

void SceneReader::readCamera(const ValueReader& value) {
    CameraView& camera = m_scene.camera.emplace();
    const ObjectReader object(value, kCameraKeys, m_report);
    if (object.find("target"))
        object.readVector("target", "the point looked at as [x, y, z] in metres", camera.target);
    object.readNumber("distance", kLength, camera.distance);
    object.readNumber("azimuth", kAzimuth, camera.azimuth);
    object.readNumber("elevation", kElevation, camera.elevation);
    camera.unknownKeys = object.unknownKeys();
}

SceneReading unreadableScene(std::string message, std::string remedy) {
    return {std::nullopt, {{Severity::Error, "", std::move(message), std::move(remedy)}}};
}

} // namespace

SceneReading readScene(std::string_view json) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (json.size() > kMaxSceneBytes)
        return unreadableScene("is larger than " + std::to_string(kMaxSceneBytes >> 20U) + " MiB",
                               "check that it is the right file");
    if (json.starts_with(kByteOrderMark))
        json.remove_prefix(kByteOrderMark.size());
    try {
        return SceneReader().read(json);
    } catch (const std::exception&) { // of the memory or the library's own
        return unreadableScene("cannot be read; it may not fit into the memory",
                               "close other programs or make it smaller");
    }
}

} // namespace clothlab
