// What is different between two scenes.
#pragma once

#include "simcore/scene/parameters.h"
#include "simcore/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace clothlab {

// A parameter with its values in the file's unit or, if that is null, another part of the scene.
struct SceneDifference {
    const Parameter* parameter = nullptr;
    double before = 0;
    double after = 0;
    std::string_view part; // "the spheres"
};

// Of what moves the sheet. Empty if both would move a sheet alike.
std::vector<SceneDifference> motionDifferences(const Scene& before, const Scene& after);

std::string toText(const SceneDifference& difference); // "cloth.ks 5000 -> 3000", "the spheres"

} // namespace clothlab
