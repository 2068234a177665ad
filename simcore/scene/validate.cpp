#include "simcore/scene/json_check.h"
#include "simcore/scene/json_text.h"
#include "simcore/scene/known_keys.h"
#include "simcore/scene/range.h"
#include "simcore/scene/scene_checks.h"
#include "simcore/scene/scene_io.h"
#include "simcore/scene/utf8.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clothlab {
namespace {

void check(double value, const Range& range, const std::string& place, Report& report) {
    if (!range.contains(value))
        report.error(place, outOfRange(value), writeWithin(range));
}

void check(const Vec3& value, const Range& range, const std::string& place, Report& report) {
    for (int i = 0; i < 3; ++i)
        check(value[i], range, place + "[" + std::to_string(i) + "]", report);
}

std::string placeIn(const char* key, std::size_t index, std::size_t count) {
    return count == 1 ? key : key + ("[" + std::to_string(index) + "]");
}

void checkPins(const Cloth& cloth, Report& report) {
    std::size_t outside = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < cloth.pinned.size(); ++i) {
        const GridPoint p = cloth.pinned[i];
        if (p.x >= 0 && p.x < cloth.numWidthPoints && p.y >= 0 && p.y < cloth.numHeightPoints)
            continue;
        first = outside == 0 ? i : first;
        ++outside;
    }
    if (outside == 0)
        return;
    const GridPoint p = cloth.pinned[first];
    std::string message = "[" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                          "] is not a point of the grid of " + std::to_string(cloth.numWidthPoints) + " by " +
                          std::to_string(cloth.numHeightPoints);
    if (outside > 1)
        message += "; so are " + std::to_string(outside - 1) + " more";
    report.error("cloth.pinned[" + std::to_string(first) + "]", message,
                 "give x from 0 to " + std::to_string(cloth.numWidthPoints - 1) + " and y from 0 to " +
                     std::to_string(cloth.numHeightPoints - 1));
}

void checkPointCount(const Cloth& cloth, Report& report) {
    const std::int64_t points = std::int64_t(cloth.numWidthPoints) * cloth.numHeightPoints;
    if (points > kMaxPoints)
        report.error("cloth.num_width_points",
                     std::to_string(cloth.numWidthPoints) + " by " + std::to_string(cloth.numHeightPoints) +
                         " points are " + std::to_string(points) + ", more than the " +
                         std::to_string(kMaxPoints) + " that a sheet may have",
                     "give fewer points");
}

void checkCount(std::size_t count, const char* place, Report& report) {
    if (count > kMaxColliders)
        report.error(place, "are more than the " + std::to_string(kMaxColliders) + " that a scene may have",
                     "remove some of them");
}

