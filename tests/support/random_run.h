// Random valid scenes, each with a state to start from, the same for a seed on every platform.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <cstdint>
#include <string>

namespace clothlab {

// What of the model a scene is made to exercise.
enum class Trial { Hanging, OnSphere, OnPlane, Folded, Thrown };
inline constexpr int kTrials = 5;
std::string_view name(Trial trial);

struct RandomRun {
    std::uint64_t seed = 0;
    Trial trial = Trial::Hanging;
    Scene scene;
    ClothState start;

    std::string describe() const; // seed and what it made, for a failure's message
};

// The trials take turns with the seed: seed % kTrials. Contact, folding or stretching happens within 300
// steps, and the stiffness is well within what the time step allows.
RandomRun randomRun(std::uint64_t seed);

} // namespace clothlab
