// What is different between two scenes, in words.
#pragma once

#include "simcore/scene/scene.h"

#include <string>
#include <vector>

namespace clothlab {

// Of what moves the sheet, one entry a parameter and one for each other part of the scene: "cloth.ks 5000 ->
// 3000", "the spheres". Empty if both would move a sheet alike.
std::vector<std::string> motionDifferences(const Scene& before, const Scene& after);

} // namespace clothlab
