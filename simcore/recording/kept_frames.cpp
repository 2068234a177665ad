#include "simcore/recording/kept_frames.h"

#include <utility>

namespace clothlab {

void KeptFrames::clear() {
    m_places.clear();
    m_bytes = 0;
}

void KeptFrames::keep(const TakePointer& owner, int frame, FramePointer exact) {
    RecordedFrame& recorded = owner->frame(frame);
    if (recorded.exact)
        return;
    m_places.push_back({owner, frame, bytesOf(*exact)});
    m_bytes += m_places.back().bytes;
    recorded.exact = std::move(exact);
}

// False if it is not packed yet.
bool KeptFrames::letGo(const Place& place) {
    if (const TakePointer take = place.take.lock()) {
        RecordedFrame& recorded = take->frame(place.frame);
        if (!recorded.group)
            return false;
        recorded.exact = nullptr;
    }
    m_bytes -= place.bytes;
    return true;
}

void KeptFrames::trim(std::size_t mostBytes) {
    // Those that are not packed wait for another time.
    for (std::size_t i = m_places.size(); i > 0 && m_bytes > mostBytes; --i) {
        const Place place = std::move(m_places.front());
        m_places.pop_front();
        if (!letGo(place))
            m_places.push_back(place);
    }
}

} // namespace clothlab
