// A small picture of the sheet, drawn without OpenGL.
#pragma once

#include "app/picture/camera.h"
#include "simcore/cloth/cloth_state.h"

#include <QColor>
#include <QImage>

namespace clothlab {

struct ThumbnailLook {
    QColor background;
    QColor front; // of the sheet, lit from where the camera is
    QColor back;
    QColor sphere;
};

// What the camera sees of the sheet and the scene's spheres. Of a large sheet and of many spheres only some
// are drawn, so that it takes a few milliseconds. size: in device pixels.
QImage thumbnail(const Scene& scene, const Grid& grid, const PointArray& position, const Camera& camera,
                 QSize size, const ThumbnailLook& look);

} // namespace clothlab
