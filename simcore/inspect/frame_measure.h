// What a recording keeps of each frame beside its positions.
#pragma once

#include "simcore/inspect/touching_points.h"
#include "simcore/recording/frame_facts.h"
#include "simcore/recording/recording.h"

#include <array>
#include <vector>

namespace clothlab {

// A point this near to the surface of a sphere or plane, or within a sphere, touches it: points at rest on a
// plane, which puts them 0.1 mm above it, bounce within about this height.
inline constexpr double kContactDistance = 1e-3; // m

// Makes the facts of one frame of a sheet after another. Holds buffers and rest lengths, so that a frame
// costs little. To be used by one thread at a time.
class FrameMeasure {
public:
    explicit FrameMeasure(const Sheet& sheet);

    // Points of the frame's state as the sheet's. A point touches something if another that no spring joins
    // with it, switched on or not, is nearer than 2 * thickness, or if it is within kContactDistance of a
    // collider of the frame's scene. In a state that is not finite nothing touches.
    FrameFacts factsOf(const Frame& frame);

private:
    double greatestStrain(const Cloth& cloth, const PointArray& position) const;
    void touchColliders(const Scene& scene, const PointArray& position);

    Grid m_grid;
    std::array<std::vector<double>, kStencils.size()> m_perRestSquared; // 1 / rest length², row-major
    TouchingPoints m_touchingPoints;
    std::vector<std::uint8_t> m_touches; // by point
};

// The same for one frame.
FrameFacts factsOf(const Frame& frame, const Sheet& sheet);

} // namespace clothlab
