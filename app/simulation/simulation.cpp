#include "app/simulation/simulation.h"

#include "simcore/inspect/blow_up_text.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace clothlab {
namespace {

bool moveAlike(const Scene& a, const Scene& b) {
    return &a == &b || compareScenes(a, b) <= SceneChange::Appearance;
}

} // namespace

Simulation::Simulation(Document& document, QObject* parent, std::size_t recordingBudget)
    : QObject(parent), m_document(document), m_recording(recordingBudget),
      m_worker([this](FrameOutcome outcome) {
          QMetaObject::invokeMethod(
              this, [this, outcome = std::move(outcome)]() mutable { receive(std::move(outcome)); },
              Qt::QueuedConnection);
      }) {
    m_clock.setSingleShot(true);
    m_clock.setTimerType(Qt::PreciseTimer);
    connect(&m_clock, &QTimer::timeout, this, &Simulation::advance);
    connect(&document, &Document::sceneChanged, this, &Simulation::onSceneChanged);
    connect(&document, &Document::sceneReplaced, this, &Simulation::restart);
    restart();
}

void Simulation::restart() {
    dropPending();
    setPlaying(false);
    const Scene& scene = m_document.scene();
    ClothState start = startState(scene);
    m_sheet = {m_document.grid(), start.position};
    m_recording.restart(
        std::make_shared<const Frame>(Frame{std::move(start), m_document.snapshot(), 0, 0, 0}));
    m_firstStale = 1;
    m_current = 0; // before anyone is told: there must be a frame to show
    m_staleEdits.clear();
    m_scene = m_document.snapshot();
    setBlowUp({});
    emit recordingChanged();
    show(0);
}

void Simulation::onSceneChanged(SceneChange change) {
    auto before = std::exchange(m_scene, m_document.snapshot());
    if (change == SceneChange::Start) {
        if (m_recording.frameCount() > 1)
            emit notice(tr("The sheet has changed: the recording begins anew."));
        restart();
    } else if (change == SceneChange::Motion) {
        setBlowUp({});
        updateStaleness(std::move(before));
    }
}

const Scene& Simulation::shownScene() const {
    const int next = m_current + 1;
    if (next < m_recording.frameCount() && next != m_firstStale)
        return *m_recording.frame(next)->scene;
    return m_current >= m_firstStale ? *shownFrame()->scene : m_document.scene();
}

void Simulation::updateStaleness(std::shared_ptr<const Scene> before) {
    // Frames before the one shown stay what they are: how the run came to be here.
    const int candidate = std::min(m_firstStale, m_current + 1);
    const auto undone = std::ranges::find_if(
        m_staleEdits, [&](const StaleEdit& edit) { return moveAlike(*edit.before, *m_scene); });
    if (undone != m_staleEdits.end()) {
        m_firstStale = undone->firstStale;
        m_staleEdits.erase(undone, m_staleEdits.end());
    } else if (areComputedAs(*m_scene, candidate)) {
        m_firstStale = m_recording.frameCount();
    } else {
        if (candidate < m_firstStale)
            m_staleEdits.push_back({std::move(before), m_firstStale});
        m_firstStale = candidate;
        if (!m_playing)
            dropPending(); // it would follow a stale frame
    }
    emit recordingChanged();
}

bool Simulation::areComputedAs(const Scene& scene, int first) const {
    for (int i = first; i < m_recording.frameCount(); ++i)
        if (!moveAlike(*m_recording.frame(i)->scene, scene))
            return false;
    return true;
}

void Simulation::dropStaleFrames() {
    const int stale = m_recording.frameCount() - m_firstStale;
    if (stale <= 0)
        return;
    m_recording.truncate(m_firstStale);
    m_staleEdits.clear();
    const bool moved = m_current > m_recording.lastFrame();
    m_current = std::min(m_current, m_recording.lastFrame());
    emit notice(tr("%n stale frame(s) replaced.", nullptr, stale));
    emit recordingChanged();
    if (moved)
        emit frameShown();
}

void Simulation::play() {
    if (m_playing)
        return;
    dropPending();
    dropStaleFrames();
    setPlaying(true);
    m_sincePlay.start();
    m_due = 0;
    advance();
}

void Simulation::pause() {
    dropPending();
    setPlaying(false);
}

void Simulation::showFrame(int frame) {
    pause();
    show(std::clamp(frame, 0, m_recording.lastFrame()));
}

void Simulation::simulateFrame() {
    if (m_playing)
        pause();
    if (isSimulating())
        return;
    dropStaleFrames();
    requestFrame();
}

void Simulation::advance() {
    if (!m_playing)
        return;
    if (m_current + 1 >= m_firstStale)
        dropStaleFrames();
    if (m_ready)
        record(std::exchange(m_ready, nullptr));
    if (m_current < m_recording.lastFrame()) {
        show(m_current + 1);
        schedule();
    }
    // At the end the next frame is computed ahead, while this one is looked at.
    if (m_playing && m_current == m_recording.lastFrame() && !isSimulating())
        requestFrame();
}

void Simulation::schedule() {
    const auto now = double(m_sincePlay.nsecsElapsed()) * 1e-6;
    m_due = std::max(m_due + 1000.0 / m_document.scene().simulation.framesPerSecond, now);
    m_clock.start(int(m_due - now));
}

void Simulation::requestFrame() {
    if (m_recording.full()) {
        pause();
        emit notice(tr("The recording is full (%1). Press R for a new one.")
                        .arg(QLocale::c().formattedDataSize(qint64(m_recording.budget()))));
        return;
    }
    m_pendingTicket = ++m_lastTicket;
    m_worker.request({m_pendingTicket, m_document.snapshot(), m_recording.frame(m_recording.lastFrame()),
                      m_recording.frameCount()});
}

void Simulation::dropPending() {
    m_clock.stop();
    m_ready = nullptr;
    if (isSimulating())
        m_worker.cancel();
    m_pendingTicket = 0;
}

void Simulation::receive(FrameOutcome outcome) {
    if (outcome.ticket != m_pendingTicket)
        return;
    m_pendingTicket = 0;
    m_lastComputedOn = outcome.computedOn;
    if (outcome.blowUp) {
        stopForBlowUp(outcome);
    } else if (!m_playing) {
        record(std::move(outcome.frame));
        show(m_recording.lastFrame());
    } else {
        m_ready = std::move(outcome.frame);
        if (!m_clock.isActive()) // it is overdue
            advance();
    }
}

void Simulation::record(FramePointer frame) {
    m_recording.append(std::move(frame));
    m_firstStale = m_recording.frameCount();
    m_staleEdits.clear();
    emit recordingChanged();
}

void Simulation::stopForBlowUp(const FrameOutcome& outcome) {
    pause();
    setBlowUp(QString::fromStdString(
        describeBlowUp(*outcome.blowUp, outcome.blowUpStep, outcome.number, *outcome.scene)));
}

void Simulation::show(int frame) {
    m_current = frame;
    emit frameShown();
}

void Simulation::setPlaying(bool playing) {
    if (playing == m_playing)
        return;
    m_playing = playing;
    emit playingChanged(playing);
}

void Simulation::setBlowUp(const QString& text) {
    if (text == m_blowUp)
        return;
    m_blowUp = text;
    emit blowUpChanged();
}

} // namespace clothlab
