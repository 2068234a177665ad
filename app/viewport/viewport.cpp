#include "app/viewport/viewport.h"

#include "app/viewport/gl_canvas.h"
#include "app/viewport/picking.h"
#include "app/widgets/theme.h"

#include <QApplication>
#include <QMouseEvent>

#include <algorithm>
#include <numeric>

namespace clothlab {

Viewport::Viewport(Document& document, Simulation& simulation, QWidget* parent)
    : QWidget(parent), m_document(document), m_simulation(simulation), m_overlay(new Overlay(this)) {
    setObjectName("viewport");
    setAccessibleName(tr("View of the cloth"));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, 180);

    if (const QString reason = GlCanvas::whyUnavailable(); !reason.isEmpty()) {
        showPlaceholder(reason);
    } else {
        m_canvas = new GlCanvas([this]() -> const render::RenderFrame& { return renderFrame(); }, this);
        connect(m_canvas, &GlCanvas::problemsChanged, this, [this](const render::Problems& problems) {
            m_problems = problems;
            emit problemsChanged();
        });
        connect(m_canvas, &GlCanvas::shaderShown, this, &Viewport::shaderShown);
        connect(m_canvas, &GlCanvas::failed, this, &Viewport::showPlaceholder);
    }
    m_overlay->raise();
    updateHint();

    connect(&document, &Document::sceneReplaced, this, &Viewport::goHome);
    connect(&document, &Document::sceneChanged, this, &Viewport::refreshScene);
    connect(&document, &Document::selectionChanged, this, &Viewport::refresh);
    connect(&simulation, &Simulation::frameShown, this, &Viewport::refreshSheet);
    connect(&simulation, &Simulation::recordingChanged, this, &Viewport::updateBadges);
    connect(&simulation, &Simulation::blowUpChanged, this, &Viewport::updateBadges);
    goHome();
}

void Viewport::showPlaceholder(const QString& reason) {
    m_overlay->setPlaceholder(tr("OpenGL is not available"),
                              tr("There is no picture: %1. Everything else works.").arg(reason));
}

void Viewport::setDirectories(const QString& shaders, const QString& textures) {
    m_shaderDirectory = shaders;
    if (m_canvas)
        m_canvas->setDirectories(shaders, textures);
}

void Viewport::reloadShaders() {
    if (m_canvas)
        m_canvas->reloadShaders();
    refreshScene(); // a shader may take other things now
}

void Viewport::reloadFiles() {
    if (m_canvas)
        m_canvas->reloadFiles();
    refreshScene(); // a shader may take other things now
}

void Viewport::setCamera(const Camera& camera) {
    m_camera = camera;
    refresh();
    emit cameraChanged();
}

void Viewport::refresh() {
    m_frameIsCurrent = false;
    if (m_canvas)
        m_canvas->update();
}

void Viewport::refreshSheet() {
    m_positionsAreCurrent = false;
    refresh();
    updateBadges();
}

void Viewport::refreshScene() {
    m_lookIsCurrent = false;
    refreshSheet();
}

void Viewport::updateBadges() {
    std::vector<Overlay::Badge> badges;
    const ThemeColors& colors = themeColors(Theme::Dark);
    if (!m_simulation.blowUp().isEmpty())
        badges.push_back({tr("The cloth %1.").arg(m_simulation.blowUp()), colors.error});
    if (m_simulation.currentFrame() >= m_simulation.firstStaleFrame())
        badges.push_back({tr("Stale: recorded before the last edit"), colors.warning});
    m_overlay->setBadges(std::move(badges));
}

void Viewport::updateHint() {
    if (m_boxArmed)
        m_overlay->setHint(tr("Drag a box around points · Shift adds · Ctrl removes · Esc cancels"));
    else if (m_hasOrbited)
        m_overlay->setHint({}); // whoever does it knows it
    else
        m_overlay->setHint(tr("Left drag orbits · right drag pans · wheel zooms · click selects · B box"));
}

// --- camera

void Viewport::goHome() {
    m_camera.view = m_document.scene().camera.value_or(homeView(m_document.scene().cloth));
    m_camera.orthographic = false;
    refreshScene();
    emit cameraChanged();
}

void Viewport::frameBox(const std::vector<int>& points) {
    const PointArray& position = m_simulation.shownFrame()->state.position;
    Eigen::AlignedBox3d box;
    for (const int point : points)
        box.extend(position.at(point));
    if (box.isEmpty())
        return;
    const Vec3 centre = box.center();
    m_camera.frame({float(centre.x()), float(centre.y()), float(centre.z())},
                   std::max(0.05, box.diagonal().norm() / 2), size());
    refresh();
    emit cameraChanged();
}

void Viewport::frameSelection() {
    std::vector<int> points;
    for (const Selection::Item& item : m_document.selection().items) {
        if (item.kind == Selection::Kind::Point) {
            points.push_back(item.number);
        } else {
            const Spring spring = m_document.grid().spring(item.number);
            points.insert(points.end(), {spring.a, spring.b});
        }
    }
    if (points.empty())
        frameAll();
    else
        frameBox(points);
}

