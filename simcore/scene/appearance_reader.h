#pragma once

#include "simcore/scene/object_reader.h"

namespace clothlab {

// The object appearance of a scene file, into a scene.
void readAppearance(const ValueReader& value, Scene& scene, Report& report);

} // namespace clothlab
