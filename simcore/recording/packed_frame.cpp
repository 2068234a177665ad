#include "simcore/recording/packed_frame.h"

namespace clothlab {
namespace {

void append(std::string& out, const PointWeights& weights) {
    for (const std::int8_t weight : {weights.left, weights.above, weights.aboveLeft, weights.aboveRight})
        appendLittleEndian(out, weight);
}

PointWeights readWeights(LittleEndianReader& reader) {
    PointWeights weights;
    for (std::int8_t* weight : {&weights.left, &weights.above, &weights.aboveLeft, &weights.aboveRight})
        *weight = reader.read<std::int8_t>();
    return weights;
}

// A chain of such frames ends: each is on a higher level than the one before.
bool mayPredict(int other, int index) {
    return other == kNoFrame || groupLevel(other) > groupLevel(index);
}

} // namespace

void FrameHead::append(std::string& out) const {
    appendLittleEndian(out, static_cast<std::uint8_t>(kind));
    appendLittleEndian(out, static_cast<std::uint8_t>(past));
    appendLittleEndian(out, static_cast<std::uint8_t>(future));
    if (kind == FrameKind::Bits)
        return;
    if (!predicted())
        for (const std::int64_t steps : origin)
            appendLittleEndian(out, steps);
    for (const PointWeights& w : weights)
        clothlab::append(out, w);
}

std::optional<FrameHead> FrameHead::read(LittleEndianReader& reader, int index) {
    FrameHead head;
    const auto kind = reader.read<std::uint8_t>();
    head.past = reader.read<std::uint8_t>();
    head.future = reader.read<std::uint8_t>();
    if (kind > static_cast<std::uint8_t>(FrameKind::Bits) || !mayPredict(head.past, index) ||
        !mayPredict(head.future, index))
        return std::nullopt;
    head.kind = static_cast<FrameKind>(kind);
    if (head.kind == FrameKind::Steps) {
        if (!head.predicted())
            for (std::int64_t& steps : head.origin)
                steps = reader.read<std::int64_t>();
        for (PointWeights& w : head.weights)
            w = readWeights(reader);
    }
    if (!reader.good())
        return std::nullopt;
    return head;
}

} // namespace clothlab
