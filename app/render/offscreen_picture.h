// Pictures without a window.
#pragma once

#include "app/render/problem.h"
#include "app/render/render_frame.h"

#include <QImage>
#include <QSize>

#include <optional>

namespace clothlab::render {

struct PictureSource {
    QString shaderDirectory;
    QString textureDirectory;
};

// The greatest width and height of a picture.
inline constexpr int kGreatestPicture = 8192; // pixels

// Draws the frame into a picture of that size, with a context of its own. Nothing, with the reason in words,
// where OpenGL 3.3 is not to be had or the size is too large for it. `problems` gets what is wrong with
// shaders and textures. Needs a QGuiApplication, on a platform with OpenGL.
std::optional<QImage> renderPicture(const RenderFrame& frame, QSize size, const PictureSource& source,
                                    Problems& problems, QString& reason);

} // namespace clothlab::render
