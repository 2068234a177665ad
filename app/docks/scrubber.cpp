#include "app/docks/scrubber.h"

#include "app/docks/frame_preview.h"
#include "app/widgets/theme.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace clothlab {
namespace {

constexpr int kShortest = 90;
constexpr int kFramesAtOnce = 20'000; // of the plot, so that a long recording stops nothing
constexpr double kReach = 6;          // pixels around what can be grabbed
constexpr double kInward = 3;         // from the frame to the middle of a bracket

} // namespace

Scrubber::Scrubber(Document& document, Simulation& simulation, QWidget* parent)
    : QWidget(parent), m_document(document), m_simulation(simulation),
      m_preview(new FramePreview(simulation, this)) {
    setObjectName("scrubber");
    setAccessibleName(tr("Timeline"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMouseTracking(true);
    m_delivery.setSingleShot(true); // at once, but after the mouse events that wait
    connect(&m_delivery, &QTimer::timeout, this, &Scrubber::deliver);
    connect(&simulation, &Simulation::recordingChanged, this, &Scrubber::readRecording);
    connect(&simulation, &Simulation::takesChanged, this, &Scrubber::forgetPicture);
    connect(&simulation, &Simulation::frameShown, this, &Scrubber::readPlaying);
    connect(&simulation, &Simulation::playingChanged, this, &Scrubber::readPlaying);
    connect(&simulation, &Simulation::playbackChanged, this, &Scrubber::readPlaying);
    connect(&simulation, &Simulation::marksChanged, this, qOverload<>(&QWidget::update));
    connect(&document, &Document::sceneChanged, this, &Scrubber::forgetPicture);
    readRecording();
}

QSize Scrubber::sizeHint() const {
    return {400, 2 * fontMetrics().height() + 68};
}

QSize Scrubber::minimumSizeHint() const {
    return {200, 2 * fontMetrics().height() + 56};
}

void Scrubber::setQuantity(PlotQuantity quantity) {
    m_plot.setQuantity(quantity);
    readRecording();
    forgetPicture();
}

// --- what is recorded

void Scrubber::readRecording() {
    const TakePointer& take = m_simulation.recording().take();
    int span = kShortest;
    while (span < take->lastFrame())
        span *= 2;
    const int known = m_plot.frameCount();
    const bool another = std::exchange(m_take, take->id()) != take->id();
    if (m_plot.extend(take, kFramesAtOnce))
        QTimer::singleShot(0, this, &Scrubber::readRecording);
    if (another || std::exchange(m_span, span) != span || m_plot.frameCount() != known)
        forgetPicture();
    m_span = span;
    if (another) {
        m_selected.reset();
        finishRenaming(false);
    }
    readPlaying();
}

void Scrubber::readPlaying() {
    if (!m_simulation.isRecordingLive())
        m_liveFrom = -1;
    else if (m_liveFrom < 0 || m_liveFrom > m_simulation.recording().lastFrame())
        m_liveFrom = m_simulation.currentFrame();
    update();
}

void Scrubber::forgetPicture() {
    m_picture = {};
    m_sinceSpilled.invalidate();
    update();
}

double Scrubber::timeOf(int frame) const {
    const Take& take = *m_simulation.recording().take();
    const int recorded = std::min(frame, take.lastFrame());
    return take.frame(recorded).time +
           double(frame - recorded) / m_document.scene().simulation.framesPerSecond;
}

Scrubber::Part Scrubber::partOf(int frame) const {
    const Recording& recording = m_simulation.recording();
    if (recording.isStale(frame))
        return Part::Stale;
    if (m_liveFrom >= 0 && frame >= m_liveFrom)
        return Part::Live;
    const RecordedFrame& recorded = recording.frame(frame);
    const bool inMemory = recorded.exact || !recorded.group || recorded.group->payload->bytesInMemory() > 0;
    return inMemory ? Part::Recorded : Part::Spilled;
}

// --- places

QRectF Scrubber::track() const {
    constexpr double margin = 8;
    const double labels =
        m_plot.quantity() == PlotQuantity::None ? margin : fontMetrics().horizontalAdvance("−99.9 mJ") + 8;
    return {margin, 0, width() - margin - labels, double(height())};
}

QRectF Scrubber::bar() const {
    return {track().left(), double(height()) - 15, track().width(), 11};
}

QRectF Scrubber::marksRow() const {
    const double rowHeight = fontMetrics().height();
    return {track().left(), rowHeight + 5, track().width(), rowHeight};
}

QRectF Scrubber::plotArea() const {
    const double top = marksRow().bottom() + 1;
    return {track().left(), top, track().width(), bar().top() - 1 - top};
}

double Scrubber::positionOf(double frame) const {
    return track().left() + track().width() * frame / m_span;
}

int Scrubber::frameAt(double x) const {
    const double ratio = (x - track().left()) / std::max(1.0, track().width());
    return std::clamp(int(std::lround(ratio * m_span)), 0, m_simulation.recording().lastFrame());
}

Scrubber::Hit Scrubber::hitAt(QPointF position) const {
    if (!marksRow().adjusted(-kReach, 0, kReach, 0).contains(position))
        return {};
    const TakeMarks& marks = m_simulation.marks();
    const auto distance = [&](int frame, double inward = 0) {
        return std::abs(positionOf(frame) + inward - position.x());
    };
    Hit hit;
    double nearest = kReach;
    for (const Marker& marker : marks.markers)
        if (distance(marker.frame) <= nearest) {
            nearest = distance(marker.frame);
            hit.marker = marker.frame;
        }
    if (!marks.range)
        return hit;
    if (marks.range->in > 0 && distance(marks.range->in, kInward) < nearest) {
        nearest = distance(marks.range->in, kInward);
        hit = {Handle::In, std::nullopt};
    }
    if (marks.range->out != kOpenEnd && distance(marks.range->out, -kInward) < nearest)
        hit = {Handle::Out, std::nullopt};
    return hit;
}

// --- the mouse

void Scrubber::ask(int frame) {
    m_asked = frame;
    m_delivery.start(0);
}

void Scrubber::deliver() {
    m_delivery.stop();
    if (const auto frame = std::exchange(m_asked, std::nullopt))
        emit frameRequested(*frame);
}

void Scrubber::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    static int gestures = 0;
    m_preview->dismiss();
    const Hit hit = hitAt(event->position());
    m_selected = hit.marker;
    m_dragged = hit.handle;
    m_gesture = ++gestures;
    m_scrubbing = !hit.marker && hit.handle == Handle::None;
    if (hit.marker)
        setFocus(Qt::MouseFocusReason);
    if (hit.handle == Handle::None) {
        ask(hit.marker.value_or(frameAt(event->position().x())));
        deliver();
    }
    update();
}

void Scrubber::mouseMoveEvent(QMouseEvent* event) {
    if (!event->buttons().testFlag(Qt::LeftButton))
        hover(event->position());
    else if (m_dragged != Handle::None)
        dragHandle(event->position().x());
    else if (m_scrubbing)
        ask(frameAt(event->position().x()));
}

void Scrubber::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    deliver();
    m_dragged = Handle::None;
    m_scrubbing = false;
}

