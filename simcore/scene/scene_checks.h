// The two halves of validate().
#pragma once

#include "simcore/scene/report.h"
#include "simcore/scene/scene.h"

namespace clothlab {

// Values that no solver could run. Leaves unknownKeys alone.
void findErrors(const Scene& scene, Report& report);

// Values that are likely a mistake. Precondition: findErrors() finds none.
void findWarnings(const Scene& scene, Report& report);

} // namespace clothlab
