// What can be read back from a view-projection matrix, perspective or orthographic.
#pragma once

#include <QMatrix4x4>
#include <QSize>
#include <QVector2D>
#include <QVector3D>

#include <array>

namespace clothlab::render {

// World length of a pixel's height where clip-space w is 1 (times w elsewhere). 0 for a degenerate matrix.
float pixelSize(const QMatrix4x4& viewProjection, QSize pixels);

// How much clip-space z and w grow for each metre along the view direction.
QVector2D depthSlope(const QMatrix4x4& viewProjection);

// Unit directions in the world of the screen's right, up, and into the screen. Null for a degenerate matrix.
std::array<QVector3D, 3> screenAxes(const QMatrix4x4& viewProjection);

} // namespace clothlab::render
