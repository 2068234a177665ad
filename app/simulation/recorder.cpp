#include "app/simulation/recorder.h"

#include <utility>

namespace clothlab {
namespace {

// To have the state of a frame again, so much is computed at most, and kFramesPerCheckpoint.
constexpr double kMillisecondsPerCheckpoint = 500;

// What a crash loses at most, and the time to write it.
constexpr std::chrono::milliseconds kPackWithin{400};

} // namespace

Recorder::Recorder(std::function<void(Packed)> deliver, std::size_t mostBytes)
    : m_deliver(std::move(deliver)), m_mostBytes(mostBytes), m_thread([this] { run(); }) {}

Recorder::~Recorder() {
    {
        const std::scoped_lock lock(m_mutex);
        m_quit = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

// --- on the caller's thread

void Recorder::post(std::function<void()> job) {
    {
        const std::scoped_lock lock(m_mutex);
        m_jobs.push_back(std::move(job));
    }
    m_wake.notify_one();
}

// Here and now, so that whoever removes the file later removes it for good. Null if it cannot be written.
std::shared_ptr<Recorder::Journal> Recorder::openJournal(const std::string& path) {
    if (path.empty())
        return nullptr;
    auto journal = std::make_shared<Journal>();
    journal->out.open(path, std::ios::binary | std::ios::trunc);
    journal->file = SharedFile::open(path).file;
    if (!journal->out || !journal->file)
        return nullptr;
    journal->writer.emplace(journal->out);
    return journal;
}

void Recorder::begin(int session, const std::string& journal, double error,
                     std::shared_ptr<const TakeFileContents> contents) {
    post([this, session, journal, opened = openJournal(journal), error, contents = std::move(contents)] {
        packPending();
        m_session = session;
        {
            const std::scoped_lock lock(m_mutex);
            m_scenes.clear();
            m_sceneIds.clear();
        }
        m_progress.clear();
        m_inMemory.clear();
        m_bytesInMemory = 0;
        m_sheet = nullptr;
        m_error = error;
        m_journal = opened;
        m_hasJournal = m_journal != nullptr;
        if (!journal.empty() && !m_journal)
            loseJournal();
        if (contents)
            adopt(*contents);
    });
}

void Recorder::setError(double error) {
    post([this, error] {
        packPending();
        m_error = error;
        m_sheet = nullptr; // another packer for the next frame
    });
}

void Recorder::setTake(const TakeInfo& info) {
    post([this, info] { write(takeChunk(info)); });
}

void Recorder::add(TakeId take, std::shared_ptr<const Sheet> sheet, int number, FramePointer frame) {
    m_bytesWaiting += bytesOf(*frame);
    post([this, take, sheet = std::move(sheet), number, frame = std::move(frame)]() mutable {
        record(take, sheet, number, std::move(frame));
    });
}

void Recorder::setMeta(TakeMeta meta, std::shared_ptr<const Scene> scene) {
    post([this, meta = std::move(meta), scene = std::move(scene)]() mutable {
        meta.error = m_error;
        meta.scene = idOf(scene);
        write(metaChunk(meta));
    });
}

void Recorder::flush(std::function<void()> then) {
    post([this, then = std::move(then)] {
        packPending();
        then();
    });
}

std::shared_ptr<const Scene> Recorder::scene(SceneId id) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_scenes.find(id);
    return found == m_scenes.end() ? nullptr : found->second;
}

SceneId Recorder::idOfScene(const Scene& scene) const {
    const std::scoped_lock lock(m_mutex);
    const auto found = m_sceneIds.find(&scene);
    return found == m_sceneIds.end() ? 0 : found->second;
}

// --- on the recorder's thread

void Recorder::run() {
    while (true) {
        std::function<void()> job;
        {
            std::unique_lock lock(m_mutex);
            const auto ready = [this] { return m_quit || !m_jobs.empty(); };
            if (m_pending.empty())
                m_wake.wait(lock, ready);
            else
                m_wake.wait_until(lock, m_packBy, ready);
            if (m_quit && m_jobs.empty())
                break;
            if (!m_jobs.empty()) {
                job = std::move(m_jobs.front());
                m_jobs.pop_front();
            }
        }
        if (job)
            job();
        if (!m_pending.empty() && Clock::now() >= m_packBy)
            packPending();
    }
    packPending();
}

// Into the journal, if there is one; then the payload need not stay in memory.
void Recorder::write(const Chunk& chunk, Payload* payload) {
    if (!m_journal)
        return;
    const std::uint64_t at = m_journal->writer->add(chunk);
    m_journal->out.flush();
    if (!m_journal->out)
        loseJournal();
    else if (payload)
        payload->placeInFile(m_journal->file, at + payloadOffset(chunk));
}

void Recorder::loseJournal() {
    m_journal = nullptr;
    m_hasJournal = false;
    Packed lost;
    lost.session = m_session;
    lost.problem =
        "The recording cannot be written to disk: it stays in memory, and a crash would lose it. Make "
        "room on the disk, then begin a new one";
    m_deliver(std::move(lost));
}

void Recorder::adopt(const TakeFileContents& contents) {
    {
        const std::scoped_lock lock(m_mutex);
        m_scenes = contents.scenes;
        for (const auto& [id, scene] : m_scenes)
            m_sceneIds[scene.get()] = id;
    }
    for (const auto& [id, scene] : contents.scenes)
        write(sceneChunk(id, *scene));
    for (const RecordedTake& take : contents.takes) {
        write(takeChunk(take.info));
        for (const FrameGroup& group : take.groups)
            if (const auto chunk = m_journal ? chunkOf(group) : std::nullopt)
                write(*chunk);
        for (const Checkpoint& checkpoint : take.checkpoints)
            if (const auto chunk = m_journal ? chunkOf(checkpoint) : std::nullopt)
                write(*chunk);
    }
    write(metaChunk(contents.meta));
}

// The first time it goes into the journal.
SceneId Recorder::idOf(const std::shared_ptr<const Scene>& scene) {
    SceneId id = 0;
    {
        const std::scoped_lock lock(m_mutex);
        SceneId& known = m_sceneIds[scene.get()];
        if (known != 0)
            return known;
        known = id = m_scenes.empty() ? 1 : m_scenes.rbegin()->first + 1;
        m_scenes[id] = scene;
    }
    write(sceneChunk(id, *scene));
    return id;
}

void Recorder::record(TakeId take, const std::shared_ptr<const Sheet>& sheet, int number,
                      FramePointer frame) {
    const bool follows = take == m_take && number == m_first + int(m_pending.size()) && sheet == m_sheet;
    if (!follows || int(m_pending.size()) == kFramesPerGroup)
        packPending();
    if (sheet != m_sheet) {
        m_sheet = sheet;
        m_packer.emplace(sheet->grid, m_error);
        m_measure.emplace(*sheet);
    }
    if (m_pending.empty()) {
        m_take = take;
        m_first = number;
        m_packBy = Clock::now() + kPackWithin;
    }
    m_pending.push_back({&frame->state.position, m_measure->factsOf(*frame), idOf(frame->scene)});
    if (needsCheckpoint(take, number, *frame))
        m_pendingCheckpoints.push_back(packCheckpoint(take, number, sheet->grid, frame->state));
    m_pendingFrames.push_back(std::move(frame));
    if (int(m_pending.size()) == kFramesPerGroup)
        packPending();
}

bool Recorder::needsCheckpoint(TakeId take, int number, const Frame& frame) {
    Progress& progress = m_progress[take];
    ++progress.frames;
    progress.milliseconds += frame.milliseconds;
    if (number != 0 && progress.frames < kFramesPerCheckpoint &&
        progress.milliseconds < kMillisecondsPerCheckpoint)
        return false;
    progress = {};
    return true;
}

void Recorder::packPending() {
    if (m_pending.empty())
        return;
    auto group = std::make_shared<const FrameGroup>(packGroup(*m_packer, m_take, m_first, m_pending));
    std::size_t bytes = 0;
    for (const FramePointer& frame : m_pendingFrames)
        bytes += bytesOf(*frame);
    if (m_journal)
        if (const auto chunk = chunkOf(*group))
            write(*chunk, group->payload.get());
    m_inMemory.push_back(group->payload);
    m_bytesInMemory += group->payload->bytesInMemory();
    Packed packed;
    packed.session = m_session;
    packed.group = std::move(group);
    packed.bytes = bytes;
    m_deliver(std::move(packed));
    for (Checkpoint& pending : m_pendingCheckpoints) {
        auto checkpoint = std::make_shared<const Checkpoint>(std::move(pending));
        if (m_journal)
            if (const auto chunk = chunkOf(*checkpoint))
                write(*chunk, checkpoint->payload.get());
        m_inMemory.push_back(checkpoint->payload);
        m_bytesInMemory += checkpoint->payload->bytesInMemory();
        Packed packedState;
        packedState.session = m_session;
        packedState.checkpoint = std::move(checkpoint);
        m_deliver(std::move(packedState));
    }
    m_pending.clear();
    m_pendingFrames.clear();
    m_pendingCheckpoints.clear();
    releaseMemory();
}

void Recorder::releaseMemory() {
    while (m_bytesInMemory > m_mostBytes && !m_inMemory.empty() && m_inMemory.front()->inFile()) {
        m_bytesInMemory -= m_inMemory.front()->release();
        m_inMemory.pop_front();
    }
}

} // namespace clothlab
