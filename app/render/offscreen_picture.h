// Pictures without a window.
#pragma once

#include "app/render/problem.h"
#include "app/render/render_frame.h"

#include <QImage>
#include <QSize>

#include <memory>
#include <optional>

namespace clothlab::render {

struct PictureSource {
    QString shaderDirectory;
    QString textureDirectory;
};

// The greatest width and height of a picture.
inline constexpr int kGreatestPicture = 8192; // pixels

// Draws picture after picture of one size, with an OpenGL context of its own. Needs a QGuiApplication, on a
// platform with OpenGL. Made and destroyed in the GUI's thread; open(), draw() and close() all belong to one
// thread, which may be another, and close() must have been called there before the end.
class OffscreenRenderer {
public:
    OffscreenRenderer();
    ~OffscreenRenderer();
    OffscreenRenderer(const OffscreenRenderer&) = delete;
    OffscreenRenderer& operator=(const OffscreenRenderer&) = delete;

    // False, with the reason in words, where OpenGL 3.3 is not to be had or the size is too large for it.
    bool open(QSize size, const PictureSource& source, QString& reason);
    QImage draw(const RenderFrame& frame); // after open() went well; QImage::Format_RGB32
    const Problems& problems() const;      // with shaders and textures of the last picture
    void close();                          // does nothing if it is not open

private:
    struct Open;
    class Surface;
    std::unique_ptr<Surface> m_surface;
    std::unique_ptr<Open> m_open;
    Problems m_problems;
};

// One picture of the frame. Nothing, with the reason in words, where none can be made. `problems` gets what
// is wrong with shaders and textures.
std::optional<QImage> renderPicture(const RenderFrame& frame, QSize size, const PictureSource& source,
                                    Problems& problems, QString& reason);

} // namespace clothlab::render
