// simcore and the oracle side by side over a run.
#pragma once

#include "simcore/cloth/cloth_state.h"
#include "tests/support/oracle.h"

#include <string>

namespace clothlab {

inline constexpr int kOracleSteps = 300; // in which contact, folds and limits all act

struct Start {
    Scene scene;
    ClothState state;
};

struct OracleRun {
    // m, after the last step. Infinite if simcore reported a blow-up.
    double distance = 0;
    // m, the worst of all steps where the oracle took each step from simcore's state.
    double distanceInOneStep = 0;
    int steps = 0; // compared
    oracle::Counts counts;
    std::int64_t strainLimits = 0; // as simcore counts them

    std::string describe() const;
};

OracleRun runBeside(const Start& start, int steps);

// Points that bounce on a plane or crowd in a fold double any rounding error every few steps, whoever
// computes them, so that two right answers part. This is for how many steps the oracle stays within `limit`
// metres of itself started one bit away: so long can anything be expected to stay near it.
int predictableSteps(const Start& start, int steps, double limit);

// What is wrong with a run that started there; empty if nothing is. A scene that amplifies rounding errors is
// compared for as long as the oracle agrees with itself, and step by step to the end.
std::string disagreement(const Start& start, const OracleRun& run);

} // namespace clothlab