void Viewport::frameAll() {
    std::vector<int> points(m_simulation.shownFrame()->state.size());
    std::iota(points.begin(), points.end(), 0);
    frameBox(points);
}

void Viewport::look(ViewDirection direction) {
    m_camera.look(direction);
    refresh();
    emit cameraChanged();
}

void Viewport::toggleOrthographic() {
    m_camera.orthographic = !m_camera.orthographic;
    refresh();
    emit cameraChanged();
}

// --- selection

std::optional<Selection::Item> Viewport::itemAt(QPointF position) const {
    const Appearance& appearance = m_document.scene().appearance;
    PickQuery query;
    query.position = position;
    query.size = size();
    query.springs = appearance.springsDrawn;
    query.surfaceHides = appearance.shader != "Wireframe";
    query.spheres = m_document.scene().spheres;
    return pick(m_camera, m_document.grid(), m_simulation.shownFrame()->state.position, query);
}

QPointF Viewport::positionOf(int point) const {
    const Vec3 p = m_simulation.shownFrame()->state.position.at(point);
    return m_camera.project({float(p.x()), float(p.y()), float(p.z())}, size()).position;
}

void Viewport::select(std::optional<Selection::Item> item, Qt::KeyboardModifiers modifiers) {
    const bool adds = modifiers.testFlag(Qt::ShiftModifier);
    const bool removes = modifiers.testFlag(Qt::ControlModifier);
    Selection selection = adds || removes ? m_document.selection() : Selection{};
    if (item && removes)
        selection.remove(*item);
    else if (item)
        selection.add(*item);
    m_document.setSelection(std::move(selection));
}

void Viewport::selectBox(Qt::KeyboardModifiers modifiers) {
    const bool adds = modifiers.testFlag(Qt::ShiftModifier);
    const bool removes = modifiers.testFlag(Qt::ControlModifier);
    Selection selection = adds || removes ? m_document.selection() : Selection{};
    const QRectF box = QRectF(m_pressed, m_previous).normalized();
    for (const int point : pointsIn(box, m_camera, m_simulation.shownFrame()->state.position, size())) {
        const Selection::Item item{Selection::Kind::Point, point};
        if (removes)
            selection.remove(item);
        else if (!adds || !selection.contains(item))
            selection.items.push_back(item);
    }
    m_document.setSelection(std::move(selection));
}

void Viewport::beginBoxSelection() {
    m_boxArmed = true;
    setCursor(Qt::CrossCursor);
    updateHint();
}

// --- events

bool Viewport::event(QEvent* event) {
    // Here Tab does not move the focus.
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Tab) {
        emit tabPressed();
        return true;
    }
    return QWidget::event(event);
}

void Viewport::resizeEvent(QResizeEvent* /*event*/) {
    if (m_canvas)
        m_canvas->setGeometry(rect());
    m_overlay->setGeometry(rect());
    refresh();
}

void Viewport::setDrag(Drag drag) {
    m_drag = drag;
    if (drag != Drag::None)
        return;
    m_boxArmed = false;
    m_overlay->setSelectionBox({});
    unsetCursor();
    updateHint();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    m_pressed = m_previous = event->position();
    const bool pans = event->button() == Qt::RightButton || event->button() == Qt::MiddleButton;
    if (pans)
        setDrag(Drag::Pan);
    else if (event->button() == Qt::LeftButton)
        setDrag(m_boxArmed ? Drag::Box : Drag::Press);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    const QPointF moved = event->position() - m_previous;
    if (m_drag == Drag::Press) {
        // A hand that clicks trembles.
        if ((event->position() - m_pressed).manhattanLength() < QApplication::startDragDistance())
            return;
        setDrag(event->modifiers().testFlag(Qt::ShiftModifier) ? Drag::Pan : Drag::Orbit);
    }
    m_previous = event->position();
    if (m_drag == Drag::Box)
        m_overlay->setSelectionBox(QRectF(m_pressed, m_previous).toRect());
    if (m_drag != Drag::Orbit && m_drag != Drag::Pan)
        return;
    m_hasOrbited = m_hasOrbited || m_drag == Drag::Orbit;
    if (m_drag == Drag::Orbit)
        m_camera.orbit(moved);
    else
        m_camera.pan(moved, size());
    refresh();
    emit cameraChanged();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (m_drag == Drag::Press)
        select(itemAt(m_pressed), event->modifiers());
    else if (m_drag == Drag::Box)
        selectBox(event->modifiers());
    setDrag(Drag::None);
}

void Viewport::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    m_camera.zoom(std::pow(0.88, notches), event->position(), size());
    refresh();
    emit cameraChanged();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape)
        QWidget::keyPressEvent(event);
    else if (m_boxArmed || m_drag != Drag::None)
        setDrag(Drag::None);
    else
        m_document.setSelection({});
}

} // namespace clothlab
