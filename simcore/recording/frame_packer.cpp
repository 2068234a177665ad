#include "simcore/recording/bit_planes.h"
#include "simcore/recording/frame_codec.h"
#include "simcore/recording/number_codec.h"
#include "simcore/recording/packed_frame.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace clothlab {
namespace {

struct KnownFrame {
    std::optional<SteppedFrame> steps;
    BitFrame bits;
};

// How much there is to say of numbers, once the one to the left is known: of some rows.
std::int64_t roughCost(const Grid& grid, const std::vector<std::int32_t>& values) {
    constexpr int kSomeRows = 36;
    const int stride = std::max(1, grid.height * 3 / kSomeRows);
    std::int64_t cost = 0;
    for (int y = 0; y < 3 * grid.height; y += stride) {
        const std::int32_t* const row = &values[std::size_t(y) * std::size_t(grid.width)];
        for (int x = 1; x < grid.width; ++x)
            cost += std::abs(std::int64_t(row[x]) - row[x - 1]);
    }
    return cost;
}

} // namespace

struct FramePacker::Work {
    Work(const Grid& sheet, double greatestError)
        : grid(sheet), error(greatestError), numbers(sheet), above(sheet.width) {}

    std::string packSteps(std::vector<KnownFrame>& known, const GroupPlace& place, SteppedFrame frame);
    std::string packBits(std::vector<KnownFrame>& known, const GroupPlace& place, BitFrame frame) const;
    std::string packFrame(std::vector<KnownFrame>& known, const GroupPlace& place,
                          const PointArray& positions);
    void predict(const std::vector<KnownFrame>& known, const SteppedFrame& frame, FrameHead& head);
    void appendRows(FrameHead& head, std::string& out);

    Grid grid;
    double error;
    NumberPacker numbers;
    RowAbove above;
    std::vector<std::int32_t> residual; // of a frame, after what other frames say of it
    std::vector<std::int32_t> trial;
};

// Leaves in residual what the frames of the head do not say; forgets them if they say nothing.
void FramePacker::Work::predict(const std::vector<KnownFrame>& known, const SteppedFrame& frame,
                                FrameHead& head) {
    residual = frame.values;
    if (!head.predicted())
        return;
    const auto valuesOf = [&](int index) {
        return index == kNoFrame ? nullptr : &known[std::size_t(index)].steps->values;
    };
    trial.resize(residual.size());
    forEachPrediction(residual.size(), valuesOf(head.past), valuesOf(head.future),
                      [&](std::size_t i, std::int32_t predicted) { trial[i] = residual[i] - predicted; });
    if (roughCost(grid, trial) <= roughCost(grid, residual))
        residual.swap(trial);
    else
        head.past = head.future = kNoFrame;
}

void FramePacker::Work::appendRows(FrameHead& head, std::string& out) {
    const auto width = std::size_t(grid.width);
    const auto n = std::size_t(grid.pointCount());
    for (std::size_t axis = 0; axis < 3; ++axis)
        head.weights[axis] = fitWeights(grid, &residual[axis * n]);
    head.append(out);
    numbers.begin();
    trial.resize(width);
    for (std::size_t y = 0; y < std::size_t(grid.height); ++y)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int32_t* const row = &residual[axis * n + y * width];
            if (y > 0)
                above.set(row - width);
            predictRow(head.weights[axis], grid.width, y > 0 ? &above : nullptr, row, trial.data());
            numbers.addRow(trial.data());
        }
    numbers.finish(out);
}

std::string FramePacker::Work::packSteps(std::vector<KnownFrame>& known, const GroupPlace& place,
                                         SteppedFrame frame) {
    FrameHead head;
    head.origin = frame.origin;
    const auto usable = [&](int index) {
        return index != kNoFrame && known[std::size_t(index)].steps &&
               known[std::size_t(index)].steps->origin == frame.origin;
    };
    head.past = usable(place.past) ? place.past : kNoFrame;
    head.future = usable(place.future) ? place.future : kNoFrame;
    predict(known, frame, head);
    std::string out;
    appendRows(head, out);
    known[std::size_t(place.index)].steps = std::move(frame);
    return out;
}

// Positions that keep their bits in between others of which only steps are known are packed alone.
std::string FramePacker::Work::packBits(std::vector<KnownFrame>& known, const GroupPlace& place,
                                        BitFrame frame) const {
    FrameHead head;
    head.kind = FrameKind::Bits;
    const auto usable = [&](int index) {
        return index != kNoFrame && !known[std::size_t(index)].bits.empty();
    };
    head.past = usable(place.past) ? place.past : kNoFrame;
    head.future = usable(place.future) ? place.future : kNoFrame;
    std::string out;
    head.append(out);
    const auto bitsOf = [&](int index) {
        return index == kNoFrame ? nullptr : &known[std::size_t(index)].bits;
    };
    BitFrame folded(frame.size());
    if (head.predicted()) {
        forEachPrediction(frame.size(), bitsOf(head.past), bitsOf(head.future),
                          [&](std::size_t i, std::uint64_t predicted) {
                              folded[i] = foldedDifference(frame[i], predicted);
                          });
    } else {
        for (std::size_t i = 0; i < frame.size(); ++i)
            folded[i] = foldedDifference(frame[i], i == 0 ? 0 : frame[i - 1]);
    }
    appendPlanes(out, folded);
    known[std::size_t(place.index)].bits = std::move(frame);
    return out;
}

std::string FramePacker::Work::packFrame(std::vector<KnownFrame>& known, const GroupPlace& place,
                                         const PointArray& positions) {
    if (error > 0) {
        for (const int other : {place.past, place.future})
            if (other != kNoFrame)
                if (const auto& steps = known[std::size_t(other)].steps)
                    if (auto frame = toSteps(positions, error, &steps->origin))
                        return packSteps(known, place, std::move(*frame));
        if (auto frame = toSteps(positions, error, nullptr))
            return packSteps(known, place, std::move(*frame));
    }
    return packBits(known, place, toBits(positions));
}

FramePacker::FramePacker(const Grid& grid, double error) : m_work(std::make_unique<Work>(grid, error)) {}
FramePacker::~FramePacker() = default;
FramePacker::FramePacker(FramePacker&&) noexcept = default;
FramePacker& FramePacker::operator=(FramePacker&&) noexcept = default;

const Grid& FramePacker::grid() const {
    return m_work->grid;
}

double FramePacker::error() const {
    return m_work->error;
}

std::vector<std::string> FramePacker::pack(std::span<const PointArray* const> frames) {
    assert(!frames.empty() && frames.size() <= kFramesPerGroup);
    std::vector<KnownFrame> known(frames.size());
    std::vector<std::string> packed(frames.size());
    for (const GroupPlace& place : groupOrder(int(frames.size())))
        packed[std::size_t(place.index)] = m_work->packFrame(known, place, *frames[std::size_t(place.index)]);
    return packed;
}

} // namespace clothlab
