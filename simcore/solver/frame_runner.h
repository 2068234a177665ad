// Whole frames: stepsPerFrame steps each.
#pragma once

#include "simcore/solver/verlet_solver.h"

#include <atomic>
#include <functional>
#include <memory>
#include <span>

namespace clothlab {

struct FrameResult {
    bool finished = false;                   // false: stopped by the flag, between two steps, or blown up
    std::int64_t strainLimitCorrections = 0; // in this frame
    std::optional<BlowUp> blowUp;
    int blowUpStep = 0; // 1 … stepsPerFrame, where it blew up
};

// Stops between two steps once stop is true.
FrameResult runFrame(VerletSolver& solver, ClothState& state, const std::atomic<bool>& stop);

// Called after each frame that finished, by its place in the list. False: that is enough.
using FrameVisitor = std::function<bool(std::size_t index, const ClothState& state, const FrameResult&)>;

// Runs the frames of a recording again: from the exact state before the first of them, each with the scene it
// was computed with. The state is then that of the last frame that finished. Ends early when stop is true, a
// frame blows up or visit returns false. Precondition: compareScenes() of any two scenes is not
// SceneChange::Start, nor with the solver's.
struct RepeatResult {
    std::size_t frames = 0; // that finished
    FrameResult last;       // of the last that was begun
};
RepeatResult repeatFrames(VerletSolver& solver, ClothState& state,
                          std::span<const std::shared_ptr<const Scene>> scenes, const std::atomic<bool>& stop,
                          const FrameVisitor& visit = {});

} // namespace clothlab
