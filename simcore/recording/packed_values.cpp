#include "simcore/recording/packed_values.h"

#include <bit>
#include <cmath>

namespace clothlab {
namespace {

constexpr std::array kAxes{&PointArray::x, &PointArray::y, &PointArray::z};

// A little less than twice the error, for the rounding of a few sums: each is off by 2^-53 of a coordinate,
// which is kMostSteps at most.
constexpr double kMargin = 0x1p-12;
constexpr double kMostSteps = 0x1p36;
constexpr double kMostFromOrigin = 0x1p29; // steps; sums and differences of two fit into 32 bits

bool allWithin(const std::vector<double>& values, double middle, double most) {
    int outside = 0;
    for (const double value : values)
        outside |= std::abs(value - middle) <= most ? 0 : 1; // also if it is not a number
    return outside == 0;
}

} // namespace

double stepFor(double error) {
    return 2 * error * (1 - kMargin);
}

std::optional<SteppedFrame> toSteps(const PointArray& positions, double error,
                                    const std::array<std::int64_t, 3>* origin) {
    const double step = stepFor(error);
    const double perStep = 1 / step;
    const std::size_t n = positions.size();
    SteppedFrame frame;
    frame.values.resize(3 * n);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<double>& from = positions.*kAxes[axis];
        if (!allWithin(from, 0, kMostSteps * step))
            return std::nullopt;
        frame.origin[axis] = origin != nullptr ? (*origin)[axis] : std::llround(from[0] * perStep);
        const auto first = double(frame.origin[axis]);
        if (!allWithin(from, first * step, kMostFromOrigin * step))
            return std::nullopt;
        std::int32_t* const to = &frame.values[axis * n];
        for (std::size_t i = 0; i < n; ++i) {
            const double steps = from[i] * perStep - first;
            to[i] = static_cast<std::int32_t>(steps + std::copysign(0.5, steps));
        }
    }
    return frame;
}

PointArray fromSteps(const SteppedFrame& frame, double error) {
    const double step = stepFor(error);
    const std::size_t n = frame.values.size() / 3;
    PointArray positions(n);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto first = double(frame.origin[axis]);
        const std::int32_t* const from = &frame.values[axis * n];
        std::vector<double>& to = positions.*kAxes[axis];
        for (std::size_t i = 0; i < n; ++i)
            to[i] = (double(from[i]) + first) * step;
    }
    return positions;
}

BitFrame toBits(const PointArray& positions) {
    BitFrame bits;
    bits.reserve(3 * positions.size());
    for (const auto axis : kAxes)
        for (const double value : positions.*axis)
            bits.push_back(std::bit_cast<std::uint64_t>(value));
    return bits;
}

PointArray fromBits(const BitFrame& bits) {
    const std::size_t n = bits.size() / 3;
    PointArray positions(n);
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < n; ++i)
            (positions.*kAxes[axis])[i] = std::bit_cast<double>(bits[axis * n + i]);
    return positions;
}

} // namespace clothlab
