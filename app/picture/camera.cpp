#include "app/picture/camera.h"

#include "app/picture/to_vector_3d.h"

#include <QtMath>

#include <algorithm>
#include <array>
#include <cmath>

namespace clothlab {
namespace {

constexpr double kNearest = 0.01;   // m
constexpr double kFarthest = 10000; // m
constexpr double kDegreesPerPixel = 0.35;

Vec3 fromQt(const QVector3D& v) {
    return {v.x(), v.y(), v.z()};
}

struct Axes {
    QVector3D right, up, back; // back points from the target to the eye
};

Axes axesOf(const CameraView& view) {
    const double azimuth = qDegreesToRadians(view.azimuth);
    const double elevation = qDegreesToRadians(view.elevation);
    const QVector3D back(float(std::cos(elevation) * std::sin(azimuth)), float(std::sin(elevation)),
                         float(std::cos(elevation) * std::cos(azimuth)));
    const QVector3D right(float(std::cos(azimuth)), 0, float(-std::sin(azimuth)));
    return {right, QVector3D::crossProduct(back, right), back};
}

// How far before and behind the eye a parallel projection draws. However near one zooms, the sheet is not
// cut.
float orthographicDepth(double distance) {
    return float(20 * distance + 20);
}

} // namespace

QVector3D Camera::target() const {
    return toVector3D(view.target);
}

QVector3D Camera::eye() const {
    return target() + axesOf(view).back * float(view.distance);
}

QMatrix4x4 Camera::viewMatrix() const {
    QMatrix4x4 matrix;
    matrix.lookAt(eye(), target(), axesOf(view).up);
    return matrix;
}

QMatrix4x4 Camera::projectionMatrix(QSizeF size) const {
    const auto ratio = float(size.width() / std::max(1.0, size.height()));
    const auto distance = float(view.distance);
    QMatrix4x4 matrix;
    if (orthographic) {
        const float halfHeight = distance * std::tan(qDegreesToRadians(kFieldOfView / 2));
        matrix.ortho(-halfHeight * ratio, halfHeight * ratio, -halfHeight, halfHeight,
                     -orthographicDepth(view.distance), orthographicDepth(view.distance));
    } else {
        matrix.perspective(kFieldOfView, ratio, distance * 0.02F, distance * 100 + 20);
    }
    return matrix;
}

Camera::Projected Camera::project(const QVector3D& point, QSizeF size) const {
    const float depth = QVector3D::dotProduct(target() - point, axesOf(view).back) + float(view.distance);
    const QVector4D clip = viewProjection(size) * QVector4D(point, 1);
    if (!(clip.w() > 0) || !std::isfinite(depth) || (!orthographic && depth <= 0))
        return {};
    const double x = (double(clip.x() / clip.w()) + 1) / 2 * size.width();
    const double y = (1 - double(clip.y() / clip.w())) / 2 * size.height();
    return {{x, y}, depth, true};
}

Ray Camera::rayThrough(QPointF position, QSizeF size) const {
    const Axes axes = axesOf(view);
    const float perPixel = metresPerPixel(float(view.distance), size);
    const QVector3D inPlane = axes.right * float(position.x() - size.width() / 2) * perPixel -
                              axes.up * float(position.y() - size.height() / 2) * perPixel;
    if (!orthographic)
        return {eye(), (target() + inPlane - eye()).normalized()};
    // From behind everything that is drawn: the picture goes on behind the eye.
    return {target() + inPlane + axes.back * 2 * orthographicDepth(view.distance), -axes.back};
}

float Camera::metresPerPixel(float depth, QSizeF size) const {
    const float distance = orthographic ? float(view.distance) : depth;
    return 2 * distance * std::tan(qDegreesToRadians(kFieldOfView / 2)) / float(std::max(1.0, size.height()));
}

void Camera::orbit(QPointF pixels) {
    view.azimuth = std::remainder(view.azimuth - pixels.x() * kDegreesPerPixel, 360);
    view.elevation = std::clamp(view.elevation + pixels.y() * kDegreesPerPixel, -90.0, 90.0);
}

void Camera::pan(QPointF pixels, QSizeF size) {
    const Axes axes = axesOf(view);
    const float perPixel = metresPerPixel(float(view.distance), size);
    const QVector3D move = (axes.up * float(pixels.y()) - axes.right * float(pixels.x())) * perPixel;
    view.target += fromQt(move);
}

void Camera::zoom(double factor, QPointF towards, QSizeF size) {
    const double before = view.distance;
    view.distance = std::clamp(before * factor, kNearest, kFarthest);
    const QPointF fromCentre = towards - QPointF(size.width() / 2, size.height() / 2);
    // The point of the target plane under the cursor stays there.
    pan(-fromCentre * (before / view.distance - 1), size);
}

void Camera::look(ViewDirection direction) {
    struct Angles {
        double azimuth, elevation;
    };
    constexpr std::array<Angles, 6> angles{{{0, 0}, {180, 0}, {90, 0}, {-90, 0}, {0, 90}, {0, -90}}};
    view.azimuth = angles[std::size_t(direction)].azimuth;
    view.elevation = angles[std::size_t(direction)].elevation;
}

void Camera::frame(const QVector3D& centre, double radius, QSizeF size) {
    view.target = fromQt(centre);
    // The narrower of the two angles, which is the horizontal one in a view that is higher than wide.
    const double ratio = std::clamp(size.width() / std::max(1.0, size.height()), 0.01, 1.0);
    const double halfAngle = std::atan(ratio * std::tan(qDegreesToRadians(double(kFieldOfView) / 2)));
    const double fitting = 1.1 * std::max(radius, 0.01) / std::sin(halfAngle);
    view.distance = std::clamp(fitting, kNearest, kFarthest);
}

CameraView homeView(const Cloth& cloth) {
    const Vec3 centre = cloth.orientation == Orientation::Horizontal
                            ? Vec3(cloth.width / 2, 1, cloth.height / 2)
                            : Vec3(cloth.width / 2, cloth.height / 2, 0);
    CameraView view;
    view.target = {centre.x(), centre.y() / 2, centre.z()};
    view.distance = std::clamp(2.6 * std::max(cloth.width, cloth.height), 0.1, kFarthest);
    view.azimuth = 30;
    view.elevation = 18;
    return view;
}

} // namespace clothlab
