#include "simcore/recording/group_order.h"

#include "simcore/recording/frame_codec.h"

#include <bit>

namespace clothlab {

static_assert(std::has_single_bit(unsigned(kFramesPerGroup)) && kFramesPerGroup < kNoFrame);

int groupLevel(int index) {
    return index == 0 ? std::countr_zero(unsigned(kFramesPerGroup)) : std::countr_zero(unsigned(index));
}

std::vector<GroupPlace> groupOrder(int frames) {
    std::vector<GroupPlace> order{{0, kNoFrame, kNoFrame}};
    for (int distance = kFramesPerGroup / 2; distance > 0; distance /= 2)
        for (int index = distance; index < frames; index += 2 * distance)
            order.push_back(
                {index, index - distance, index + distance < frames ? index + distance : kNoFrame});
    return order;
}

} // namespace clothlab
