#include "simcore/solver/frame_runner.h"

#include <sstream>

namespace clothlab {

FrameResult runFrame(VerletSolver& solver, ClothState& state, const std::atomic<bool>& stop) {
    const int steps = solver.scene().simulation.stepsPerFrame;
    const RunResult run = solver.run(state, steps, stop);
    FrameResult result;
    result.finished = run.steps == steps;
    result.strainLimitCorrections = run.strainLimitCorrections;
    result.blowUp = run.blowUp;
    result.blowUpStep = run.blowUp ? run.steps + 1 : 0;
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
