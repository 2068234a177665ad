#include "simcore/solver/frame_runner.h"

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

} // namespace clothlab
