#include "simcore/scene/appearance_reader.h"

#include <utility>

namespace clothlab {
namespace {

constexpr std::string_view kColor = "a colour as [red, green, blue], each from 0 to 1";

std::optional<std::array<double, 3>> triple(const ObjectReader& object, std::string_view key,
                                            std::string_view wanted) {
    const auto value = object.find(key);
    const auto numbers = value ? value->numbers(3, wanted) : std::nullopt;
    if (!numbers)
        return std::nullopt;
    return std::array{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

void readSpringsDrawn(const ValueReader& value, Appearance& appearance, Report& report) {
    const ObjectReader object(value, kSpringsDrawnKeys, report);
    for (std::size_t type = 0; type < kSpringsDrawnKeys.size(); ++type)
        object.readBoolean(kSpringsDrawnKeys[type], appearance.springsDrawn[type]);
    appearance.unknownSpringKeys = object.unknownKeys();
}

void readSpringColoring(const ValueReader& value, SpringColoring& coloring) {
    constexpr std::string_view kWays = "\"type\" or \"strain\"";
    const auto way = value.string(kWays);
    if (!way)
        return;
    if (*way != "type" && *way != "strain")
        return value.error("is not what springs can be coloured by", "give " + std::string(kWays));
    coloring = *way == "strain" ? SpringColoring::ByStrain : SpringColoring::ByType;
}

void readTextures(const ValueReader& value, Appearance& appearance, Report& report) {
    const ObjectReader object(value, kTextureKeys, report);
    for (std::size_t i = 0; i < kTextureKeys.size(); ++i)
        object.readString(kTextureKeys[i], "the name of an image, like \"linen.png\"",
                          appearance.textures[i]);
    appearance.unknownTextureKeys = object.unknownKeys();
}

std::optional<UniformValue> uniformValue(const ValueReader& value) {
    constexpr std::string_view kWanted =
        "true or false, a number, a list of 2 to 4 numbers or the name of a file";
    switch (value.type()) {
    case json::Type::Boolean:
        return value.value().boolean();
    case json::Type::Number:
        return value.value().number();
    case json::Type::String:
        return value.value().string();
    case json::Type::Array:
        return value.numbers(kFewestNumbers, kMostNumbers, kWanted);
    default:
        value.error("is not the value of a uniform", "give " + std::string(kWanted));
        return std::nullopt;
    }
}

class UniformsReader {
public:
    UniformsReader(Appearance& appearance, Report& report)
        : m_uniforms(appearance.uniforms), m_report(report) {}

    void read(const ValueReader& value) {
        if (!value.require(json::Type::Object, "an object like {\"Phong\": {\"u_roughness\": 0.5}}"))
            return;
        for (json::Member& shader : json::members(value.value())) {
            if (enough())
                return;
            const ValueReader values = value.member(shader.value, shader.key);
            readShader(values, m_uniforms[std::move(shader.key)]);
        }
    }

private:
    // One too many is read, for the checks to find.
    bool enough() const {
        return m_report.full() || m_uniforms.size() > kMaxUniforms || m_values > kMaxUniforms;
    }

    void readShader(const ValueReader& shader, UniformValues& values) {
        if (!shader.require(json::Type::Object, "the shader's uniforms, like {\"u_roughness\": 0.5}"))
            return;
        for (json::Member& uniform : json::members(shader.value())) {
            if (enough())
                return;
            auto value = uniformValue(shader.member(uniform.value, uniform.key));
            if (value)
                values.emplace(std::move(uniform.key), std::move(*value));
            ++m_values;
        }
    }

    std::map<std::string, UniformValues>& m_uniforms;
    std::size_t m_values = 0; // of all shaders
    Report& m_report;
};

} // namespace

void readAppearance(const ValueReader& value, Scene& scene, Report& report) {
    Appearance& appearance = scene.appearance;
    const ObjectReader object(value, kAppearanceKeys, report);
    readParameters(object, "appearance", scene);
    object.readString("shader", "the name of a shader, like \"Phong\"", appearance.shader);
    object.readString("cubemap", "the name of a folder", appearance.cubemap);
    object.readBoolean("springs_over_surface", appearance.springsOverSurface);
    appearance.color = triple(object, "color", kColor).value_or(appearance.color);
    appearance.backColor = triple(object, "back_color", kColor);
    appearance.background = triple(object, "background", kColor);
    appearance.lightPosition =
        triple(object, "light_position", "a place as [x, y, z] in metres").value_or(appearance.lightPosition);
    appearance.lightIntensity =
        triple(object, "light_intensity", "an intensity as [red, green, blue], each from 0 to 1000000")
            .value_or(appearance.lightIntensity);
    if (const auto springs = object.find("springs_drawn"))
        readSpringsDrawn(*springs, appearance, report);
    if (const auto coloring = object.find("springs_colored_by"))
        readSpringColoring(*coloring, appearance.springColoring);
    if (const auto textures = object.find("textures"))
        readTextures(*textures, appearance, report);
    if (const auto uniforms = object.find("uniforms"))
        UniformsReader(appearance, report).read(*uniforms);
    appearance.unknownKeys = object.unknownKeys();
}

} // namespace clothlab
