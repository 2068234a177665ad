#include "app/simulation/take_replay.h"

#include "simcore/solver/frame_runner.h"

#include <utility>

namespace clothlab {

TakeReplay::TakeReplay(const Take& take) : m_sheet(take.sharedSheet()) {
    m_frames.reserve(std::size_t(take.frameCount()));
    for (int i = 0; i < take.frameCount(); ++i)
        m_frames.push_back(take.frame(i));
}

// The nearest exact frame before that one, or itself. The start is always there.
FramePointer TakeReplay::baseFor(int number, int& base) {
    for (base = number;; --base) {
        if (base == m_lastNumber)
            return m_last;
        if (FramePointer frame = clothlab::exactFrame(m_frames[std::size_t(base)]))
            return frame;
    }
}

FramePointer TakeReplay::exactFrame(int number, std::string& reason) {
    int base = 0;
    FramePointer frame = baseFor(number, base);
    const std::atomic<bool> never{false};
    while (base < number) {
        const RecordedFrame& recorded = m_frames[std::size_t(++base)];
        if (!m_solver)
            m_solver.emplace(*recorded.scene);
        else
            m_solver->setScene(*recorded.scene);
        Frame next = *frame;
        const FrameResult result = runFrame(*m_solver, next.state, never);
        if (!result.finished) {
            reason = "frame " + std::to_string(base) + " cannot be computed again";
            return nullptr;
        }
        next.scene = recorded.scene;
        next.time = recorded.time;
        next.strainLimitCorrections = result.strainLimitCorrections;
        frame = std::make_shared<const Frame>(std::move(next));
    }
    m_last = frame;
    m_lastNumber = number;
    return frame;
}

FramePointer TakeReplay::roughFrame(int number, std::string& reason) {
    const RecordedFrame& recorded = m_frames[std::size_t(number)];
    if (recorded.exact)
        return recorded.exact;
    std::optional<PointArray> positions = m_reader.positionsOf(*recorded.group, number);
    if (!positions)
        return exactFrame(number, reason);
    return roughFrameOf(recorded, number, *m_sheet, std::move(positions));
}

FramePointer roughFrameOf(const RecordedFrame& recorded, int number, const Sheet& sheet,
                          std::optional<PointArray> positions) {
    Frame frame;
    if (positions)
        frame.state.position = std::move(*positions);
    else
        frame.state.position = sheet.start;
    frame.state.lastPosition = frame.state.position;
    frame.scene = recorded.scene;
    frame.time = recorded.time;
    if (recorded.group) {
        const FrameFacts& facts = recorded.group->frames[std::size_t(number - recorded.group->first)].facts;
        frame.strainLimitCorrections = facts.strainLimitCorrections;
        frame.milliseconds = facts.milliseconds;
    }
    frame.exact = false;
    return std::make_shared<const Frame>(std::move(frame));
}

} // namespace clothlab
