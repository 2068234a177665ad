#include "app/viewport/gl_canvas.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <utility>

namespace clothlab {

GlCanvas::GlCanvas(std::function<const render::RenderFrame&()> frame, QWidget* parent)
    : QOpenGLWidget(parent), m_frame(std::move(frame)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
}

GlCanvas::~GlCanvas() {
    // The context goes after the renderer; it must not call back then.
    disconnect(m_contextConnection);
    releaseGl();
}

void GlCanvas::setDirectories(const QString& shaders, const QString& textures) {
    m_renderer.setShaderDirectory(shaders);
    m_renderer.setTextureDirectory(textures);
    update();
}

void GlCanvas::reloadShaders() {
    m_renderer.reloadShaders();
    update();
}

void GlCanvas::reloadFiles() {
    m_renderer.reloadFiles();
    update();
}

QString GlCanvas::whyUnavailable() {
    // These platforms have no OpenGL widgets, even where they can make a context.
    static const QStringList without{"offscreen", "minimal", "linuxfb", "vnc"};
    if (without.contains(QGuiApplication::platformName()))
        return tr("the Qt platform \"%1\" shows no OpenGL widgets").arg(QGuiApplication::platformName());
    QOpenGLContext context;
    if (!context.create())
        return tr("no OpenGL context could be made; a driver or Mesa's software renderer is missing");
    if (context.format().version() < std::pair(3, 3))
        return tr("OpenGL 3.3 is needed, this machine offers %1.%2")
            .arg(context.format().majorVersion())
            .arg(context.format().minorVersion());
    return {};
}

void GlCanvas::initializeGL() {
    // The context goes when the window is floated or reparented; initializeGL() is called again with the new
    // one.
    disconnect(m_contextConnection);
    m_contextConnection = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlCanvas::releaseGl);
    QString error;
    if (!m_renderer.initialize(&error))
        emit failed(error);
}

void GlCanvas::releaseGl() {
    if (!m_renderer.isInitialized())
        return;
    makeCurrent();
    m_renderer.release();
    doneCurrent();
}

void GlCanvas::paintGL() {
    m_renderer.render(m_frame(), size() * devicePixelRatio());
    tellWhatIsNew();
}

void GlCanvas::tellWhatIsNew() {
    if (m_renderer.problems() != m_problems) {
        m_problems = m_renderer.problems();
        emit problemsChanged(m_problems);
    }
    if (m_renderer.shaderInUse() == m_shader && m_renderer.builds() == m_builds)
        return;
    m_builds = m_renderer.builds();
    std::vector<render::UniformSpec> uniforms = m_renderer.uniforms();
    if (m_renderer.shaderInUse() == m_shader && uniforms == m_uniforms)
        return;
    m_shader = m_renderer.shaderInUse();
    m_uniforms = std::move(uniforms);
    emit shaderShown(m_shader, m_uniforms);
}

} // namespace clothlab
