#include "app/simulation/simulation.h"

#include "app/simulation/take_replay.h"
#include "simcore/inspect/blow_up_text.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace clothlab {
namespace {

// Calls it on the thread of the object, later.
template <typename Call>
void later(QObject* object, Call call) {
    QMetaObject::invokeMethod(object, std::move(call), Qt::QueuedConnection);
}

} // namespace

Simulation::Simulation(Document& document, QObject* parent, std::size_t memoryBudget)
    : QObject(parent), m_document(document), m_recording(document.snapshot()), m_budget(memoryBudget),
      m_recorder(
          [this](Packed packed) { later(this, [this, packed = std::move(packed)] { receive(packed); }); },
          memoryBudget / 4),
      m_worker([this](FrameOutcome outcome) {
          later(this, [this, outcome = std::move(outcome)]() mutable { receive(std::move(outcome)); });
      }) {
    m_sinceBegin.start();
    m_clock.setSingleShot(true);
    m_clock.setTimerType(Qt::PreciseTimer);
    connect(&m_clock, &QTimer::timeout, this, &Simulation::advance);
    connect(&document, &Document::sceneChanged, this, &Simulation::onSceneChanged);
    connect(&document, &Document::sceneReplaced, this, &Simulation::onSceneReplaced);
    beginSession();
    announceTake();
    m_shown = look(0);
}

// --- the recorder

void Simulation::setJournals(std::function<QString()> newPath) {
    m_newJournal = std::move(newPath);
    beginSession();
    announceTake();
}

void Simulation::setRecordingError(double error) {
    m_error = error;
    m_recorder.setError(error);
}

bool Simulation::isWorthSaving() const {
    return m_hasUnsavedNames || m_unsavedSeconds >= m_secondsWorthSaving;
}

void Simulation::setSaved() {
    m_hasUnsavedNames = false;
    m_unsavedSeconds = 0;
}

void Simulation::beginSession(std::shared_ptr<const TakeFileContents> contents) {
    setSaved();
    m_recorder.begin(++m_session, m_newJournal ? m_newJournal().toStdString() : std::string(), m_error,
                     std::move(contents));
}

void Simulation::announceTake() {
    const Take& take = *m_recording.take();
    tellTake(take);
    if (!take.parent())
        m_recorder.add(take.id(), take.sharedSheet(), 0, take.frame(0).exact);
}

void Simulation::tellTake(const Take& take) {
    m_recorder.setTake(infoOf(m_recording, take));
}

// The scene of the user, and marks.
void Simulation::tellMeta() {
    m_recorder.setMeta(marksOf(m_recording), m_document.snapshot());
}

void Simulation::load(const LoadedTakes& loaded, TakeFileContents contents) {
    m_recording.load(loaded.takes, loaded.open);
    m_recording.show(loaded.shownFrame);
    m_recording.setScene(m_document.snapshot());
    beginSession(std::make_shared<const TakeFileContents>(std::move(contents)));
    showOtherTake();
}

void Simulation::whenPacked(std::function<void()> then) {
    m_recorder.flush([this, then = std::move(then)] { later(this, then); });
}

void Simulation::gatherContents(std::function<void(TakeFileContents)> use) {
    tellMeta();
    whenPacked([this, use = std::move(use), scene = m_document.snapshot()] {
        TakeFileContents contents = contentsOf(m_recording);
        contents.meta.version = CLOTHLAB_VERSION;
        contents.meta.error = m_error;
        contents.meta.scene = m_recorder.idOfScene(*scene);
        for (const SceneId id : scenesNamed(contents))
            contents.scenes[id] = m_recorder.scene(id);
        use(std::move(contents));
    });
}

// --- the scene

void Simulation::onSceneReplaced() {
    m_recording.reset(m_document.snapshot());
    beginSession();
    announceTake();
    showOtherTake();
}

