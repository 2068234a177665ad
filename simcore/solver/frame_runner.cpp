#include "simcore/solver/frame_runner.h"

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

} // namespace clothlab
