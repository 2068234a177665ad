#include "tests/support/oracle_run.h"

#include "tests/support/states.h"

#include <cmath>
#include <sstream>

namespace clothlab {
std::string OracleRun::describe() const {
    std::ostringstream out;
    out << distance << " m apart after " << steps << " steps; " << counts.selfCollisions
        << " self-collisions, " << counts.sphereContacts << " sphere contacts, " << counts.planeContacts
        << " plane contacts, " << counts.strainLimits << " strain limits";
    return out.str();
}

OracleRun runBeside(const Start& start, int steps, const SolverSettings& settings) {
    VerletSolver solver(start.scene, settings);
    ClothState state = start.state;
    oracle::Cloth cloth(start.scene);
    copyState(start.state, cloth.points);
    OracleRun run;
    for (run.steps = 0; run.steps < steps; ++run.steps) {
        const StepResult done = solver.step(state);
        if (done.blowUp) {
            run.distance = INFINITY;
            return run;
        }
        cloth.step();
        run.strainLimits += done.strainLimitCorrections;
    }
    run.distance = greatestDistance(state.position, cloth.points);
    run.counts = cloth.counts;
    return run;
}

} // namespace clothlab
