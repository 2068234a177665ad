// The order in which the frames of a group are packed: the first, the one in the middle, those in the middle
// of what is left, …, so that most lie between two that are known, and few have to be known for any.
#pragma once

#include <cstdint>
#include <vector>

namespace clothlab {

inline constexpr int kNoFrame = 255;

struct GroupPlace {
    int index = 0;         // of the frame in the group
    int past = kNoFrame;   // the nearest before it that is packed earlier
    int future = kNoFrame; // the nearest after it
};

std::vector<GroupPlace> groupOrder(int frames); // 1 … kFramesPerGroup

// How often 2 divides an index: what a frame is predicted from has more of it, or is the first.
int groupLevel(int index);

} // namespace clothlab
