// The course's cloth model: one explicit Verlet step in five phases (physics.md of Berkeley CS 184's cloth
// project; Provot 1995, "Deformation constraints in a mass-spring model to describe rigid cloth behavior").
#pragma once

#include "simcore/cloth/cloth_state.h"
#include "simcore/collision/self_collision.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

namespace clothlab {

enum class Phase { Forces, Verlet, SelfCollision, Colliders, StrainLimit };
std::string_view name(Phase phase);

// A point that has no finite place any more, or moved farther in one step than cloth can.
struct BlowUp {
    Phase phase = Phase::Verlet;
    int point = 0;
};

struct StepResult {
    int strainLimitCorrections = 0;
    std::optional<BlowUp> blowUp; // the state is then of no use
};

// Called after each phase of a watched step.
using PhaseObserver = std::function<void(Phase, const ClothState&)>;

inline constexpr double kMaxStrain = 0.1; // springs longer than 1.1 times their rest length are shortened

// Holds parameters, rest data and buffers; the state is the caller's.
class VerletSolver {
public:
    explicit VerletSolver(const Scene& scene); // precondition: validate(scene) has no errors

    // New parameters for a running sheet. Precondition: compareScenes(old, scene) != SceneChange::Start.
    void setScene(const Scene& scene);

    const Scene& scene() const { return m_scene; }
    const Sheet& sheet() const { return m_sheet; }
    const std::vector<std::uint8_t>& pinned() const { return m_pinned; }
    double pointMass() const { return m_pointMass; } // kg
    ClothState start() const { return startState(m_scene); }

    // One step of scene().simulation.timeStep(). An observer, where given, sees the state after each phase.
    StepResult step(ClothState& state, const PhaseObserver* observer = nullptr);

    // Total force on each point in newtons, springs and gravity, as phase 1 computes it.
    void forces(const PointArray& position, PointArray& force);

private:
    void verlet(ClothState& state);
    void selfCollide(ClothState& state);
    int limitStrain(ClothState& state);
    std::optional<int> firstRunaway(const ClothState& state) const;

    Scene m_scene;
    Sheet m_sheet;
    std::vector<std::uint8_t> m_pinned;
    double m_pointMass = 0;
    double m_runawayDistance = 0; // m a step

    PointArray m_force;
    PointArray m_correction;
    PointArray m_row; // spring forces of one row
    SelfCollision m_selfCollision;
};

} // namespace clothlab
