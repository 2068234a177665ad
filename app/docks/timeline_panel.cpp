#include "app/docks/timeline_panel.h"

#include "app/docks/frame_preview.h"
#include "app/docks/playback_controls.h"
#include "app/widgets/flow_row.h"
#include "app/widgets/number_field.h"
#include "app/widgets/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace clothlab {
namespace {

// A part of the row that stays together.
std::pair<QWidget*, QHBoxLayout*> makePart(int spacing) {
    auto* part = new QWidget;
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(spacing);
    return {part, row};
}

// To as many digits as a field shows: what stands there may be typed again.
double roundedUp(double seconds) {
    if (!(seconds > 0))
        return 0;
    const double step = std::pow(10.0, std::floor(std::log10(seconds)) - 4);
    return std::ceil(seconds / step - 1e-6) * step;
}

} // namespace

TimelinePanel::TimelinePanel(Document& document, Simulation& simulation, const QList<QAction*>& transport,
                             QWidget* parent)
    : QWidget(parent), m_simulation(simulation), m_scrubber(new Scrubber(document, simulation)),
      m_frame(new NumberField), m_time(new NumberField), m_last(new QLabel), m_state(new QLabel),
      m_quantity(new QComboBox) {
    auto* row = new FlowRow;
    row->add(makeButtons(transport));
    row->add(makeFields());
    row->add(makeChoices());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(2);
    layout->addWidget(row);
    layout->addWidget(m_scrubber, 1);

    connect(m_scrubber, &Scrubber::frameRequested, &simulation, &Simulation::showFrame);
    connect(m_frame, &NumberField::valueEdited, this,
            [this](double value) { m_simulation.showFrame(int(value)); });
    connect(m_time, &NumberField::valueEdited, this, &TimelinePanel::goToTime);
    for (NumberField* field : {m_frame, m_time})
        connect(field, &NumberField::rejected, this, &TimelinePanel::rejected);
    connect(&simulation, &Simulation::recordingChanged, this, &TimelinePanel::showRecording);
    connect(&simulation, &Simulation::frameShown, this, &TimelinePanel::showFrame);
    connect(&simulation, &Simulation::playingChanged, this, &TimelinePanel::showState);
    connect(&simulation, &Simulation::playbackChanged, this, &TimelinePanel::showState);
    showRecording();
    showFrame();
}

QWidget* TimelinePanel::makeButtons(const QList<QAction*>& transport) {
    const auto [part, row] = makePart(2);
    for (QAction* action : transport) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus);
        row->addWidget(button);
    }
    return part;
}

QWidget* TimelinePanel::makeFields() {
    const auto [part, row] = makePart(4);
    m_frame->setObjectName("frameField");
    m_frame->setInteger(true);
    m_frame->setAccessibleName(tr("Frame"));
    m_frame->setToolTip(tr("The frame that is shown. Type one to go there."));
    m_frame->setFixedWidth(fontMetrics().horizontalAdvance("000000000"));
    m_time->setObjectName("timeField");
    m_time->setUnit(tr("s"));
    m_time->setAccessibleName(tr("Time"));
    m_time->setToolTip(
        tr("Simulated time of the frame that is shown, in seconds. Type one to go to the nearest frame."));
    m_time->setFixedWidth(fontMetrics().horizontalAdvance("0000.000000 s"));
    m_frame->setSmallestStep(1);
    for (const char* text : {"● Live", "Backward"}) // it pushes nothing around
        m_state->setMinimumWidth(
            std::max(m_state->minimumWidth(), fontMetrics().horizontalAdvance(tr(text)) + 4));
    row->addWidget(new QLabel(tr("Frame")));
    row->addWidget(m_frame);
    row->addWidget(m_last);
    row->addSpacing(6);
    row->addWidget(m_time);
    row->addSpacing(6);
    row->addWidget(m_state);
    return part;
}

QWidget* TimelinePanel::makeChoices() {
    const auto [part, row] = makePart(4);
    m_quantity->setObjectName("plotQuantity");
    m_quantity->setAccessibleName(tr("Plot behind the timeline"));
    m_quantity->setToolTip(tr("What is plotted behind the timeline: of all point masses together, of springs "
                              "that are switched on, and how many point masses touch something."));
    for (const PlotQuantity quantity : {PlotQuantity::KineticEnergy, PlotQuantity::GreatestStrain,
                                        PlotQuantity::Contacts, PlotQuantity::None})
        m_quantity->addItem(quantityName(quantity), int(quantity));
    connect(m_quantity, &QComboBox::activated, this, [this] { m_scrubber->setQuantity(quantity()); });
    row->addWidget(new PlaybackControls(m_simulation));
    row->addWidget(m_quantity);
    return part;
}

void TimelinePanel::setQuantity(PlotQuantity quantity) {
    const int place = m_quantity->findData(int(quantity));
    if (place < 0)
        return;
    m_quantity->setCurrentIndex(place);
    m_scrubber->setQuantity(quantity);
}

void TimelinePanel::setCamera(std::function<Camera()> camera) {
    m_scrubber->preview().setCamera(std::move(camera));
}

void TimelinePanel::showRecording() {
    const Recording& recording = m_simulation.recording();
    const int last = recording.lastFrame();
    m_frame->setRange(0, last);
    m_time->setSmallestStep(1.0 / recording.scene()->simulation.framesPerSecond);
    m_time->setRange(0, roundedUp(recording.frame(last).time));
    m_last->setText(QStringLiteral("/ %1").arg(last));
    m_last->setMinimumWidth(fontMetrics().horizontalAdvance("/ 0000"));
    showState();
}

void TimelinePanel::showFrame() {
    m_frame->setValue(m_simulation.currentFrame());
    m_time->setValue(m_simulation.shownFrame()->time);
    showState();
}

void TimelinePanel::goToTime(double seconds) {
    const Recording& recording = m_simulation.recording();
    int before = 0; // whose time is not later
    int after = recording.lastFrame() + 1;
    while (after - before > 1) {
        const int middle = before + (after - before) / 2;
        (recording.frame(middle).time <= seconds ? before : after) = middle;
    }
    after = std::min(after, recording.lastFrame());
    const bool nearer = recording.frame(after).time - seconds < seconds - recording.frame(before).time;
    m_simulation.showFrame(nearer ? after : before);
    showFrame(); // the time of the frame, even if it was shown already
}

void TimelinePanel::showState() {
    const bool live = m_simulation.isRecordingLive();
    QString text = tr("Paused");
    if (live)
        text = tr("● Live");
    else if (m_simulation.currentFrame() >= m_simulation.firstStaleFrame())
        text = tr("Stale");
    else if (m_simulation.isPlaying())
        text = m_simulation.isPlayingBackward() ? tr("Backward") : tr("Playing");
    if (text == m_state->text())
        return;
    m_state->setText(text);
    m_state->setToolTip(live ? tr("What is shown is simulated and recorded now.") : QString());
    m_state->setStyleSheet(live ? QStringLiteral("color: %1").arg(themeColors().error.name()) : QString());
}

void TimelinePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && m_simulation.isRecordingLive()) {
        m_state->clear();
        showState();
    }
    QWidget::changeEvent(event);
}

} // namespace clothlab
