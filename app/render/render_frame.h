// Everything one picture is made of, as plain values. The viewport fills it; the renderer draws it.
#pragma once

#include "app/render/uniform_spec.h"

#include <QColor>
#include <QMatrix4x4>
#include <QString>
#include <QVector3D>
#include <QVector4D>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace clothlab::render {

// The sheet: point masses in row-major order (index = y * width + x).
struct SheetShape {
    int width = 0;                     // points a row
    int height = 0;                    // rows
    std::vector<float> positions;      // 3 * width * height, metres; empty draws no sheet
    std::vector<float> strains;        // one a point, for the attribute in_strain; empty: 0 everywhere
    std::vector<std::uint32_t> pinned; // indices of pinned points, drawn as dots

    // Positions at which every spring has its rest length, as `positions`; null or of another size: springs
    // have no strain. Never changed once it is here.
    std::shared_ptr<const std::vector<float>> restPositions;
};

struct SphereShape {
    QVector3D origin;
    float radius = 0; // metres; drawn slightly smaller so that flat triangles of the sheet don't cut in
};

struct PlaneShape {
    QVector3D point;
    QVector3D normal; // any length but zero
};

// What is emphasised on top of the picture.
struct Highlight {
    std::vector<QVector3D> points;                  // drawn as dots
    std::vector<std::array<QVector3D, 2>> segments; // drawn as thick lines
};

struct Light {
    QVector3D position{0.5F, 2, 2};
    QVector3D intensity{3, 3, 3}; // at a distance of 1 m
    bool shadows = true;
};

inline constexpr std::size_t kTextureCount = 4; // u_texture_1 … u_texture_4

// What the shader of the surfaces is given beside the scene.
struct SurfaceLook {
    QString shader = QStringLiteral("Phong"); // "Wireframe" draws springs as lines instead
    QVector4D color{1, 1, 1, 1};
    std::optional<QVector4D> backColor; // of the sheet's other side; none: the same
    bool twoSided = true;
    int meshResolution = 0; // cells of the drawn sheet and spheres along a side; 0: the sheet as it is
    float normalScaling = 2;
    float heightScaling = 0.1F;
    std::array<QString, kTextureCount> textures; // files; empty: those of the texture directory
    QString cubemap;                             // a folder; empty: that of the texture directory
    // By the shader's name, which may be another one than asked for while that is broken: what differs from
    // its own defaults.
    std::map<QString, UniformSettings> uniforms{};
};

// Springs are drawn when the shader is Wireframe, or over the surface.
struct SpringsLook {
    std::array<bool, 3> drawn{true, true, true}; // structural, shearing, bending
    std::array<QColor, 3> colors{QColor(0x3D, 0x9B, 0xE0), QColor(0xF2, 0xB8, 0x3C),
                                 QColor(0x2B, 0xC4, 0x96)};
    bool overSurface = false;
    bool coloredByStrain = false;
};

struct RenderFrame {
    QMatrix4x4 viewProjection;
    QVector3D cameraPosition;
    float time = 0; // simulated seconds, for u_time

    SurfaceLook surface;
    SpringsLook springs;
    Light light;
    float strainRange = 0.1F; // at the ends of the colours of strain, > 0

    QColor background{0x26, 0x28, 0x2B};
    bool groundGrid = true;
    bool axes = true;
    float gridOpacity = 0.25F;
    int samples = 1; // a pixel, as far as the machine offers them; 1 leaves it to the framebuffer

    SheetShape sheet;
    std::vector<SphereShape> spheres;
    std::vector<PlaneShape> planes;

    Highlight highlight;
    QColor highlightColor{0xFF, 0xD2, 0x3F};
    QColor pinnedColor{0xCC, 0x79, 0xA7};
    float devicePixelRatio = 1; // scales widths of lines and dots
};

} // namespace clothlab::render