void Scrubber::dragHandle(double x) {
    const InOutPoints range = m_simulation.marks().range.value_or(InOutPoints{});
    if (m_dragged == Handle::In)
        m_simulation.setInPoint(std::min(frameAt(x), range.out), m_gesture);
    else
        m_simulation.setOutPoint(std::max(frameAt(x), range.in), m_gesture);
}

void Scrubber::mouseDoubleClickEvent(QMouseEvent* event) {
    const Hit hit = hitAt(event->position());
    if (hit.marker)
        renameMarker(*hit.marker);
    else
        mousePressEvent(event);
}

void Scrubber::hover(QPointF position) {
    const Hit hit = hitAt(position);
    if (hit.handle != Handle::None)
        setCursor(Qt::SizeHorCursor);
    else if (hit.marker)
        setCursor(Qt::PointingHandCursor);
    else
        unsetCursor();
    const double recordedEnd = positionOf(m_simulation.recording().lastFrame()) + kReach;
    const bool overFrames = position.y() >= plotArea().top() && position.x() <= recordedEnd;
    if (!overFrames || m_nameField) {
        m_preview->dismiss();
        return;
    }
    const int frame = frameAt(position.x());
    m_preview->ask(frame, describe(frame), mapToGlobal(QPoint(int(position.x()), int(plotArea().top()))));
}

QString Scrubber::describe(int frame) const {
    QString text = tr("Frame %1 · %2 s · %3")
                       .arg(frame)
                       .arg(QString::number(timeOf(frame), 'f', 3), nameOf(partOf(frame)));
    if (frame < m_plot.frameCount())
        text += '\n' + quantityName(m_plot.quantity()) + ' ' +
                quantityText(m_plot.quantity(), double(m_plot.extent(frame, frame + 1).greatest));
    return text;
}

