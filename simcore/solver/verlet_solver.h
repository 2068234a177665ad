// The course's cloth model: explicit Verlet steps in five phases (physics.md of Berkeley CS 184's cloth
// project; Provot 1995, "Deformation constraints in a mass-spring model to describe rigid cloth behavior").
#pragma once

#include "simcore/base/worker_team.h"
#include "simcore/cloth/cloth_state.h"
#include "simcore/collision/colliders.h"
#include "simcore/collision/self_collision.h"
#include "simcore/kernels/kernels.h"
#include "simcore/solver/rest_rows.h"
#include "simcore/solver/strain_pipeline.h"

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

namespace clothlab {

enum class Phase { Forces, Verlet, SelfCollision, Colliders, StrainLimit };
std::string_view name(Phase phase);

// A point that has no finite place any more, or moved farther in one step than cloth can.
struct BlowUp {
    Phase phase = Phase::Verlet; // after which that was so first
    int point = 0;               // the first of all to which it happened in that phase
};

struct StepResult {
    int strainLimitCorrections = 0;
    std::optional<BlowUp> blowUp; // the state is then as it was before the step
};

struct RunResult {
    int steps = 0; // that were done
    std::int64_t strainLimitCorrections = 0;
    std::optional<BlowUp> blowUp; // in the step after those; the state is then as it was before the run
};

// Called after each phase of a watched step.
using PhaseObserver = std::function<void(Phase, const ClothState&)>;

// How to compute, which has no influence on what is computed: all settings give the same bits.
struct SolverSettings {
    int threads = 0; // at most; 0: as many as the machine has cores
    // A band of the sheet with fewer points is not worth a thread.
    int leastPointsPerThread = 2500;
    InstructionSet instructionSet = bestInstructionSet();
};

// Holds parameters, rest data and buffers; the state is the caller's. To be used by one thread at a time; its
// own threads sleep except in run().
class VerletSolver {
public:
    // Precondition: validate(scene) has no errors.
    explicit VerletSolver(const Scene& scene, const SolverSettings& settings = {});

    // New parameters for a running sheet. Precondition: compareScenes(old, scene) != SceneChange::Start.
    void setScene(const Scene& scene);

    const Scene& scene() const { return m_scene; }
    const Sheet& sheet() const { return m_sheet; }
    const std::vector<std::uint8_t>& pinned() const { return m_pinned; }
    double pointMass() const { return m_pointMass; } // kg
    int threads() const { return int(m_members.size()); }
    ClothState start() const { return startState(m_scene); }
    std::size_t bytes() const; // held, without the state; after a run, as lists of neighbours grow

    // Steps of scene().simulation.timeStep(). Stops between two once stop is true. Allocates nothing from the
    // second run on, unless the sheet crowds more than ever before.
    RunResult run(ClothState& state, int steps, const std::atomic<bool>& stop);

    // One step. An observer, where given, sees the state after each phase. Slower than run(), which copies
    // the state once for all its steps.
    StepResult step(ClothState& state, const PhaseObserver* observer = nullptr);

    // Total force on each point in newtons, springs and gravity, as phase 1 computes it, spring after spring.
    void forces(const PointArray& position, PointArray& force) const;

private:
    // What one thread works with; apart, so that no two write to the same cache line.
    struct alignas(64) Member {
        Member(RowRange rowRange, const RowLayout& layout)
            : rows(rowRange), forces(layout), glance(rowRange) {}
        RowRange rows;
        ForceRows forces;
        StrainPipeline::Glance glance;
        alignas(64) int runaway = -1; // slot, after Verlet; apart from what others read all the time
        int runawayAtEnd = -1;        // after the strain limit
        std::int64_t strainLimitCorrections = 0;
        alignas(64) std::atomic<std::int64_t> rowsLimited{0}; // of the strain limit's passes, over all steps
    };
    static constexpr int kRowsAtATime = 16; // while they are in the cache
    // Verlet of a row reads so many rows after it; it looks at the springs of the next one, too.
    static constexpr int kReach = 3;
    void makeMembers(int count);
    void setPinnedSlots();
    void begin(const ClothState& state);
    void store(ClothState& state) const;

    int owner(int passRow) const; // who does that row of the strain limit
    void moveRows(int number, RowRange rows, const StepData& data);
    void collideWithItself(int number, const StepData& data);
    bool anyRunaway() const;      // after Verlet
    bool anyRunawayAtEnd() const; // after the strain limit
    bool collidesWithItself() const { return m_scene.cloth.thickness > 0; }

    // A member's share of the run at hand: verlet_wave.cpp.
    void workInWave(int number);
    bool stepInWave(int number, int step, StepData& data);
    bool moveInWave(int number, int step, StepData& data);
    bool limitInWave(int number, int step, RowRange rows, const StepData& data);
    bool waitInWave(int number, int step, std::int64_t rowsLimited) const;
    void endWaveBefore(int step);
    void endWave();

    // And verlet_rounds.cpp.
    void workInRounds(int number);
    void finishStep(int number, int step, bool isLast, StepData& data);
    void limitRows(int number, int step, RowRange passRows, const StepData& data);
    void finishRows(int number, RowRange rows, bool isLast, const StepData& data);
    void waitInRound(int step, int passRow) const;

    StepResult watchedStep(ClothState& state, const PhaseObserver& observer);
    BlowUp findBlowUp(ClothState state, int steps);
    std::optional<BlowUp> firstWithoutForce(const PointArray& position) const;

    Scene m_scene;
    Sheet m_sheet;
    std::vector<std::uint8_t> m_pinned;
    double m_pointMass = 0;

    const Kernels* m_kernels;
    RowArrays m_arrays;
    RestRows m_restRows;
    std::vector<std::uint8_t> m_pinnedSlots;
    StepData m_data;
    SelfCollision m_selfCollision;
    Colliders m_colliders;
    std::deque<Member> m_members; // cannot be moved
    StrainPipeline m_strainPipeline;

    // Of the run at hand.
    int m_steps = 0;
    std::atomic<int> m_waveEnd = 0; // the steps before it are done by all
    int m_stepsDone = 0;
    const std::atomic<bool>* m_stop = nullptr;
    std::unique_ptr<Barrier> m_barrier;
    std::function<void(int)> m_job;
    std::unique_ptr<WorkerTeam> m_team; // last: its threads use all of the above
};

} // namespace clothlab
