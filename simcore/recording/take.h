// A take: a start, the scene as it was, and every frame with the scene it was computed with, so that it says
// what was changed while it ran, and when.
#pragma once

#include "simcore/recording/frame.h"
#include "simcore/recording/frame_group.h"
#include "simcore/recording/take_marks.h"

#include <memory>
#include <string>
#include <vector>

namespace clothlab {

// A frame and all that is kept of it. At least one of exact and group is there.
struct RecordedFrame {
    std::shared_ptr<const Scene> scene;      // with which it was computed; of frame 0, that of the start
    double time = 0;                         // simulated seconds since the start
    FramePointer exact;                      // while it is kept in memory
    std::shared_ptr<const FrameGroup> group; // that holds it, once it is packed
    std::shared_ptr<const Checkpoint> checkpoint;
};

// Frames are only added; a take that goes on otherwise from a frame is a branch, which shares the frames up
// to there and keeps the takes it came from alive. Not safe to share between threads.
class Take {
public:
    Take(TakeId id, std::string name, FramePointer start);
    // Of frame branchFrame of the parent, which is the one that owns it.
    Take(TakeId id, std::string name, std::shared_ptr<Take> parent, int branchFrame);

    TakeId id() const { return m_id; } // no other of the recording has the same
    const std::string& name() const { return m_name; }
    void setName(std::string name) { m_name = std::move(name); }
    const TakeMarks& marks() const { return m_marks; } // a branch begins with none
    void setMarks(TakeMarks marks) { m_marks = std::move(marks); }
    const std::shared_ptr<Take>& parent() const { return m_parent; } // null of one with a start of its own
    int branchFrame() const { return m_firstOwn - 1; }               // the last that is the parent's; else -1
    const Sheet& sheet() const { return *m_sheet; }
    const std::shared_ptr<const Sheet>& sharedSheet() const { return m_sheet; }

    int frameCount() const { return m_firstOwn + int(m_own.size()); } // 1 or more; frame 0 is the start
    int lastFrame() const { return frameCount() - 1; }
    const RecordedFrame& frame(int index) const;
    RecordedFrame& frame(int index);
    void append(RecordedFrame frame) { m_own.push_back(std::move(frame)); }

private:
    TakeId m_id;
    std::string m_name;
    TakeMarks m_marks;
    std::shared_ptr<Take> m_parent;
    std::shared_ptr<const Sheet> m_sheet; // that of the take with the start
    int m_firstOwn = 0;
    std::vector<RecordedFrame> m_own;
};

using TakePointer = std::shared_ptr<Take>;

// Of the take and those it came from, the one whose own frame that is.
TakePointer ownerOf(TakePointer take, int frame);

// With its state, of memory or of its checkpoint. Null if it has neither, or the checkpoint cannot be read.
FramePointer exactFrame(const RecordedFrame& recorded);

// What is known of a frame without its state; null until it is packed.
const FrameFacts* factsOf(const Take& take, int frame);

// The scene with which a run would go on as it did: that of the last frame.
const std::shared_ptr<const Scene>& lastScene(const Take& take);

} // namespace clothlab
