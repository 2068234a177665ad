// simcore and the oracle side by side over a run.
#pragma once

#include "simcore/solver/verlet_solver.h"
#include "tests/support/oracle.h"

#include <string>

namespace clothlab {

inline constexpr int kOracleSteps = 300; // in which contact, folds and limits all act

struct Start {
    Scene scene;
    ClothState state;
};

struct OracleRun {
    // m, the greatest of any point after the last step. Infinite if simcore reported a blow-up.
    double distance = 0;
    int steps = 0; // compared
    oracle::Counts counts;
    std::int64_t strainLimits = 0; // as simcore counts them

    std::string describe() const;
};

OracleRun runBeside(const Start& start, int steps, const SolverSettings& settings = {});

} // namespace clothlab
