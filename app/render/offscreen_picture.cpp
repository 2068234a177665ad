#include "app/render/offscreen_picture.h"
#include "app/render/words.h"

#include "app/render/renderer.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QThread>

#include <algorithm>

namespace clothlab::render {
namespace {

QSurfaceFormat surfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

} // namespace

class OffscreenRenderer::Surface : public QOffscreenSurface {};

struct OffscreenRenderer::Open {
    ~Open() {
        if (renderer.isInitialized())
            renderer.release();
        framebuffer.reset();
        context.doneCurrent();
    }

    QOpenGLContext context; // first: gone last
    Renderer renderer;
    std::unique_ptr<QOpenGLFramebufferObject> framebuffer;
    QSize size;
};

OffscreenRenderer::OffscreenRenderer() : m_surface(std::make_unique<Surface>()) {
    m_surface->setFormat(surfaceFormat());
    m_surface->create();
}

OffscreenRenderer::~OffscreenRenderer() = default;

bool OffscreenRenderer::open(QSize size, const PictureSource& source, QString& reason) {
    close();
    const auto fail = [&reason](const QString& why) {
        reason = why;
        return false;
    };
    auto opened = std::make_unique<Open>();
    opened->size = size;
    if (QThread::currentThread() != QCoreApplication::instance()->thread() &&
        !QOpenGLContext::supportsThreadedOpenGL())
        return fail(tr("this OpenGL does not draw beside a window; save single pictures instead"));
    opened->context.setFormat(surfaceFormat());
    if (!opened->context.create() || !opened->context.makeCurrent(m_surface.get()))
        return fail(
            tr("no OpenGL context can be made here; pictures need an X server, like that of xvfb-run"));
    GLint greatest = 0;
    opened->context.functions()->glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &greatest);
    greatest = std::min(greatest, kGreatestPicture);
    if (size.isEmpty() || size.width() > greatest || size.height() > greatest)
        return fail(tr("a picture has from 1 to %1 pixels along a side here").arg(greatest));
    if (!opened->renderer.initialize(&reason))
        return false;
    opened->renderer.setShaderDirectory(source.shaderDirectory);
    opened->renderer.setTextureDirectory(source.textureDirectory);
    QOpenGLFramebufferObjectFormat target;
    target.setAttachment(QOpenGLFramebufferObject::Depth);
    opened->framebuffer = std::make_unique<QOpenGLFramebufferObject>(size, target);
    if (!opened->framebuffer->bind())
        return fail(tr("there is not enough memory for a picture of %1 by %2 pixels")
                        .arg(size.width())
                        .arg(size.height()));
    m_open = std::move(opened);
    return true;
}

QImage OffscreenRenderer::draw(const RenderFrame& frame) {
    m_open->framebuffer->bind();
    m_open->renderer.render(frame, m_open->size);
    m_problems = m_open->renderer.problems();
    return m_open->framebuffer->toImage().convertToFormat(QImage::Format_RGB32);
}

const Problems& OffscreenRenderer::problems() const {
    return m_problems;
}

void OffscreenRenderer::close() {
    m_open.reset();
}

std::optional<QImage> renderPicture(const RenderFrame& frame, QSize size, const PictureSource& source,
                                    Problems& problems, QString& reason) {
    OffscreenRenderer renderer;
    if (!renderer.open(size, source, reason))
        return std::nullopt;
    QImage image = renderer.draw(frame);
    problems = renderer.problems();
    renderer.close();
    return image;
}

} // namespace clothlab::render
