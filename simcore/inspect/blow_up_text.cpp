#include "simcore/inspect/blow_up_text.h"

#include "simcore/inspect/stability.h"

#include <sstream>

namespace clothlab {
namespace {

std::string causeOf(const Scene& scene) {
    const Stability found = stability(scene);
    const auto [dtOmega, limit] = textOf(found);
    if (found.stable())
        return "dt·ω is " + dtOmega + " of " + limit +
               ", so the step is stable for the sheet at rest; a collider, self-collision, or the strain and "
               "folds of the sheet may be the cause";
    const std::string beyond = "dt·ω is " + dtOmega + ", beyond " + limit + ": ";
    if (!found.stableStepsPerFrame)
        return beyond + "no number of steps per frame up to " + std::to_string(maxStepsPerFrame()) +
               " makes the step stable, only a lower ks or a higher density";
    return beyond + "at least " + std::to_string(*found.stableStepsPerFrame) +
           " steps per frame (or a lower ks, a higher density) make the step stable";
}

} // namespace

std::string describeBlowUp(const BlowUp& blowUp, int step, int frame, const Scene& scene) {
    const GridPoint place = gridOf(scene.cloth).place(blowUp.point);
    std::ostringstream text;
    text << "blew up in frame " << frame << ", step " << step << ", phase " << name(blowUp.phase)
         << ", at point " << blowUp.point << " (" << place.x << ", " << place.y << "); " << causeOf(scene);
    return text.str();
}

} // namespace clothlab
