// What a user may set of a shader: its uniforms that the program does not set itself.
#pragma once

#include <QByteArray>
#include <QString>

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace clothlab::render {

// What a user set a uniform to. A setting of another number of components than the uniform has is passed
// over.
struct UniformSetting {
    int components = 0; // 1 … 4 numbers; 0: a file
    std::array<float, 4> numbers{};
    QString file;
    friend bool operator==(const UniformSetting&, const UniformSetting&) = default;
};

using UniformSettings = std::map<QString, UniformSetting>; // by the uniform's name

struct UniformSpec {
    enum class Type { Bool, Int, Float, Vec2, Vec3, Vec4, Sampler2D };

    QString name;
    Type type = Type::Float;
    QString label; // the name in words if the file gives none
    QString help;  // empty if the file gives none
    UniformSetting initial;
    std::optional<std::array<float, 2>> range;
    bool color = false; // vec3 and vec4: shown as a colour
    bool srgb = false;  // sampler2D: texels are decoded from sRGB
    friend bool operator==(const UniformSpec&, const UniformSpec&) = default;
};

// Components of a value of that type; 0 for a sampler.
int componentsOf(UniformSpec::Type type);

// Completes `spec`, of which name and type are given and `initial` what GLSL itself says, by the comment
// after the declaration in the last of `sources` that has one. All of it is optional: default, range,
// `color`, `srgb` in any order, then the label, then help, which goes to the end of the line:
//
//   uniform float u_roughness; // 0.5 [0, 1] "Roughness" of the surface: 0 is a mirror.
//   uniform vec3 u_tint;       // color (1, 0.5, 0) "Tint"       or  // #FF8000 "Tint"
//   uniform vec2 u_tiles;      // (4, 4) [1, 64] "Tiles"
//   uniform bool u_glow;       // true "Glow"
//   uniform sampler2D u_map;   // srgb texture_5.png "Colours"
//
// A vec3 or vec4 whose name ends in "color" or "colour" is one, too.
void annotate(UniformSpec& spec, const std::vector<QByteArray>& sources);

} // namespace clothlab::render
