// Numbers of the course's model that no scene can change.
#pragma once

namespace clothlab {

inline constexpr double kMaxStrain = 0.1; // springs longer than 1.1 times their rest length are shortened
// A point on the far side of a plane is put this far above the side it came from. Metres.
inline constexpr double kPlaneOffset = 0.0001;

} // namespace clothlab
