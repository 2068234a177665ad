// An orbiting camera: what it looks at, from where, and how mouse moves change that. Knows no widget.
#pragma once

#include "simcore/scene/scene.h"

#include <QMatrix4x4>
#include <QPointF>
#include <QSizeF>
#include <QVector3D>

namespace clothlab {

enum class ViewDirection { Front, Back, Right, Left, Top, Bottom };

// A ray in world space; direction has length 1.
struct Ray {
    QVector3D origin;
    QVector3D direction;
};

class Camera {
public:
    static constexpr float kFieldOfView = 35; // degrees, vertical

    // Azimuth and elevation in degrees, as in CameraView.
    CameraView view;
    bool orthographic = false;

    QVector3D target() const;
    QVector3D eye() const;
    QMatrix4x4 viewMatrix() const;
    QMatrix4x4 projectionMatrix(QSizeF size) const; // of a view of that size; only its ratio counts
    QMatrix4x4 viewProjection(QSizeF size) const { return projectionMatrix(size) * viewMatrix(); }

    // Pixels from the upper left corner, as mouse events have them. Nothing is visible behind the camera:
    // visible is then false.
    struct Projected {
        QPointF position;
        float depth = 0; // distance along the view direction, metres
        bool visible = false;
    };
    Projected project(const QVector3D& point, QSizeF size) const;
    Ray rayThrough(QPointF position, QSizeF size) const;
    float metresPerPixel(float depth, QSizeF size) const;

    void orbit(QPointF pixels);
    void pan(QPointF pixels, QSizeF size);
    void zoom(double factor, QPointF towards,
              QSizeF size); // factor < 1 comes nearer; what is under towards stays
    void look(ViewDirection direction);
    // Puts a sphere into a view of that size, whole and no smaller than needed. Keeps the direction.
    void frame(const QVector3D& centre, double radius, QSizeF size);
};

// Where the course looks at: the sheet's centre at half its height. A little from above and from the side, so
// that a flat sheet can be seen, and from 2.6 instead of 1.8 times its longer side, so that a hanging one
// fits.
CameraView homeView(const Cloth& cloth);

} // namespace clothlab
