// Scenes that are quick to simulate.
#pragma once

#include "simcore/scene/scene.h"

namespace clothlab::test {

// 4 by 4 points hung up at two corners, three steps a frame. Valid and without warnings.
Scene tinyScene();

// The same with springs so stiff that it blows up: in its second frame, not its first.
Scene unstableScene();

} // namespace clothlab::test
