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

    void setShaderDirectory(const QString& directory);

    // Why this platform can show no OpenGL picture, in words; empty if it can. Makes no widget.
    static QString whyUnavailable();

signals:
    void messagesChanged(const QStringList& messages); // of the shaders in use
    void failed(const QString& reason);                // nothing can be drawn

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void releaseGl();

    std::function<const render::RenderFrame&()> m_frame;
    render::Renderer m_renderer;
    QStringList m_messages;
    QMetaObject::Connection m_contextConnection;
};

} // namespace clothlab
