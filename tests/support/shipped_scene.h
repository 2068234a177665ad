#pragma once

#include "simcore/scene/scene.h"

#include <string>

namespace clothlab::test {

// scenes/NAME.json of the source tree. Ends the program with a message if it can't be read.
Scene shippedScene(const std::string& name);

} // namespace clothlab::test
