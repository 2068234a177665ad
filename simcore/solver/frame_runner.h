// Whole frames: stepsPerFrame steps each.
#pragma once

#include "simcore/solver/verlet_solver.h"

#include <atomic>

namespace clothlab {

struct FrameResult {
    bool finished = false;                   // false: stopped by the flag, between two steps, or blown up
    std::int64_t strainLimitCorrections = 0; // in this frame
    std::optional<BlowUp> blowUp;
    int blowUpStep = 0; // 1 … stepsPerFrame, where it blew up
};

// Stops between two steps once stop is true.
FrameResult runFrame(VerletSolver& solver, ClothState& state, const std::atomic<bool>& stop);

} // namespace clothlab
