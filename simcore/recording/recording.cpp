#include "simcore/recording/recording.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace clothlab {

std::size_t bytesOf(const Frame& frame) {
    return sizeof(Frame) + 6 * sizeof(double) * frame.state.size();
}

void Recording::restart(FramePointer start) {
    m_frames.clear();
    m_bytes = 0;
    append(std::move(start));
}

void Recording::append(FramePointer frame) {
    m_bytes += bytesOf(*frame);
    m_frames.push_back(std::move(frame));
}

void Recording::truncate(int frameCount) {
    assert(frameCount >= 1);
    while (this->frameCount() > frameCount) {
        m_bytes -= bytesOf(*m_frames.back());
        m_frames.pop_back();
    }
}

bool Recording::full() const {
    return !m_frames.empty() && m_bytes + bytesOf(*m_frames.back()) > m_budget;
}

} // namespace clothlab
