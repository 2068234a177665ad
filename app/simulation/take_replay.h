// The frames of a take, as they are now, for another thread.
#pragma once

#include "simcore/recording/take.h"
#include "simcore/solver/verlet_solver.h"

#include <optional>
#include <string>
#include <vector>

namespace clothlab {

// To be made by the thread that owns the take, then used by one thread at a time. Frames that are not in
// memory any more are computed again: one after another at the cost of one each.
class TakeReplay {
public:
    explicit TakeReplay(const Take& take);

    int frameCount() const { return int(m_frames.size()); }
    const Sheet& sheet() const { return *m_sheet; }
    // With whole state. Null, and the reason in words, if it cannot be had.
    FramePointer exactFrame(int number, std::string& reason);
    // As it is kept; the positions are what counts.
    FramePointer roughFrame(int number, std::string& reason);

private:
    FramePointer baseFor(int number, int& base);

    std::shared_ptr<const Sheet> m_sheet;
    std::vector<RecordedFrame> m_frames;
    GroupReader m_reader;
    std::optional<VerletSolver> m_solver;
    FramePointer m_last; // computed last
    int m_lastNumber = -1;
};

// Of a frame whose state is packed. Positions: of the start, if there are none.
FramePointer roughFrameOf(const RecordedFrame& recorded, int number, const Sheet& sheet,
                          std::optional<PointArray> positions);

} // namespace clothlab
