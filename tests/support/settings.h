// Ways to compute that must all give the same bits.
#pragma once

#include "simcore/solver/verlet_solver.h"

#include <string>
#include <vector>

namespace clothlab {

std::string describe(const SolverSettings& settings);

// The plainest way, which the others are compared with.
SolverSettings plainSettings();

// Every instruction set of this machine with 1, 2, 3 and 8 threads, also on sheets too small to be worth it.
std::vector<SolverSettings> allSettings();

} // namespace clothlab
