#include "app/docks/timeline_panel.h"

#include "app/docks/text.h"
#include "app/widgets/number_field.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace clothlab {

TimelinePanel::TimelinePanel(Document& document, Simulation& simulation, const QList<QAction*>& transport,
                             QWidget* parent)
    : QWidget(parent), m_document(document), m_simulation(simulation), m_scrubber(new Scrubber),
      m_frame(new NumberField), m_last(new QLabel), m_time(new QLabel), m_state(new QLabel) {
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    for (QAction* action : transport) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus);
        row->addWidget(button);
    }
    row->addSpacing(8);
    m_frame->setObjectName("frameField");
    m_frame->setInteger(true);
    m_frame->setSmallestStep(1);
    m_frame->setAccessibleName(tr("Frame"));
    m_frame->setToolTip(tr("The frame that is shown. Type one to go there."));
    m_frame->setFixedWidth(fontMetrics().horizontalAdvance("0000000000"));
    row->addWidget(new QLabel(tr("Frame")));
    row->addWidget(m_frame);
    row->addWidget(m_last);
    row->addSpacing(12);
    m_time->setMinimumWidth(fontMetrics().horizontalAdvance("0000.000 s"));
    row->addWidget(m_time);
    row->addSpacing(12);
    row->addWidget(m_state);
    row->addStretch();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(0);
    layout->addLayout(row);
    layout->addWidget(m_scrubber);

    connect(m_scrubber, &Scrubber::frameRequested, &simulation, &Simulation::showFrame);
    connect(m_frame, &NumberField::valueEdited, this,
            [this](double value) { m_simulation.showFrame(int(value)); });
    connect(m_frame, &NumberField::rejected, this, &TimelinePanel::rejected);
    connect(&simulation, &Simulation::recordingChanged, this, &TimelinePanel::showRecording);
    connect(&simulation, &Simulation::frameShown, this, &TimelinePanel::showFrame);
    connect(&simulation, &Simulation::playingChanged, this, &TimelinePanel::showState);
    connect(&document, &Document::sceneChanged, this, &TimelinePanel::showRecording);
    showRecording();
    showFrame();
}

void TimelinePanel::showRecording() {
    const Recording& recording = m_simulation.recording();
    m_scrubber->setRecording(recording.frameCount(), m_simulation.firstStaleFrame());
    m_scrubber->setFramesPerSecond(m_document.scene().simulation.framesPerSecond);
    m_frame->setRange(0, recording.lastFrame());
    m_last->setText(QStringLiteral("/ %1").arg(recording.lastFrame()));
    showState();
}

void TimelinePanel::showFrame() {
    m_scrubber->setCurrent(m_simulation.currentFrame());
    m_frame->setValue(m_simulation.currentFrame());
    m_time->setText(QStringLiteral("%1 s").arg(m_simulation.shownFrame()->time, 0, 'f', 3));
    showState();
}

void TimelinePanel::showState() {
    const bool atEnd = m_simulation.currentFrame() == m_simulation.recording().lastFrame();
    if (m_simulation.currentFrame() >= m_simulation.firstStaleFrame())
        m_state->setText(tr("Stale"));
    else if (!m_simulation.isPlaying())
        m_state->setText(tr("Paused"));
    else
        m_state->setText(atEnd ? tr("Simulating") : tr("Playing the recording"));
}

} // namespace clothlab