void Simulation::onSceneChanged(SceneChange change) {
    if (m_opening) {
        m_recording.setView(*m_opening);
        tellTake(*m_recording.take()); // it may have gone before
        tellMeta();
        showOtherTake();
        return;
    }
    const TakePointer before = m_recording.take();
    const Recording::Effect effect = m_recording.setScene(m_document.snapshot());
    tellMeta();
    if (change == SceneChange::Motion)
        setBlowUp({});
    if (effect == Recording::Effect::OtherTake) {
        const TakePointer take = m_recording.take();
        tellTake(*before); // it goes if nothing was recorded
        if (take->frameCount() == 1)
            announceTake();
        if (before->frameCount() > 1)
            emit notice(
                take->frameCount() == 1
                    ? tr("The sheet has changed: %1 begins. %2 keeps its frames.")
                          .arg(QString::fromStdString(take->name()), QString::fromStdString(before->name()))
                    : tr("Back to %1.").arg(QString::fromStdString(take->name())));
        showOtherTake();
    } else if (effect == Recording::Effect::Staleness) {
        if ((isSimulating() || m_ready) && m_follows != m_recording.endOfRun()) {
            dropPending(); // it would follow another frame than the run goes on from now
            if (m_playing)
                m_clock.start(0);
        }
        emit recordingChanged();
    }
}

void Simulation::showOtherTake() {
    dropPending();
    m_shown = look(currentFrame()); // before anyone is told: there must be a frame to show
    setPlaying(false);
    setBlowUp({});
    emit takesChanged();
    emit recordingChanged();
    show(currentFrame());
}

void Simulation::restart() {
    const TakePointer before = m_recording.take();
    m_recording.restart();
    tellTake(*before); // it goes if nothing was recorded
    announceTake();
    if (before->frameCount() > 1)
        emit notice(tr("%1 begins. %2 keeps its frames.")
                        .arg(QString::fromStdString(m_recording.take()->name()),
                             QString::fromStdString(before->name())));
    showOtherTake();
}

// --- frame by frame; what plays is in simulation_playing.cpp

void Simulation::pause() {
    dropPending();
    setPlaying(false);
    refine();
}

void Simulation::showFrame(int frame) {
    dropPending();
    setPlaying(false);
    show(std::clamp(frame, 0, m_recording.lastFrame()));
}

void Simulation::simulateFrame() {
    if (m_playing)
        pause();
    if (!isSimulating())
        requestFrame();
}

// --- what the worker does

std::size_t Simulation::bytesInMemory() const {
    return m_recording.bytesKept() + m_recorder.bytesInMemory();
}

// Frames that wait to be packed are there for a moment only.
bool Simulation::isFull() {
    m_recording.trim(m_budget / 2);
    return bytesInMemory() > m_budget + m_recorder.bytesWaiting();
}

void Simulation::requestFrame() {
    if (isFull()) {
        pause();
        emit notice(
            tr("The recording is full: its %1 of memory are used, and it cannot be written to disk. Save "
               "it, then open or begin another scene.")
                .arg(QLocale::c().formattedDataSize(qint64(m_budget))));
        return;
    }
    constexpr int patience = 20; // ms
    if (m_recorder.bytesWaiting() > m_budget / 8 && m_playing) {
        m_recorder.flush([] {}); // it may wait for more frames
        m_clock.start(patience);
        return;
    }
    request(m_recording.endOfRun(), true);
}

void Simulation::refine() {
    if (!m_playing && !m_pending && !m_shown->exact)
        request(currentFrame(), false);
}

// Computes frames of the open take again, up to that one, and then one more.
void Simulation::request(int regained, bool newFrame) {
    const Take& take = std::as_const(*m_recording.take());
    int base = regained;
    while (!take.frame(base).exact && !take.frame(base).checkpoint)
        --base; // the start is always there
    FrameRequest request;
    request.before = [from = take.frame(base)] { return clothlab::exactFrame(from); };
    request.number = base + 1;
    for (int i = base + 1; i <= regained; ++i) {
        const FrameFacts* facts = factsOf(take, i);
        request.frames.push_back({take.frame(i).scene,
                                  facts ? std::optional(facts->milliseconds) : std::nullopt,
                                  facts && i == regained ? std::optional(facts->stateHash) : std::nullopt});
    }
    if (newFrame)
        request.frames.push_back({m_document.snapshot(), {}, {}});
    if (m_pending)
        m_worker.cancel();
    request.ticket = ++m_lastTicket;
    if (newFrame)
        m_follows = regained;
    m_pending = {request.ticket, m_recording.take(), regained, newFrame};
    m_worker.request(std::move(request));
}

