// Which point mass or spring is under the mouse. Computed on the CPU, so it works without OpenGL.
#pragma once

#include "app/document/selection.h"
#include "app/picture/camera.h"
#include "simcore/cloth/cloth_state.h"
#include "simcore/scene/scene.h"

#include <array>
#include <optional>
#include <span>

namespace clothlab {

struct PickQuery {
    QPointF position; // logical pixels, like the size
    QSizeF size;
    double pointRadius = 8;                                   // logical pixels
    double springRadius = 5;                                  // logical pixels
    std::array<bool, kSpringTypes> springs{true, true, true}; // which types can be picked
    bool surfaceHides = true;        // what lies behind the sheet's surface cannot be picked
    std::span<const Sphere> spheres; // nor what lies behind these
};

// A point within its radius wins over a spring; of several the nearest on the screen; of those that are as
// near, give or take 1.5 pixels, the one in front; of those as far in front, the nearest on the screen.
std::optional<Selection::Item> pick(const Camera& camera, const Grid& grid, const PointArray& position,
                                    const PickQuery& query);

// Numbers of the points whose pictures lie in the rectangle, ascending.
std::vector<int> pointsIn(const QRectF& rectangle, const Camera& camera, const PointArray& position,
                          QSizeF size);

} // namespace clothlab
