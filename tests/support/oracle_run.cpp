#include "tests/support/oracle_run.h"

#include "simcore/solver/verlet_solver.h"
#include "tests/support/states.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace clothlab {
namespace {

constexpr double kTolerance = 1e-9;        // m, after a run
constexpr double kStepTolerance = 1e-14;   // m, in one step
constexpr double kPredictable = 1e-12;     // m
constexpr int kLeastPredictableSteps = 80; // of a scene that loses its predictability

} // namespace

std::string OracleRun::describe() const {
    std::ostringstream out;
    out << distance << " m apart after " << steps << " steps, " << distanceInOneStep
        << " m at most in one step; " << counts.selfCollisions << " self-collisions, "
        << counts.sphereContacts << " sphere contacts, " << counts.planeContacts << " plane contacts, "
        << counts.strainLimits << " strain limits";
    return out.str();
}

OracleRun runBeside(const Start& start, int steps) {
    VerletSolver solver(start.scene);
    ClothState state = start.state;
    oracle::Cloth cloth(start.scene);
    copyState(start.state, cloth.points);
    oracle::Cloth follower(start.scene);
    OracleRun run;
    for (run.steps = 0; run.steps < steps; ++run.steps) {
        copyState(state, follower.points);
        const StepResult done = solver.step(state);
        if (done.blowUp) {
            run.distance = INFINITY;
            return run;
        }
        cloth.step();
        follower.step();
        run.distanceInOneStep =
            std::max(run.distanceInOneStep, greatestDistance(state.position, follower.points));
        run.strainLimits += done.strainLimitCorrections;
    }
    run.distance = greatestDistance(state.position, cloth.points);
    run.counts = cloth.counts;
    return run;
}

int predictableSteps(const Start& start, int steps, double limit) {
    oracle::Cloth cloth(start.scene);
    oracle::Cloth twin(start.scene);
    copyState(start.state, cloth.points);
    copyState(start.state, twin.points);
    for (oracle::PointMass& p : twin.points) {
        if (!p.pinned) {
            p.position.y() = std::nextafter(p.position.y(), INFINITY);
            p.lastPosition.y() = std::nextafter(p.lastPosition.y(), INFINITY);
        }
    }
    for (int step = 0; step < steps; ++step) {
        cloth.step();
        twin.step();
        double apart = 0;
        for (std::size_t i = 0; i < cloth.points.size(); ++i)
            apart = std::max(apart, (cloth.points[i].position - twin.points[i].position).norm());
        if (!(apart <= limit))
            return step;
    }
    return steps;
}

std::string disagreement(const Start& start, const OracleRun& run) {
    if (!(run.distanceInOneStep < kStepTolerance))
        return "a step differs: " + run.describe();
    if (run.distance < kTolerance)
        return run.strainLimits == run.counts.strainLimits ? "" : "other strain limits: " + run.describe();
    const int predictable = predictableSteps(start, run.steps, kPredictable);
    if (predictable == run.steps || predictable < kLeastPredictableSteps)
        return run.describe() + "; predictable for " + std::to_string(predictable);
    const OracleRun part = runBeside(start, predictable);
    return part.distance < kTolerance ? "" : "while predictable: " + part.describe();
}

} // namespace clothlab
