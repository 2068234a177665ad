// A blow-up in words.
#pragma once

#include "simcore/solver/verlet_solver.h"

#include <string>

namespace clothlab {

// "blew up in frame 12, step 3, phase Verlet, at point 17 (17, 0); …", and then whether the step of `scene`,
// with which it was computed, is too long for its springs: how many steps per frame are enough, or what else
// may be the cause. For a sentence that begins "The cloth" and that the caller ends.
std::string describeBlowUp(const BlowUp& blowUp, int step, int frame, const Scene& scene);

} // namespace clothlab
