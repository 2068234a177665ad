#pragma once

#include "simcore/cloth/cloth_state.h"

namespace clothlab {

// A point on the far side of a plane is put this far above the side it came from. Metres.
inline constexpr double kPlaneOffset = 0.0001;

// Moves every unpinned point that is inside the sphere to its surface, less friction (physics.md, phase 4).
// A point exactly at the origin is pushed out along +y.
void collide(const Sphere& sphere, const std::vector<std::uint8_t>& pinned, ClothState& state);

// Moves every unpinned point that crossed the plane since its last position back to the side it came from.
// A last position on the plane counts as on the side the normal points to.
void collide(const Plane& plane, const std::vector<std::uint8_t>& pinned, ClothState& state);

} // namespace clothlab
