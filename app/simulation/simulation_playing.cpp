// The part of the simulation that plays: what Playback says, by the clock.
#include "app/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace clothlab {

void Simulation::play() {
    if (!m_playing)
        begin(Direction::Forward);
}

void Simulation::playBackward() {
    if (!m_playing || m_playback.direction() != Direction::Backward)
        begin(Direction::Backward);
}

void Simulation::begin(Direction direction) {
    dropPending();
    m_live = false;
    const std::optional<int> from = m_playback.begin(direction, currentFrame(), played(), milliseconds());
    if (!from) {
        emit notice(m_recording.lastFrame() == 0
                        ? tr("Nothing is recorded yet: Play, without a loop, records.")
                        : tr("There is nothing to play between the in and the out point."));
        pause();
        return;
    }
    setPlaying(true);
    if (*from != currentFrame())
        show(*from);
    advance();
}

void Simulation::setPlayback(const PlaybackSettings& settings) {
    if (settings == playback())
        return;
    m_playback.setSettings(settings, milliseconds());
    emit playbackChanged();
    if (m_playing)
        advance();
}

double Simulation::milliseconds() const {
    return double(m_sinceBegin.nsecsElapsed()) * 1e-6;
}

Playback::Played Simulation::played() const {
    const Take& take = *m_recording.take();
    return {m_recording.lastFrame(), m_recording.endOfRun(), take.marks().range,
            [&take](int frame) { return take.frame(frame).time; },
            1.0 / m_document.scene().simulation.framesPerSecond};
}

void Simulation::advance() {
    if (!m_playing)
        return;
    const double now = milliseconds();
    if (m_ready && m_playback.isDue(now))
        record(std::exchange(m_ready, nullptr));
    const Playback::Step step = m_playback.step(currentFrame(), played(), now);
    const bool turned = std::exchange(m_live, step.records) != step.records;
    if (step.frame != currentFrame())
        show(step.frame);
    if (turned)
        emit playbackChanged();
    if (!m_playing)
        return; // who saw it paused
    if (step.ended) {
        pause();
        return;
    }
    const double wait = step.due - milliseconds();
    // A new one that is due comes when it is computed.
    if (wait > 0 || !step.records)
        m_clock.start(std::max(0, int(std::ceil(wait))));
    // It is computed ahead, while the one before it is looked at.
    if (step.records && !m_ready && !isSimulating())
        requestFrame();
}

} // namespace clothlab
