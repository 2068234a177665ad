#include "simcore/solver/verlet_solver.h"

#include "simcore/collision/colliders.h"

#include <cassert>

namespace clothlab {

std::string_view name(Phase phase) {
    constexpr std::array<std::string_view, 5> names{"forces", "Verlet", "self-collision", "colliders",
                                                    "strain limit"};
    return names[std::size_t(phase)];
}

VerletSolver::VerletSolver(const Scene& scene) {
    const Grid grid = gridOf(scene.cloth);
    const auto n = std::size_t(grid.pointCount());
    m_scene = scene;
    m_sheet = makeSheet(grid, startState(scene).position);
    m_force = PointArray(n);
    m_correction = PointArray(n);
    m_row = PointArray(std::size_t(grid.width));
    setScene(scene);
}

void VerletSolver::setScene(const Scene& scene) {
    assert(compareScenes(m_scene, scene) != SceneChange::Start);
    m_scene = scene;
    m_pinned = pinnedMask(scene.cloth);
    m_pointMass = clothlab::pointMass(scene.cloth);
    // Ten times around the sheet in one step is far beyond anything that cloth does at a useful step size.
    m_runawayDistance = 10 * (scene.cloth.width + scene.cloth.height);
}

void VerletSolver::verlet(ClothState& state) {
    const double dt = m_scene.simulation.timeStep();
    const double keep = 1 - m_scene.cloth.damping / 100;
    const double gain = dt * dt / m_pointMass;
    const auto advance = [&](std::vector<double>& position, std::vector<double>& last,
                             const std::vector<double>& force) {
        for (std::size_t i = 0; i < position.size(); ++i) {
            const double current = position[i];
            const double next = current + keep * (current - last[i]) + gain * force[i];
            position[i] = m_pinned[i] ? current : next;
            last[i] = current;
        }
    };
    advance(state.position.x, state.lastPosition.x, m_force.x);
    advance(state.position.y, state.lastPosition.y, m_force.y);
    advance(state.position.z, state.lastPosition.z, m_force.z);
}

void VerletSolver::selfCollide(ClothState& state) {
    const double distance = 2 * m_scene.cloth.thickness;
    const double share = 1.0 / m_scene.simulation.stepsPerFrame;
    if (m_selfCollision.corrections(state.position, m_pinned, distance, share, m_correction) == 0)
        return;
    for (std::size_t i = 0; i < state.size(); ++i) {
        state.position.x[i] += m_correction.x[i];
        state.position.y[i] += m_correction.y[i];
        state.position.z[i] += m_correction.z[i];
    }
}

std::optional<int> VerletSolver::firstRunaway(const ClothState& state) const {
    const PointArray& p = state.position;
    const PointArray& last = state.lastPosition;
    const double limit = m_runawayDistance * m_runawayDistance;
    const auto within = [&](std::size_t i) {
        const double dx = p.x[i] - last.x[i];
        const double dy = p.y[i] - last.y[i];
        const double dz = p.z[i] - last.z[i];
        return dx * dx + dy * dy + dz * dz < limit; // false for NaN
    };
    int outside = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        outside += within(i) ? 0 : 1;
    for (std::size_t i = 0; i < p.size() && outside > 0; ++i)
        if (!within(i))
            return int(i);
    return std::nullopt;
}

StepResult VerletSolver::step(ClothState& state, const PhaseObserver* observer) {
    const auto watch = [&](Phase phase) {
        if (observer)
            (*observer)(phase, state);
    };
    forces(state.position, m_force);
    watch(Phase::Forces);
    verlet(state);
    watch(Phase::Verlet);
    // Before anything looks for neighbours: a NaN has no cell, and would spread.
    if (const auto point = firstRunaway(state))
        return {0, BlowUp{Phase::Verlet, *point}};

    if (m_scene.cloth.thickness > 0)
        selfCollide(state);
    watch(Phase::SelfCollision);
    for (const Sphere& sphere : m_scene.spheres)
        collide(sphere, m_pinned, state);
    for (const Plane& plane : m_scene.planes)
        collide(plane, m_pinned, state);
    watch(Phase::Colliders);
    const int corrections = limitStrain(state);
    watch(Phase::StrainLimit);
    if (const auto point = firstRunaway(state))
        return {corrections, BlowUp{Phase::StrainLimit, *point}};
    return {corrections, std::nullopt};
}

} // namespace clothlab
