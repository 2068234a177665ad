// The small coordinate axes in the corner, as lines in pixels.
#pragma once

#include <QMatrix4x4>
#include <QVector3D>
#include <QVector4D>

#include <array>
#include <vector>

namespace clothlab::render {

// One axis with its letter at the end: pairs of points, x right and y up in pixels from the gizmo's middle, z
// = 0.
struct GizmoAxis {
    std::vector<QVector3D> lines;
    QVector4D color;
    float depth = 0; // of its end, along the view direction
};

// Pixels from the gizmo's middle to the ends of its letters, at scale 1.
inline constexpr float kGizmoRadius = 38;

// x red, y green, z blue, seen as the camera sees the world; the farthest first, so that drawing in this
// order needs no depth buffer. An axis that points at the viewer is only its letter. `scale` is in pixels of
// the screen a unit. Writes into `axes` to keep its memory.
void makeAxesGizmo(const QMatrix4x4& viewProjection, float scale, std::array<GizmoAxis, 3>& axes);

} // namespace clothlab::render
