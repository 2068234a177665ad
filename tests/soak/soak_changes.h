// What the soak program does to a running scene.
#pragma once

#include "simcore/scene/scene.h"
#include "tests/support/random.h"

#include <string>

namespace clothlab::soak {

struct Setup {
    std::string name; // of the scene's file, without .json
    Scene scene;
    int threads = 1;
};

// One to three parameters at random.
void changeAtRandom(SplitMix64& random, Setup& setup);

std::string describe(const Setup& setup); // in one line

} // namespace clothlab::soak
