// Whether the time step is short enough for the springs of a sheet: explicit integration multiplies the
// fastest oscillation of the sheet in every step, to infinity, if dt times its angular frequency is too much.
//
// Bound. Linearised about a flat sheet at rest, springs give dx = v the energy v·Kv / 2 with
//   v·Kv = Σ over springs a–b of k (d·(va − vb))² <= Σ 2k ((d·va)² + (d·vb)²) = 2 Σ over points p of vp·Ap vp
// and Ap = Σ over the springs at p of k d dᵀ; d is the unit direction of a spring, k its stiffness in N/m,
// and (s − t)² <= 2s² + 2t². So ω² <= (2/m) max over p of the greatest eigenvalue of Ap: 8.8 ks/m for a large
// grid of squares with all springs on (the true value is 8 ks/m, so ω is 5 % too high there), up to
// 12.8 ks/m for one of long rectangles. For sheets of a few points ω may be up to a quarter too high. Pins
// only lower ω; the bound does not count them.
//
// Limit. A mode of frequency ω moves by x' = x + c (x − x_last) − (dt ω)² x with c = 1 − damping/100. The
// roots of z² − (1 + c − (dt ω)²) z + c lie within the unit circle, by Jury's criterion, if |c| < 1,
// (dt ω)² > 0 and (dt ω)² < 2 (1 + c); for c = 1 they lie on it under the same condition. So the limit of
// dt ω is sqrt(2 (1 + c)): 2 undamped, √2 where damping takes all velocity. At the limit itself, which counts
// as stable here, an undamped mode grows with the number of steps, not with its power.
//
// What it is not. The bound is sufficient, not necessary: cloth may still run a little beyond it, and far
// beyond it the strain limit may keep a sheet from blowing up, which then trembles. And it is one for the
// flat sheet at rest. Folds that lay the springs of a point along one line can bring ω² up to 17.6 ks/m,
// strained springs add stiffness across their direction, and a vertical sheet starts as uneven as ± 1 mm,
// which is much if its points are as close as that. Colliders, self-collision and the strain limit are not in
// it.
#pragma once

#include "simcore/base/diagnostic.h"
#include "simcore/cloth/cloth_state.h"

#include <optional>
#include <string>

namespace clothlab {

struct Stability {
    double dtOmega = 0; // the bound above, radians a step; infinite if it is more than a double holds
    double limit = 2;   // of dtOmega
    // The least number of steps per frame with dtOmega <= limit, at this number of frames per second; none
    // if it is more than simulation.steps_per_frame may be.
    std::optional<int> stableStepsPerFrame;

    bool stable() const { return dtOmega <= limit; }
};

// Takes the same short time for sheets of any size. Precondition: validate(scene) has no errors; with numbers
// out of range, the step at worst counts as unstable.
Stability stability(const Scene& scene);

// The bound of ω in rad/s, for the flat sheet at rest; 0 without springs, NaN or infinite if ks or the mass
// of a point are out of range.
double greatestAngularFrequency(const Cloth& cloth);

// dtOmega and limit for people, with as many decimals as tell one beyond the other: "31.2" and "2.00".
struct StabilityText {
    std::string dtOmega;
    std::string limit;
};
StabilityText textOf(const Stability& stability);

int maxStepsPerFrame(); // that a scene may have

// Puts a warning in front if the step is not stable: "dt·ω is 2.31, beyond 2.00 …; 35 steps per frame …".
void warnOfStep(const Scene& scene, Diagnostics& diagnostics);

} // namespace clothlab
