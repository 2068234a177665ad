// The frames of a run, in memory, within a budget.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace clothlab {

// One recorded frame. The full state is kept, so a run can go on from any frame with the same bits.
struct Frame {
    ClothState state;
    std::shared_ptr<const Scene> scene;      // as it was when the frame was computed
    double time = 0;                         // simulated seconds since the start
    std::int64_t strainLimitCorrections = 0; // in this frame
    double milliseconds = 0;                 // it took to compute
};

using FramePointer = std::shared_ptr<const Frame>;

inline constexpr std::size_t kRecordingBudget = std::size_t(1) << 30U; // bytes

// Frame 0 is the start. Not safe to share between threads; frames are, as they never change.
class Recording {
public:
    explicit Recording(std::size_t budgetBytes = kRecordingBudget) : m_budget(budgetBytes) {}

    void restart(FramePointer start);
    void append(FramePointer frame);
    void truncate(int frameCount); // keeps the first frameCount frames; at least one

    int frameCount() const { return static_cast<int>(m_frames.size()); }
    int lastFrame() const { return frameCount() - 1; }
    const FramePointer& frame(int index) const { return m_frames[std::size_t(index)]; }
    std::size_t bytes() const { return m_bytes; }
    std::size_t budget() const { return m_budget; }
    bool full() const; // one more frame would exceed the budget

private:
    std::vector<FramePointer> m_frames;
    std::size_t m_bytes = 0;
    std::size_t m_budget;
};

std::size_t bytesOf(const Frame& frame);

} // namespace clothlab
