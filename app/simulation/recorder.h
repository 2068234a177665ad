// Packs frames, and writes them to a journal, on a thread of its own. Knows no Qt, as FrameWorker.
//
// The journal is a .clothtake file that is being written: what it holds survives a crash, and need not stay
// in memory.
#pragma once

#include "simcore/inspect/frame_measure.h"
#include "simcore/recording/take.h"
#include "simcore/recording/take_file.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace clothlab {

// What becomes of frames that were added: one of these.
struct Packed {
    int session = 0; // of begin()
    std::shared_ptr<const FrameGroup> group;
    std::shared_ptr<const Checkpoint> checkpoint;
    std::size_t bytes = 0; // of the exact frames of the group
    std::string problem;   // the journal cannot be written; said once, and then there is none
};

class Recorder {
public:
    // deliver is called on the recorder's thread, after what was added before and before what is added later.
    // Packed frames take no more memory than that, as far as there is a journal.
    Recorder(std::function<void(Packed)> deliver, std::size_t mostBytes);
    ~Recorder(); // packs what was added, and joins
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    // Forgets what was before, and begins a journal; "": none. error: of packed frames, in metres. contents:
    // what was read from a file and is recorded further; goes into the journal, too. May be null.
    void begin(int session, const std::string& journal, double error,
               std::shared_ptr<const TakeFileContents> contents = nullptr);
    void setError(double error); // of frames that are packed from now on
    // The take is there, or has another name, or is hidden.
    void setTake(const TakeInfo& info);
    void add(TakeId take, std::shared_ptr<const Sheet> sheet, int number, FramePointer frame);
    // What the recording says of itself now: all of meta but its error and its scene, which is that of the
    // user and may not have been run yet.
    void setMeta(TakeMeta meta, std::shared_ptr<const Scene> scene);
    // Packs what is there, however little, and then calls `then` on the recorder's thread.
    void flush(std::function<void()> then);

    // Of frames that were added, until the group that has them is taken.
    std::size_t bytesWaiting() const { return m_bytesWaiting; }
    void taken(const Packed& packed) { m_bytesWaiting -= packed.bytes; }
    std::size_t bytesInMemory() const { return m_bytesInMemory; } // of packed ones
    bool hasJournal() const { return m_hasJournal; }
    // The scene of that number, as frames name it. On any thread.
    std::shared_ptr<const Scene> scene(SceneId id) const; // null if there is none
    // The number of a scene that was added, as with a frame or alone; 0 if there is none yet.
    SceneId idOfScene(const Scene& scene) const;

private:
    using Clock = std::chrono::steady_clock;
    struct Journal {
        std::ofstream out;
        std::shared_ptr<const SharedFile> file; // to read what was written
        std::optional<TakeFileWriter> writer;
    };
    struct Progress { // of a take since its last checkpoint
        int frames = 0;
        double milliseconds = 0;
    };

    void post(std::function<void()> job);
    void run();
    static std::shared_ptr<Journal> openJournal(const std::string& path);
    void adopt(const TakeFileContents& contents);
    void write(const Chunk& chunk, Payload* payload = nullptr);
    void loseJournal();
    SceneId idOf(const std::shared_ptr<const Scene>& scene);
    void record(TakeId take, const std::shared_ptr<const Sheet>& sheet, int number, FramePointer frame);
    bool needsCheckpoint(TakeId take, int number, const Frame& frame);
    void packPending();
    void releaseMemory();

    std::function<void(Packed)> m_deliver;
    std::size_t m_mostBytes;
    std::atomic<std::size_t> m_bytesWaiting{0};
    std::atomic<std::size_t> m_bytesInMemory{0};
    std::atomic<bool> m_hasJournal{false};

    mutable std::mutex m_mutex; // guards the next four
    std::deque<std::function<void()>> m_jobs;
    bool m_quit = false;
    SceneMap m_scenes;
    std::map<const Scene*, SceneId> m_sceneIds; // of the same
    std::condition_variable m_wake;

    // The recorder's thread only.
    int m_session = 0;
    std::shared_ptr<Journal> m_journal; // null: none
    double m_error = kDefaultError;
    std::shared_ptr<const Sheet> m_sheet; // of the next two
    std::optional<FramePacker> m_packer;
    std::optional<FrameMeasure> m_measure;
    std::map<TakeId, Progress> m_progress;
    TakeId m_take = 0; // of the pending frames
    int m_first = 0;
    std::vector<FrameToPack> m_pending;
    std::vector<FramePointer> m_pendingFrames; // that these point into
    std::vector<Checkpoint> m_pendingCheckpoints;
    Clock::time_point m_packBy;
    std::deque<std::shared_ptr<Payload>> m_inMemory; // oldest first

    std::thread m_thread; // last: starts when all else is there
};

} // namespace clothlab
