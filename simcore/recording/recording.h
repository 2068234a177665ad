// The takes of a session: which one is open, which of its frames is shown, and which are stale.
#pragma once

#include "simcore/recording/kept_frames.h"

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace clothlab {

// A run is recorded into the open take. What it goes on with is the scene that the user has now:
//
// - A motion edit while an earlier frame is shown makes the frames after it stale: they are not what the run
//   would do now. They stay. The next frame that is recorded follows the last one that is not stale, in a new
//   take that branches off there; the old take keeps all its frames, none of them stale any more.
// - Stale frames become current again by an edit back to a scene from before they became stale, as undo makes
//   it, or to the one that all of them were computed with.
// - A start edit, which is for another sheet, opens a new take; an edit back, the take that was left for it.
// - Edits of the appearance and the camera change nothing.
//
// A take that is not open has no stale frames. A take of which there is only the start is no loss: it goes as
// soon as another start takes its place. To be used by one thread.
class Recording {
public:
    explicit Recording(std::shared_ptr<const Scene> scene);

    // Forgets all takes and begins the first.
    void reset(std::shared_ptr<const Scene> scene);
    // Opens a new take from the start of the scene as it is now.
    void restart();

    enum class Effect { None, Staleness, OtherTake };
    // The scene after an edit, undo or redo.
    Effect setScene(std::shared_ptr<const Scene> scene);
    const std::shared_ptr<const Scene>& scene() const { return m_scene; }

    // --- of the open take
    const TakePointer& take() const { return m_open; }
    int frameCount() const { return m_open->frameCount(); }
    int lastFrame() const { return m_open->lastFrame(); }
    const RecordedFrame& frame(int index) const { return std::as_const(*m_open).frame(index); }
    int shownFrame() const { return m_shown; }
    void show(int frame) { m_shown = frame; } // one that is there
    int firstStaleFrame() const;              // frameCount() if none is
    bool isStale(int frame) const { return frame >= m_firstStale; }
    int endOfRun() const { return firstStaleFrame() - 1; } // the frame that the run goes on from
    // With which the run went on from the shown frame or, if that is where it would go on, will.
    const Scene& shownScene() const;
    // Records the frame after endOfRun(). Returns whether that began a take.
    bool append(FramePointer frame);

    // --- exact frames in memory
    // One that was computed again.
    void keep(const TakePointer& take, int frame, FramePointer exact);
    void trim(std::size_t mostBytes) { m_kept.trim(mostBytes); }
    std::size_t bytesKept() const { return m_kept.bytes(); }

    // --- all takes, in the order they began
    const std::vector<TakePointer>& takes() const { return m_takes; }
    TakePointer findTake(TakeId id) const;    // of the list; null if there is none
    TakePointer findAnyTake(TakeId id) const; // also one that was removed and may come back
    // Of those that are there, the one it branched off, or the one that one branched off …; null if none is.
    TakePointer listedParent(const Take& take) const;
    bool isListed(const Take& take) const;
    // Takes it out of the list, unless it is open. Its frames stay for branches of it.
    bool remove(const TakePointer& take);
    void insert(const TakePointer& take); // one that was removed

    // What is open, and how. Going back to it changes no frame.
    struct StaleEdit {
        std::shared_ptr<const Scene> before;
        int firstStale; // that undoing the edit brings back
    };
    struct View {
        TakePointer take;
        std::shared_ptr<const Scene> scene;
        int frame = 0;
        int firstStale = std::numeric_limits<int>::max();
        std::vector<StaleEdit> staleEdits; // since a frame was last recorded
    };
    View view() const;
    // Of a take that is opened: at the frame that is shown now or its last, with the scene of its last frame,
    // but the appearance and the camera of now.
    View viewOf(const TakePointer& take) const;
    void setView(View view); // the take is in the list after that

    // Puts takes, as a file has them, in the place of all, and opens one of them at its last frame.
    void load(std::vector<TakePointer> takes, const TakePointer& open);

private:
    bool isEmpty(const Take& take) const; // nothing but a start
    void open(const TakePointer& take, int frame);
    TakePointer beginTake();
    void list(const TakePointer& take);
    Effect changeStart();
    Effect changeMotion(std::shared_ptr<const Scene> before);
    bool areComputedAs(const Scene& scene, int first) const; // all frames from there on
    std::string freeName() const;

    static constexpr int kNone = std::numeric_limits<int>::max();

    std::vector<TakePointer> m_takes;
    std::map<TakeId, std::weak_ptr<Take>> m_all;
    TakeId m_lastId = 0;
    KeptFrames m_kept;
    std::shared_ptr<const Scene> m_scene;
    TakePointer m_open;
    int m_shown = 0;
    int m_firstStale = kNone;
    std::vector<StaleEdit> m_staleEdits;
    struct Left {
        TakePointer take;
        int frame;
    };
    std::vector<Left> m_left; // by start edits
};

} // namespace clothlab
