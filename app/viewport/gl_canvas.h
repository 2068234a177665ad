// The QOpenGLWidget that shows a RenderFrame. Handles no events: the viewport around it does.
#pragma once

#include "app/render/renderer.h"

#include <QOpenGLWidget>

#include <functional>

namespace clothlab {

class GlCanvas : public QOpenGLWidget {
    Q_OBJECT

public:
    // frame is called in the paint call; it must be quick.
    explicit GlCanvas(std::function<const render::RenderFrame&()> frame, QWidget* parent = nullptr);
    ~GlCanvas() override;

    void setDirectories(const QString& shaders, const QString& textures);
    void reloadShaders();
    void reloadFiles(); // shaders and textures

    // Why this platform can show no OpenGL picture, in words; empty if it can. Makes no widget.
    static QString whyUnavailable();

signals:
    void problemsChanged(const clothlab::render::Problems& problems); // of the files in use
    void shaderShown(const QString& shader, const std::vector<clothlab::render::UniformSpec>& uniforms);
    void failed(const QString& reason); // nothing can be drawn

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void releaseGl();
    void tellWhatIsNew();

    std::function<const render::RenderFrame&()> m_frame;
    render::Renderer m_renderer;
    render::Problems m_problems;
    QString m_shader;
    int m_builds = 0; // of shaders, when last looked
    std::vector<render::UniformSpec> m_uniforms;
    QMetaObject::Connection m_contextConnection;
};

} // namespace clothlab
