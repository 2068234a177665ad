// Everything one picture is made of, as plain values. The viewport fills it; the renderer draws it.
#pragma once

#include <QColor>
#include <QMatrix4x4>
#include <QString>
#include <QVector3D>
#include <QVector4D>

#include <array>
#include <cstdint>
#include <vector>

namespace clothlab::render {

// The sheet: point masses in row-major order (index = y * width + x).
struct SheetShape {
    int width = 0;                     // points a row
    int height = 0;                    // rows
    std::vector<float> positions;      // 3 * width * height, metres; empty draws no sheet
    std::vector<std::uint32_t> pinned; // indices of pinned points, drawn as dots
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

struct RenderFrame {
    QMatrix4x4 viewProjection;
    QVector3D cameraPosition;

    // Name of the shader of the sheet and the colliders; "Wireframe" draws springs as lines instead.
    QString shader = QStringLiteral("Phong");
    QVector4D color{1, 1, 1, 1};
    QVector3D lightPosition{0.5F, 2, 2};
    QVector3D lightIntensity{3, 3, 3};

    QColor background{0x26, 0x28, 0x2B};
    bool groundGrid = true;
    bool axes = true;
    float gridOpacity = 0.25F;

    SheetShape sheet;
    std::vector<SphereShape> spheres;
    std::vector<PlaneShape> planes;

    // Springs drawn by type (structural, shearing, bending), and their colours. Drawn when the shader is
    // Wireframe, or over the surface when springsOverSurface is set.
    std::array<bool, 3> springsDrawn{true, true, true};
    std::array<QColor, 3> springColors{QColor(0x3D, 0x9B, 0xE0), QColor(0xF2, 0xB8, 0x3C),
                                       QColor(0x2B, 0xC4, 0x96)};
    bool springsOverSurface = false;

    Highlight highlight;
    QColor highlightColor{0xFF, 0xD2, 0x3F};
    QColor pinnedColor{0xCC, 0x79, 0xA7};
    float devicePixelRatio = 1; // scales widths of lines and dots
};

} // namespace clothlab::render
