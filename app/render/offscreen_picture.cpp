#include "app/render/offscreen_picture.h"

#include "app/render/renderer.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>

#include <algorithm>

namespace clothlab::render {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("Picture", text);
}

} // namespace

std::optional<QImage> renderPicture(const RenderFrame& frame, QSize size, const PictureSource& source,
                                    Problems& problems, QString& reason) {
    const auto fail = [&reason](const QString& why) {
        reason = why;
        return std::nullopt;
    };
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOpenGLContext context;
    context.setFormat(format);
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    if (!context.create() || !context.makeCurrent(&surface))
        return fail(
            tr("no OpenGL context can be made here; pictures need an X server, like that of xvfb-run"));
    GLint greatest = 0;
    context.functions()->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &greatest);
    greatest = std::min(greatest, kGreatestPicture);
    if (size.isEmpty() || size.width() > greatest || size.height() > greatest)
        return fail(tr("a picture has from 1 to %1 pixels along a side here").arg(greatest));

    Renderer renderer;
    if (!renderer.initialize(&reason))
        return std::nullopt;
    renderer.setShaderDirectory(source.shaderDirectory);
    renderer.setTextureDirectory(source.textureDirectory);
    QOpenGLFramebufferObjectFormat target;
    target.setAttachment(QOpenGLFramebufferObject::Depth);
    QOpenGLFramebufferObject framebuffer(size, target);
    if (!framebuffer.bind())
        return fail(tr("there is not enough memory for a picture of %1 by %2 pixels")
                        .arg(size.width())
                        .arg(size.height()));
    renderer.render(frame, size);
    problems = renderer.problems();
    QImage image = framebuffer.toImage().convertToFormat(QImage::Format_RGB32);
    renderer.release();
    return image;
}

} // namespace clothlab::render
