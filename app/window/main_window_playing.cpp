// The part of the main window that plays: speed, loops, in and out points, markers, and what can be used now.
#include "app/docks/timeline_panel.h"
#include "app/window/actions.h"
#include "app/window/main_window.h"

#include <algorithm>

namespace clothlab {
namespace {

// Frame of the next marker in that direction; -1 if there is none.
int markerBeyond(const Simulation& simulation, int direction) {
    int found = -1;
    const int frame = simulation.currentFrame();
    for (const Marker& marker : simulation.marks().markers)
        if ((marker.frame - frame) * direction > 0 && (found < 0 || direction < 0))
            found = marker.frame; // they are in order
    return found;
}

} // namespace

void MainWindow::connectPlaybackActions() {
    Simulation* s = &m_simulation;
    connect(m_actions->playBackward, &QAction::triggered, s, &Simulation::togglePlayingBackward);
    const auto change = [s](auto how) {
        return [s, how] {
            PlaybackSettings settings = s->playback();
            how(settings);
            s->setPlayback(settings);
        };
    };
    connect(m_actions->faster, &QAction::triggered, s,
            change([](PlaybackSettings& settings) { settings.speed = fasterThan(settings.speed); }));
    connect(m_actions->slower, &QAction::triggered, s,
            change([](PlaybackSettings& settings) { settings.speed = slowerThan(settings.speed); }));
    connect(m_actions->loop, &QAction::triggered, s, change([](PlaybackSettings& settings) {
                settings.repeat = settings.repeat == Repeat::Once ? Repeat::Loop : Repeat::Once;
            }));
    connect(m_actions->setIn, &QAction::triggered, s, [s] { s->setInPoint(s->currentFrame()); });
    connect(m_actions->setOut, &QAction::triggered, s, [s] { s->setOutPoint(s->currentFrame()); });
    connect(m_actions->clearRange, &QAction::triggered, s, &Simulation::clearRange);
    connect(m_actions->addMarker, &QAction::triggered, s,
            [s] { s->setMarker(s->currentFrame(), tr("Marker %1").arg(s->marks().markers.size() + 1)); });
    connect(m_actions->nextMarker, &QAction::triggered, s, [s] { s->showFrame(markerBeyond(*s, 1)); });
    connect(m_actions->previousMarker, &QAction::triggered, s, [s] { s->showFrame(markerBeyond(*s, -1)); });
    for (const auto signal : {&Simulation::playbackChanged, &Simulation::marksChanged})
        connect(s, signal, this, &MainWindow::updateTransport);
    connect(s, &Simulation::playingChanged, this, &MainWindow::updateTransport);
}

// Not whether it repeats: who plays in a new session wants to see the cloth move on.
void MainWindow::keepPlayback() {
    const PlaybackSettings& playback = m_simulation.playback();
    m_settings->setValue("playbackSpeed", playback.speed);
    m_settings->setValue("playInRealTime", playback.realTime);
    m_settings->setValue("plotQuantity", int(m_timelinePanel->quantity()));
}

void MainWindow::restorePlayback() {
    PlaybackSettings playback = m_simulation.playback();
    const double speed = m_settings->value("playbackSpeed", playback.speed).toDouble();
    if (std::ranges::count(kSpeeds, speed) > 0)
        playback.speed = speed;
    playback.realTime = m_settings->value("playInRealTime", playback.realTime).toBool();
    m_simulation.setPlayback(playback);
    const int quantity = int(m_timelinePanel->quantity());
    m_timelinePanel->setQuantity(PlotQuantity(m_settings->value("plotQuantity", quantity).toInt()));
}

void MainWindow::updateTransport() {
    const int frame = m_simulation.currentFrame();
    const int last = m_simulation.recording().lastFrame();
    for (QAction* action : {m_actions->stepBack, m_actions->tenBack, m_actions->firstFrame})
        setUsable(action, frame > 0, tr("This is the first frame"));
    for (QAction* action : {m_actions->stepForward, m_actions->tenForward, m_actions->lastFrame})
        setUsable(action, frame < last, tr("This is the last recorded frame; N simulates one more"));

    const PlaybackSettings& playback = m_simulation.playback();
    m_actions->showPlaying(m_simulation.isPlaying(), m_simulation.isPlayingBackward());
    m_actions->loop->setChecked(playback.repeat != Repeat::Once);
    setUsable(m_actions->playBackward, last > 0, tr("Nothing is recorded yet"));
    setUsable(m_actions->faster, playback.speed < kSpeeds.back(), tr("This is the greatest speed"));
    setUsable(m_actions->slower, playback.speed > kSpeeds.front(), tr("This is the least speed"));

    const TakeMarks& marks = m_simulation.marks();
    setUsable(m_actions->setIn, frame > 0 || marks.range, tr("Playing begins at the first frame anyway"));
    setUsable(m_actions->clearRange, marks.range.has_value(), tr("There is no in point and no out point"));
    setUsable(m_actions->addMarker, !findMarker(marks, frame),
              tr("This frame has a marker; double-click it in the timeline to rename it"));
    setUsable(m_actions->nextMarker, markerBeyond(m_simulation, 1) >= 0, tr("No marker follows"));
    setUsable(m_actions->previousMarker, markerBeyond(m_simulation, -1) >= 0, tr("No marker comes before"));
}

} // namespace clothlab
