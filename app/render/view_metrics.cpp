#include "app/render/view_metrics.h"

namespace clothlab::render {
namespace {

QVector3D rowDirection(const QMatrix4x4& matrix, int row) {
    return matrix.row(row).toVector3D();
}

} // namespace

float pixelSize(const QMatrix4x4& viewProjection, QSize pixels) {
    const float perMetre = rowDirection(viewProjection, 1).length();
    const auto height = static_cast<float>(pixels.height());
    return perMetre > 0 && height > 0 ? 2 / (perMetre * height) : 0;
}

QVector2D depthSlope(const QMatrix4x4& viewProjection) {
    return {rowDirection(viewProjection, 2).length(), rowDirection(viewProjection, 3).length()};
}

std::array<QVector3D, 3> screenAxes(const QMatrix4x4& viewProjection) {
    return {rowDirection(viewProjection, 0).normalized(), rowDirection(viewProjection, 1).normalized(),
            rowDirection(viewProjection, 2).normalized()};
}

} // namespace clothlab::render