void Simulation::dropPending() {
    m_clock.stop();
    m_ready = nullptr;
    if (m_pending)
        m_worker.cancel();
    m_pending.reset();
}

void Simulation::receive(FrameOutcome outcome) {
    if (!m_pending || outcome.ticket != m_pending->ticket)
        return;
    const Pending done = *std::exchange(m_pending, std::nullopt);
    m_lastComputedOn = outcome.computedOn;
    FramePointer next;
    for (int number = outcome.number; FramePointer & frame : outcome.frames) {
        if (number <= done.regained)
            m_recording.keep(done.take, number, std::move(frame));
        else
            next = std::move(frame);
        ++number;
    }
    if (outcome.differs)
        emit notice(
            tr("Frame %1 cannot be repeated exactly: another program or another machine may have made it.")
                .arg(done.regained));
    if (outcome.blowUp)
        stopForBlowUp(outcome);
    else if (outcome.frames.empty())
        repairWay(done);
    else if (!done.newFrame)
        show(currentFrame());
    else if (m_playing) {
        m_ready = std::move(next);
        if (!m_clock.isActive()) // it is overdue
            advance();
    } else {
        record(std::move(next));
        show(m_recording.lastFrame());
    }
}

// A checkpoint could not be read: once more from the one before.
void Simulation::repairWay(const Pending& done) {
    for (int frame = done.regained; frame > 0; --frame)
        if (RecordedFrame& recorded = done.take->frame(frame); recorded.checkpoint) {
            recorded.checkpoint = nullptr;
            break;
        }
    request(done.regained, done.newFrame);
}

void Simulation::receive(const Packed& packed) {
    m_recorder.taken(packed);
    if (packed.session != m_session)
        return;
    if (!packed.problem.empty())
        emit notice(QString::fromStdString(packed.problem) + '.');
    if (packed.group)
        if (const TakePointer take = m_recording.findAnyTake(packed.group->take))
            for (int frame = packed.group->first; frame < packed.group->end(); ++frame)
                take->frame(frame).group = packed.group;
    if (packed.checkpoint)
        if (const TakePointer take = m_recording.findAnyTake(packed.checkpoint->take))
            take->frame(packed.checkpoint->frame).checkpoint = packed.checkpoint;
    m_recording.trim(m_budget / 2);
    emit recordingChanged();
}

void Simulation::record(FramePointer frame) {
    const TakePointer before = m_recording.take();
    const int stale = m_recording.frameCount() - m_recording.firstStaleFrame();
    const bool begins = m_recording.append(frame);
    const TakePointer& take = m_recording.take();
    if (begins) {
        announceTake();
        const QString frames =
            stale == 1 ? tr("the frame that follows") : tr("the %1 frames that follow").arg(stale);
        emit notice(tr("%1 begins at frame %2; %3 keeps %4 it there.")
                        .arg(QString::fromStdString(take->name()))
                        .arg(take->branchFrame())
                        .arg(QString::fromStdString(before->name()), frames));
        emit takesChanged();
    }
    m_unsavedSeconds += frame->milliseconds / 1000;
    m_recorder.add(take->id(), take->sharedSheet(), take->lastFrame(), std::move(frame));
    m_document.setRecordingModified();
    emit recordingChanged();
}

void Simulation::stopForBlowUp(const FrameOutcome& outcome) {
    pause();
    setBlowUp(QString::fromStdString(
        describeBlowUp(*outcome.blowUp, outcome.blowUpStep, outcome.blowUpFrame, *outcome.blowUpScene)));
}

// --- what is shown

FramePointer Simulation::look(int number) {
    const Take& take = *m_recording.take();
    const RecordedFrame& recorded = take.frame(number);
    return recorded.exact
               ? recorded.exact
               : roughFrameOf(recorded, number, take.sheet(), m_reader.positionsOf(*recorded.group, number));
}

void Simulation::show(int frame) {
    m_recording.show(frame);
    m_shown = look(frame);
    emit frameShown();
    refine();
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
