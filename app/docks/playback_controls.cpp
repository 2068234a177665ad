#include "app/docks/playback_controls.h"

#include <QHBoxLayout>

#include <algorithm>

namespace clothlab {
namespace {

QString speedText(double speed) {
    return speed < 1 ? QStringLiteral("1/%1×").arg(std::lround(1 / speed))
                     : QStringLiteral("%1×").arg(std::lround(speed));
}

} // namespace

PlaybackControls::PlaybackControls(Simulation& simulation, QWidget* parent)
    : QWidget(parent), m_simulation(simulation) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    QStringList speeds;
    for (const double speed : kSpeeds)
        speeds << speedText(speed);
    m_speed =
        addChoice("playbackSpeed", tr("Speed of playing"),
                  tr("Speed of playing, as a multiple of real time ([ and ]). What is simulated while it "
                     "plays comes no faster than it can be computed."),
                  speeds);
    m_pace =
        addChoice("playbackPace", tr("Pace"),
                  tr("Every frame: shows each, and takes longer where drawing is slow. Real time: leaves "
                     "recorded frames out where there is no time to show them; none is left out of what "
                     "is recorded."),
                  {tr("Every frame"), tr("Real time")});
    m_repeat =
        addChoice("playbackRepeat", tr("Repeat"),
                  tr("Once: plays to the out point or, after the last frame, simulates on. Loop (L) and "
                     "ping-pong: between in and out point, again and again; they record nothing."),
                  {tr("Once"), tr("Loop"), tr("Ping-pong")});
    connect(&simulation, &Simulation::playbackChanged, this, &PlaybackControls::showSettings);
    showSettings();
}

QComboBox* PlaybackControls::addChoice(const char* name, const QString& title, const QString& toolTip,
                                       const QStringList& choices) {
    auto* choice = new QComboBox;
    choice->setObjectName(name);
    choice->setAccessibleName(title);
    choice->setToolTip(toolTip);
    choice->addItems(choices);
    choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    layout()->addWidget(choice);
    connect(choice, &QComboBox::activated, this, &PlaybackControls::apply);
    return choice;
}

void PlaybackControls::showSettings() {
    const PlaybackSettings& settings = m_simulation.playback();
    const auto* speed = std::ranges::lower_bound(kSpeeds, settings.speed);
    m_speed->setCurrentIndex(int(speed - kSpeeds.begin()));
    m_pace->setCurrentIndex(settings.realTime ? 1 : 0);
    m_repeat->setCurrentIndex(int(settings.repeat));
}

void PlaybackControls::apply() {
    PlaybackSettings settings;
    settings.speed = kSpeeds[std::size_t(m_speed->currentIndex())];
    settings.realTime = m_pace->currentIndex() == 1;
    settings.repeat = Repeat(m_repeat->currentIndex());
    m_simulation.setPlayback(settings);
}

} // namespace clothlab