void checkColliders(const Scene& scene, Report& report) {
    checkCount(scene.spheres.size(), "sphere", report);
    checkCount(scene.planes.size(), "plane", report);
    for (std::size_t i = 0; i < scene.spheres.size() && !report.full(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        const std::string place = placeIn("sphere", i, scene.spheres.size());
        check(sphere.origin, kCoordinate, place + ".origin", report);
        check(sphere.radius, kLength, place + ".radius", report);
        check(sphere.friction, kShare, place + ".friction", report);
    }
    for (std::size_t i = 0; i < scene.planes.size() && !report.full(); ++i) {
        const Plane& plane = scene.planes[i];
        const std::string place = placeIn("plane", i, scene.planes.size());
        check(plane.point, kCoordinate, place + ".point", report);
        check(plane.normal, kCoordinate, place + ".normal", report);
        // A normal so short that its square is no ordinary number cannot be brought to length 1.
        if (plane.normal.squaredNorm() < std::numeric_limits<double>::min())
            report.error(place + ".normal", "has no length and so no direction",
                         "give a direction, like [0, 1, 0]");
        check(plane.friction, kShare, place + ".friction", report);
    }
}

void check(const Rgb& color, const std::string& place, Report& report) {
    for (std::size_t i = 0; i < color.size(); ++i)
        check(color[i], kShare, place + "[" + std::to_string(i) + "]", report);
}

void checkShaderName(const std::string& name, const std::string& place, Report& report) {
    const bool isPath = name.find_first_of("/\\") != std::string::npos || name == "." || name == "..";
    if (name.empty() || name.size() > kMaxNameBytes || isPath || !isUtf8(name))
        report.error(place, "is not the name of a shader", "give a name like \"Phong\", without / or \\");
}

void checkFileName(const std::string& name, const std::string& place, Report& report) {
    if (name.size() > kMaxFileNameBytes || !isUtf8(name))
        report.error(place, "is not the name of a file",
                     "give a name in UTF-8 of at most " + std::to_string(kMaxFileNameBytes) +
                         " bytes, without zero bytes");
}

// As GLSL has them, but for those that it keeps for itself: no shader can ask for these.
bool isIdentifier(std::string_view name) {
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    return !name.empty() && name.size() <= kMaxNameBytes && isLetter(name.front()) &&
           std::ranges::all_of(name, [&](char c) { return isLetter(c) || isDigit(c); });
}

void checkUniform(const UniformValue& value, const std::string& place, Report& report) {
    if (const auto* number = std::get_if<double>(&value); number && !std::isfinite(*number))
        report.error(place, outOfRange(*number), "give a number");
    if (const auto* file = std::get_if<std::string>(&value))
        checkFileName(*file, place, report);
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    if (!numbers)
        return;
    if (numbers->size() < kFewestNumbers || numbers->size() > kMostNumbers)
        report.error(place, "holds " + std::to_string(numbers->size()) + " numbers", "give 2 to 4 numbers");
    for (std::size_t i = 0; i < std::min(numbers->size(), kMostNumbers); ++i) {
        if (!std::isfinite((*numbers)[i]))
            report.error(place + "[" + std::to_string(i) + "]", outOfRange((*numbers)[i]), "give a number");
    }
}

void checkUniforms(const Appearance& appearance, Report& report) {
    const std::string place = "appearance.uniforms";
    std::size_t count = 0;
    for (const auto& [shader, values] : appearance.uniforms) {
        const std::string placeOfShader = place + "." + shortened(shader);
        checkShaderName(shader, placeOfShader, report);
        for (const auto& [name, value] : values) {
            if (report.full())
                return;
            const std::string placeOfValue = placeOfShader + "." + shortened(name);
            if (!isIdentifier(name))
                report.error(placeOfValue, "is not the name of a uniform",
                             "give a name like u_roughness: letters, digits and _, at most " +
                                 std::to_string(kMaxNameBytes));
            checkUniform(value, placeOfValue, report);
        }
        count += values.size();
    }
    if (appearance.uniforms.size() > kMaxUniforms || count > kMaxUniforms)
        report.error(place,
                     "are more than the " + std::to_string(kMaxUniforms) +
                         " that a scene may have, or of more shaders than that",
                     "remove some of them");
}

void checkAppearance(const Appearance& appearance, Report& report) {
    checkShaderName(appearance.shader, "appearance.shader", report);
    check(appearance.color, "appearance.color", report);
    if (appearance.backColor)
        check(*appearance.backColor, "appearance.back_color", report);
    if (appearance.background)
        check(*appearance.background, "appearance.background", report);
    if (appearance.springColoring != SpringColoring::ByType &&
        appearance.springColoring != SpringColoring::ByStrain)
        report.error("appearance.springs_colored_by", "is not what springs can be coloured by",
                     "give \"type\" or \"strain\"");
    for (std::size_t i = 0; i < appearance.textures.size(); ++i)
        checkFileName(appearance.textures[i], "appearance.textures." + std::string(kTextureKeys[i]), report);
    checkFileName(appearance.cubemap, "appearance.cubemap", report);
    checkUniforms(appearance, report);
}

void checkCamera(const CameraView& camera, Report& report) {
    check(camera.target, kCoordinate, "camera.target", report);
    check(camera.distance, kLength, "camera.distance", report);
    check(camera.azimuth, kAzimuth, "camera.azimuth", report);
    check(camera.elevation, kElevation, "camera.elevation", report);
}

// A file writes these keys beside the known ones, so they must be an object and none of them known.
void checkUnknownKeys(const std::string& text, const std::string& place, Keys known, Report& report) {
    constexpr const char* kRemedy = "take the key out of unknownKeys";
    if (text.empty())
        return;
    const auto fault = json::checkJson(text);
    if (fault || json::parse(text).type() != json::Type::Object) {
        report.error(place, "its unknown keys are not the text of a JSON object",
                     "leave unknownKeys as it was read");
        return;
    }
    for (const json::Member& member : json::members(json::parse(text))) {
        if (isKnown(member.key, known))
            report.error(place + (place.empty() ? "" : ".") + member.key,
                         "is a known key among the unknown ones", kRemedy);
    }
}

void checkAllUnknownKeys(const Scene& scene, Report& report) {
    checkUnknownKeys(scene.unknownKeys, "", kSceneKeys, report);
    checkUnknownKeys(scene.cloth.unknownKeys, "cloth", kClothKeys, report);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i)
        checkUnknownKeys(scene.spheres[i].unknownKeys, placeIn("sphere", i, scene.spheres.size()),
                         kSphereKeys, report);
    for (std::size_t i = 0; i < scene.planes.size(); ++i)
        checkUnknownKeys(scene.planes[i].unknownKeys, placeIn("plane", i, scene.planes.size()), kPlaneKeys,
                         report);
    checkUnknownKeys(scene.simulation.unknownKeys, "simulation", kSimulationKeys, report);
    checkUnknownKeys(scene.appearance.unknownKeys, "appearance", kAppearanceKeys, report);
    checkUnknownKeys(scene.appearance.unknownSpringKeys, "appearance.springs_drawn", kSpringsDrawnKeys,
                     report);
    checkUnknownKeys(scene.appearance.unknownTextureKeys, "appearance.textures", kTextureKeys, report);
    if (scene.camera)
        checkUnknownKeys(scene.camera->unknownKeys, "camera", kCameraKeys, report);
}

} // namespace

void findErrors(const Scene& scene, Report& report) {
    for (const Parameter& parameter : parameters())
        check(parameter.get(scene), rangeOf(parameter), std::string(parameter.id), report);
    checkPointCount(scene.cloth, report);
    checkPins(scene.cloth, report);
    checkColliders(scene, report);
    checkAppearance(scene.appearance, report);
    if (scene.camera)
        checkCamera(*scene.camera, report);
}

Diagnostics validate(const Scene& scene) {
    Report report;
    findErrors(scene, report);
    checkAllUnknownKeys(scene, report);
    if (report.errors() == 0)
        findWarnings(scene, report);
    return report.take();
}

} // namespace clothlab
