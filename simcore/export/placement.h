// How coordinates go into files: which axis is up there, and what a unit is.
#pragma once

#include "simcore/base/vec3.h"

#include <string>

namespace clothlab {

enum class UpAxis { Y, Z };

struct Placement {
    UpAxis up = UpAxis::Y;    // Z: the sheet is turned, (x, y, z) -> (x, -z, y)
    double unitsPerMetre = 1; // above 0
};

// A direction, whose length stays.
inline Vec3 turned(const Placement& placement, const Vec3& v) {
    return placement.up == UpAxis::Y ? v : Vec3(v.x(), -v.z(), v.y());
}

// A place in metres, or a velocity. With the default placement the same bits.
inline Vec3 placed(const Placement& placement, const Vec3& v) {
    return turned(placement, v) * placement.unitsPerMetre;
}

std::string describe(const Placement& placement); // "metres, y up", "100 units per metre, z up"

} // namespace clothlab
