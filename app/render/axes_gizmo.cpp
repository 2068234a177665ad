#include "app/render/axes_gizmo.h"

#include "app/render/view_metrics.h"

#include <algorithm>
#include <span>

namespace clothlab::render {
namespace {

constexpr float kShaft = 24;   // pixels
constexpr float kLetter = 33;  // distance of the letter's middle
constexpr float kGlyph = 3.6F; // half a letter's height

struct Stroke {
    float x1, y1, x2, y2; // -1..1 across the letter
};
constexpr std::array kX{Stroke{-0.8F, -1, 0.8F, 1}, Stroke{-0.8F, 1, 0.8F, -1}};
constexpr std::array kY{Stroke{-0.8F, 1, 0, 0}, Stroke{0.8F, 1, 0, 0}, Stroke{0, 0, 0, -1}};
constexpr std::array kZ{Stroke{-0.8F, 1, 0.8F, 1}, Stroke{0.8F, 1, -0.8F, -1}, Stroke{-0.8F, -1, 0.8F, -1}};
constexpr std::array<std::span<const Stroke>, 3> kLetters{kX, kY, kZ};

const std::array<QVector4D, 3> kColors{QVector4D(0.90F, 0.38F, 0.40F, 1), QVector4D(0.50F, 0.76F, 0.36F, 1),
                                       QVector4D(0.38F, 0.60F, 0.95F, 1)};

void makeAxis(std::size_t axis, const std::array<QVector3D, 3>& screen, float scale, GizmoAxis& out) {
    const auto component = static_cast<int>(axis);
    const QVector3D end(screen[0][component], screen[1][component], 0);
    const QVector3D middle = scale * kLetter * end;
    const float glyph = scale * kGlyph;
    out.color = kColors[axis];
    out.depth = screen[2][component];
    out.lines.clear();
    out.lines.insert(out.lines.end(), {QVector3D(), scale * kShaft * end});
    for (const Stroke& stroke : kLetters[axis])
        out.lines.insert(out.lines.end(), {middle + glyph * QVector3D(stroke.x1, stroke.y1, 0),
                                           middle + glyph * QVector3D(stroke.x2, stroke.y2, 0)});
}

} // namespace

void makeAxesGizmo(const QMatrix4x4& viewProjection, float scale, std::array<GizmoAxis, 3>& axes) {
    const std::array<QVector3D, 3> screen = screenAxes(viewProjection);
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
        makeAxis(axis, screen, scale, axes[axis]);
    std::sort(axes.begin(), axes.end(),
              [](const GizmoAxis& a, const GizmoAxis& b) { return a.depth > b.depth; });
}

} // namespace clothlab::render
