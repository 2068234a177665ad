#include "simcore/solver/frame_runner.h"

#include <sstream>

namespace clothlab {

FrameResult runFrame(VerletSolver& solver, ClothState& state, const std::atomic<bool>& stop) {
    FrameResult result;
    for (int step = 1; step <= solver.scene().simulation.stepsPerFrame; ++step) {
        if (stop.load(std::memory_order_relaxed))
            return result;
        const StepResult done = solver.step(state);
        result.strainLimitCorrections += done.strainLimitCorrections;
        if (done.blowUp) {
            result.blowUp = done.blowUp;
            result.blowUpStep = step;
            return result;
        }
    }
    result.finished = true;
    return result;
}

std::string describeBlowUp(const BlowUp& blowUp, int step, int frame, const Grid& grid) {
    const GridPoint place = grid.place(blowUp.point);
    std::ostringstream text;
    text << "blew up in frame " << frame << ", step " << step << ", phase " << name(blowUp.phase)
         << ", at point " << blowUp.point << " (" << place.x << ", " << place.y
         << "); more steps per frame, a lower ks or a higher density make the step stable";
    return text.str();
}

} // namespace clothlab
