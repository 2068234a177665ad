#include "simcore/recording/bit_planes.h"
#include "simcore/recording/frame_codec.h"
#include "simcore/recording/number_codec.h"
#include "simcore/recording/packed_frame.h"

namespace clothlab {

struct FrameUnpacker::Work {
    Work(const Grid& sheet, double greatestError, int frames, BytesOf bytes)
        : grid(sheet), error(greatestError), bytesOf(std::move(bytes)),
          numbers(sheet), above{RowAbove(sheet.width), RowAbove(sheet.width), RowAbove(sheet.width)},
          known(std::size_t(frames)) {}

    struct KnownFrame {
        bool tried = false;
        std::optional<SteppedFrame> steps;
        BitFrame bits; // empty: it is not of this kind
    };

    const KnownFrame* know(int index);
    bool unpack(int index, KnownFrame& frame);
    bool unpackSteps(const FrameHead& head, LittleEndianReader& reader, KnownFrame& frame);
    bool unpackBits(const FrameHead& head, LittleEndianReader& reader, KnownFrame& frame);
    void restore(const FrameHead& head, std::vector<std::int32_t>& values);

    Grid grid;
    double error;
    BytesOf bytesOf;
    NumberUnpacker numbers;
    std::array<RowAbove, 3> above;
    std::vector<KnownFrame> known;
};

// Null if it cannot be unpacked.
const FrameUnpacker::Work::KnownFrame* FrameUnpacker::Work::know(int index) {
    if (index >= int(known.size()))
        return nullptr;
    KnownFrame& frame = known[std::size_t(index)];
    if (!frame.tried) {
        frame.tried = true;
        if (!unpack(index, frame)) {
            frame.steps.reset();
            frame.bits.clear();
        }
    }
    return frame.steps || !frame.bits.empty() ? &frame : nullptr;
}

bool FrameUnpacker::Work::unpack(int index, KnownFrame& frame) {
    const std::optional<std::string> bytes = bytesOf(index);
    if (!bytes)
        return false;
    LittleEndianReader reader(*bytes);
    const auto head = FrameHead::read(reader, index);
    if (!head)
        return false;
    return head->kind == FrameKind::Bits ? unpackBits(*head, reader, frame)
                                         : unpackSteps(*head, reader, frame);
}

void FrameUnpacker::Work::restore(const FrameHead& head, std::vector<std::int32_t>& values) {
    const auto width = std::size_t(grid.width);
    const auto n = std::size_t(grid.pointCount());
    for (std::size_t y = 0; y < std::size_t(grid.height); ++y) {
        std::array<std::int32_t*, 3> rows{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            rows[axis] = &values[axis * n + y * width];
            numbers.nextRow(rows[axis]);
        }
        restoreRows(head.weights, grid.width, y > 0 ? &above : nullptr, rows);
        for (std::size_t axis = 0; axis < 3; ++axis)
            above[axis].set(rows[axis]);
    }
}

bool FrameUnpacker::Work::unpackSteps(const FrameHead& head, LittleEndianReader& reader, KnownFrame& frame) {
    if (!(error > 0))
        return false;
    std::array<const SteppedFrame*, 2> others{};
    for (const auto& [other, index] : {std::pair(&others[0], head.past), std::pair(&others[1], head.future)})
        if (index != kNoFrame) {
            const KnownFrame* found = know(index);
            if (found == nullptr || !found->steps)
                return false;
            *other = &*found->steps;
        }
    if (others[0] != nullptr && others[1] != nullptr && others[0]->origin != others[1]->origin)
        return false;
    // Only now: frames that are needed first have used the same unpacker.
    if (!numbers.begin(reader.rest()))
        return false;
    SteppedFrame& steps = frame.steps.emplace();
    steps.origin = others[0] != nullptr   ? others[0]->origin
                   : others[1] != nullptr ? others[1]->origin
                                          : head.origin;
    steps.values.resize(3 * std::size_t(grid.pointCount()));
    restore(head, steps.values);
    if (!head.predicted())
        return true;
    const auto valuesOf = [](const SteppedFrame* other) {
        return other == nullptr ? nullptr : &other->values;
    };
    std::int32_t* const to = steps.values.data();
    forEachPrediction(steps.values.size(), valuesOf(others[0]), valuesOf(others[1]),
                      [&](std::size_t i, std::int32_t predicted) {
                          to[i] = std::int32_t(std::uint32_t(to[i]) + std::uint32_t(predicted));
                      });
    return true;
}

bool FrameUnpacker::Work::unpackBits(const FrameHead& head, LittleEndianReader& reader, KnownFrame& frame) {
    std::array<const BitFrame*, 2> others{};
    for (const auto& [other, index] : {std::pair(&others[0], head.past), std::pair(&others[1], head.future)})
        if (index != kNoFrame) {
            const KnownFrame* found = know(index);
            if (found == nullptr || found->bits.empty())
                return false;
            *other = &found->bits;
        }
    BitFrame bits(3 * std::size_t(grid.pointCount()));
    std::string_view rest = reader.rest();
    if (!readPlanes(rest, bits) || !rest.empty())
        return false;
    if (head.predicted()) {
        forEachPrediction(bits.size(), others[0], others[1], [&](std::size_t i, std::uint64_t predicted) {
            bits[i] = unfoldedSum(bits[i], predicted);
        });
    } else {
        for (std::size_t i = 0; i < bits.size(); ++i)
            bits[i] = unfoldedSum(bits[i], i == 0 ? 0 : bits[i - 1]);
    }
    frame.bits = std::move(bits);
    return true;
}

FrameUnpacker::FrameUnpacker(const Grid& grid, double error, int frames, BytesOf bytesOf)
    : m_work(std::make_unique<Work>(grid, error, frames, std::move(bytesOf))) {}
FrameUnpacker::~FrameUnpacker() = default;
FrameUnpacker::FrameUnpacker(FrameUnpacker&&) noexcept = default;
FrameUnpacker& FrameUnpacker::operator=(FrameUnpacker&&) noexcept = default;

std::optional<PointArray> FrameUnpacker::positions(int index) {
    const auto* frame = m_work->know(index);
    if (frame == nullptr)
        return std::nullopt;
    return frame->steps ? fromSteps(*frame->steps, m_work->error) : fromBits(frame->bits);
}

} // namespace clothlab
