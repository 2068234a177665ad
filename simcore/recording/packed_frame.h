// The bytes of a packed frame, as packer and unpacker share them.
#pragma once

#include "simcore/base/little_endian.h"
#include "simcore/recording/group_order.h"
#include "simcore/recording/packed_values.h"
#include "simcore/recording/spatial_prediction.h"

namespace clothlab {

enum class FrameKind : std::uint8_t { Steps = 0, Bits = 1 };

// In front of a packed frame. It is predicted from one frame or from the mean of two, or not at all.
struct FrameHead {
    FrameKind kind = FrameKind::Steps;
    int past = kNoFrame;                  // index in the group
    int future = kNoFrame;                // index in the group
    std::array<std::int64_t, 3> origin{}; // of Steps; in the file only if it is predicted from none
    std::array<PointWeights, 3> weights;  // of Steps

    bool predicted() const { return past != kNoFrame || future != kNoFrame; }
    void append(std::string& out) const;
    // Nothing if it cannot be the head of the frame with that index.
    static std::optional<FrameHead> read(LittleEndianReader& reader, int index);
};

// Between a and b, rounded down; differences are modulo 2^32 or 2^64.
constexpr std::int32_t between(std::int32_t a, std::int32_t b) {
    const auto difference = std::uint32_t(b) - std::uint32_t(a);
    return std::int32_t(std::uint32_t(a) + std::uint32_t(std::int32_t(difference) >> 1));
}
constexpr std::uint64_t between(std::uint64_t a, std::uint64_t b) {
    return a + std::uint64_t(std::int64_t(b - a) >> 1);
}

// Calls use(i, prediction) for each number. past, future: null if there is none; not both.
template <typename Number, typename Use>
void forEachPrediction(std::size_t count, const std::vector<Number>* past, const std::vector<Number>* future,
                       Use use) {
    if (past != nullptr && future != nullptr) {
        const Number* const a = past->data();
        const Number* const b = future->data();
        for (std::size_t i = 0; i < count; ++i)
            use(i, between(a[i], b[i]));
        return;
    }
    const Number* const only = past != nullptr ? past->data() : future->data();
    for (std::size_t i = 0; i < count; ++i)
        use(i, only[i]);
}

} // namespace clothlab
