#pragma once

#include "simcore/scene/scene.h"

#include <random>

namespace clothlab::test {

// A valid scene with values at, near and between the ends of their ranges, several colliders, and unknown
// keys at every level. The same seed gives the same scene.
Scene randomScene(std::uint32_t seed);

// Text of a JSON object without space: of unknown keys only, nested a few levels.
std::string randomObjectText(std::mt19937& random, int levels);

} // namespace clothlab::test