void Scrubber::leaveEvent(QEvent* event) {
    m_preview->dismiss();
    QWidget::leaveEvent(event);
}

bool Scrubber::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const Hit hit = hitAt(help->pos());
    QString text;
    if (hit.marker) {
        const Marker* marker = findMarker(m_simulation.marks(), *hit.marker);
        text = tr("%1, frame %2. Double-click to rename, Delete removes it.")
                   .arg(QString::fromStdString(marker->name))
                   .arg(marker->frame);
    } else if (hit.handle != Handle::None) {
        text = hit.handle == Handle::In ? tr("In point: playing begins here. Drag it.")
                                        : tr("Out point: playing ends here. Drag it.");
    } else if (help->pos().y() < plotArea().top()) {
        text = legend();
    }
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

// --- markers

void Scrubber::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete && m_selected)
        m_simulation.removeMarker(*std::exchange(m_selected, std::nullopt));
    else if (event->key() == Qt::Key_F2 && m_selected)
        renameMarker(*m_selected);
    else
        QWidget::keyPressEvent(event);
}

void Scrubber::focusOutEvent(QFocusEvent* event) {
    if (!m_nameField && event->reason() != Qt::PopupFocusReason)
        m_selected.reset();
    update();
    QWidget::focusOutEvent(event);
}

void Scrubber::contextMenuEvent(QContextMenuEvent* event) {
    m_preview->dismiss();
    const QPointF position = event->pos();
    const int frame = frameAt(position.x());
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto add = [&](const QString& text, auto action) {
        connect(menu->addAction(text), &QAction::triggered, this, action);
    };
    if (const auto marker = hitAt(position).marker) {
        add(tr("Go to This Marker"), [this, marker] { emit frameRequested(*marker); });
        add(tr("Rename This Marker…"), [this, marker] { renameMarker(*marker); });
        add(tr("Remove This Marker"), [this, marker] { m_simulation.removeMarker(*marker); });
    } else if (!findMarker(m_simulation.marks(), frame)) {
        add(tr("Add a Marker at Frame %1…").arg(frame), [this, frame] {
            m_simulation.setMarker(frame, tr("Marker %1").arg(m_simulation.marks().markers.size() + 1));
            renameMarker(frame);
        });
    }
    menu->addSeparator();
    add(tr("In Point at Frame %1").arg(frame), [this, frame] { m_simulation.setInPoint(frame); });
    add(tr("Out Point at Frame %1").arg(frame), [this, frame] { m_simulation.setOutPoint(frame); });
    if (m_simulation.marks().range)
        add(tr("Clear In and Out Point"), [this] { m_simulation.clearRange(); });
    menu->popup(event->globalPos());
}

void Scrubber::renameMarker(int frame) {
    const Marker* marker = findMarker(m_simulation.marks(), frame);
    if (!marker)
        return;
    finishRenaming(true);
    m_preview->dismiss();
    m_selected = frame;
    m_nameField = new QLineEdit(QString::fromStdString(marker->name), this);
    m_nameField->setObjectName("markerName");
    m_nameField->setAccessibleName(tr("Name of the marker"));
    m_nameField->setMaxLength(60);
    const int width = fontMetrics().horizontalAdvance('x') * 22;
    const int left = int(positionOf(frame)) + 6;
    m_nameField->setGeometry(std::clamp(left, 0, std::max(0, this->width() - width)),
                             int(marksRow().top()) - 3, width, m_nameField->sizeHint().height());
    m_nameField->selectAll();
    m_nameField->show();
    m_nameField->setFocus();
    connect(m_nameField, &QLineEdit::editingFinished, this, [this] { finishRenaming(true); });
    auto* cancel = new QAction(m_nameField);
    cancel->setShortcut(QKeySequence(Qt::Key_Escape));
    cancel->setShortcutContext(Qt::WidgetShortcut);
    m_nameField->addAction(cancel);
    connect(cancel, &QAction::triggered, this, [this] { finishRenaming(false); });
}

void Scrubber::finishRenaming(bool keep) {
    QLineEdit* field = std::exchange(m_nameField, nullptr); // closing it ends editing once more
    if (!field)
        return;
    if (keep && m_selected)
        m_simulation.setMarker(*m_selected, field->text());
    field->hide();
    field->deleteLater();
    update();
}

} // namespace clothlab
