// The view of the scene: the picture, the camera and the mouse. Works without OpenGL but for the picture.
#pragma once

#include "app/document/document.h"
#include "app/picture/camera.h"
#include "app/render/problem.h"
#include "app/render/render_frame.h"
#include "app/simulation/simulation.h"
#include "app/viewport/overlay.h"

#include <QWidget>

namespace clothlab {

class GlCanvas;

class Viewport : public QWidget {
    Q_OBJECT

public:
    Viewport(Document& document, Simulation& simulation, QWidget* parent = nullptr);

    void setDirectories(const QString& shaders, const QString& textures);
    void reloadShaders(); // they were edited
    void reloadFiles();   // shaders and textures
    bool hasPicture() const { return m_canvas != nullptr; }
    const Overlay& overlay() const { return *m_overlay; }

    const Camera& camera() const { return m_camera; }
    void setCamera(const Camera& camera);

    // Logical pixels. What a click there would select.
    std::optional<Selection::Item> itemAt(QPointF position) const;
    QPointF positionOf(int point) const;

    const render::RenderFrame& renderFrame();   // of what is shown now
    render::RenderFrame frameFor(QSize pixels); // the same for a picture of that size
    const render::Problems& problems() const { return m_problems; }

public slots:
    void goHome();
    void frameSelection(); // everything if nothing is selected
    void frameAll();
    void look(clothlab::ViewDirection direction);
    void toggleOrthographic();
    void beginBoxSelection(); // the next left drag selects the points in a box

signals:
    void cameraChanged();
    void problemsChanged(); // problems()
    // The shader that is drawn, and what can be set of it.
    void shaderShown(const QString& shader, const std::vector<clothlab::render::UniformSpec>& uniforms);
    void tabPressed();

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Drag { None, Press, Orbit, Pan, Box };

    void showPlaceholder(const QString& reason);
    void refresh();      // paint again
    void refreshSheet(); // as above, with new positions
    void refreshScene(); // as above, with a new look
    void updateBadges();
    void updateHint();
    void buildFrame();
    void buildHighlight();
    void updateLegend();
    void select(std::optional<Selection::Item> item, Qt::KeyboardModifiers modifiers);
    void selectBox(Qt::KeyboardModifiers modifiers);
    void frameBox(const std::vector<int>& points);
    void setDrag(Drag drag);

    Document& m_document;
    Simulation& m_simulation;
    Camera m_camera;
    GlCanvas* m_canvas = nullptr; // null: no OpenGL
    Overlay* m_overlay;

    render::RenderFrame m_frame;
    bool m_frameIsCurrent = false;
    QString m_shaderDirectory;
    bool m_shaderTakesStrain = false;
    bool m_lookIsCurrent = false;
    bool m_positionsAreCurrent = false;
    render::Problems m_problems;

    Drag m_drag = Drag::None;
    bool m_hasOrbited = false; // by the mouse
    bool m_boxArmed = false;
    QPointF m_pressed, m_previous;
};

} // namespace clothlab
