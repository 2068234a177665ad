#pragma once

#include "simcore/scene/object_writer.h"
#include "simcore/scene/scene.h"

namespace clothlab {

// The members of the object appearance of a scene file: what is not at its default.
Entries appearanceEntries(const Appearance& appearance);

} // namespace clothlab
