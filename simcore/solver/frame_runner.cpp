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

RepeatResult repeatFrames(VerletSolver& solver, ClothState& state,
                          std::span<const std::shared_ptr<const Scene>> scenes, const std::atomic<bool>& stop,
                          const FrameVisitor& visit) {
    RepeatResult result;
    const Scene* current = nullptr;
    for (const auto& scene : scenes) {
        if (scene.get() != current)
            solver.setScene(*scene);
        current = scene.get();
        result.last = runFrame(solver, state, stop);
        if (!result.last.finished)
            break;
        ++result.frames;
        if (visit && !visit(result.frames - 1, state, result.last))
            break;
    }
    return result;
}

} // namespace clothlab
