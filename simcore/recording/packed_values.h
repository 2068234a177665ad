// What a frame is while it is packed: whole numbers, of steps or of bits.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace clothlab {

// Coordinates as steps from an origin, one coordinate after the other.
struct SteppedFrame {
    std::array<std::int64_t, 3> origin{}; // steps
    std::vector<std::int32_t> values;     // steps from the origin
};

// The bits of coordinates, one coordinate after the other.
using BitFrame = std::vector<std::uint64_t>;

double stepFor(double error); // m

// Nothing if a coordinate is not finite or too far out. Origin: that of another frame, or near the first
// point.
std::optional<SteppedFrame> toSteps(const PointArray& positions, double error,
                                    const std::array<std::int64_t, 3>* origin);
PointArray fromSteps(const SteppedFrame& frame, double error);

BitFrame toBits(const PointArray& positions);
PointArray fromBits(const BitFrame& bits);

} // namespace clothlab
