#pragma once

#include "simcore/recording/take.h"

#include <deque>

namespace clothlab {

// Which exact frames takes keep in memory, and how many bytes they are. To be used by one thread.
class KeptFrames {
public:
    void clear();
    // Keeps it as the frame of the take that owns it.
    void keep(const TakePointer& owner, int frame, FramePointer exact);
    std::size_t bytes() const { return m_bytes; }
    // Lets go of those kept longest that are packed, until the rest takes no more bytes than that.
    void trim(std::size_t mostBytes);

private:
    struct Place {
        std::weak_ptr<Take> take;
        int frame;
        std::size_t bytes;
    };
    bool letGo(const Place& place);

    std::deque<Place> m_places; // those kept longest first
    std::size_t m_bytes = 0;
};

} // namespace clothlab
