#include "simcore/solver/verlet_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <thread>
#include <utility>

namespace clothlab {
namespace {

int threadsFor(const RowLayout& layout, const SolverSettings& settings) {
    const int most = settings.threads > 0 ? settings.threads : int(std::thread::hardware_concurrency());
    const int worth = layout.width * layout.height / std::max(1, settings.leastPointsPerThread);
    return std::clamp(std::min(most, worth), 1, layout.height);
}

// The first point that has moved limit or more since its last position, or has no finite place.
std::optional<int> firstRunaway(const ClothState& state, double limit) {
    for (int i = 0; i < int(state.size()); ++i) {
        const Vec3 moved = state.position.at(i) - state.lastPosition.at(i);
        const double squared = moved.x() * moved.x() + moved.y() * moved.y() + moved.z() * moved.z();
        if (!(squared < limit * limit))
            return i;
    }
    return std::nullopt;
}

} // namespace

std::string_view name(Phase phase) {
    constexpr std::array<std::string_view, 5> names{"forces", "Verlet", "self-collision", "colliders",
                                                    "strain limit"};
    return names[std::size_t(phase)];
}

VerletSolver::VerletSolver(const Scene& scene, const SolverSettings& settings)
    : m_scene(scene), m_sheet{gridOf(scene.cloth), startState(scene).position},
      m_kernels(&kernelsFor(settings.instructionSet)), m_selfCollision(*m_kernels) {
    const RowLayout layout(m_sheet.grid);
    m_arrays = RowArrays(layout, 6);
    m_restRows = RestRows(m_sheet, layout);
    m_data.layout = layout;
    m_data.position = m_arrays.points(0);
    m_data.last = m_arrays.points(3);
    for (int s = 0; s < int(kStencils.size()); ++s)
        m_data.restLength[std::size_t(s)] = m_restRows.of(s);
    makeMembers(threadsFor(layout, settings));
    setScene(scene);
}

void VerletSolver::makeMembers(int count) {
    const int rows = m_data.layout.height;
    for (int m = 0; m < count; ++m)
        m_members.emplace_back(
            RowRange{int(std::int64_t(rows) * m / count), int(std::int64_t(rows) * (m + 1) / count)},
            m_data.layout);
    std::vector<RowRange> bands;
    for (const Member& member : m_members)
        bands.push_back(member.rows);
    m_selfCollision.setSheet(m_data.layout, bands);
    m_job = [this](int member) { collidesWithItself() ? workInRounds(member) : workInWave(member); };
    m_barrier = std::make_unique<Barrier>(count);
    m_team = std::make_unique<WorkerTeam>(count);
}

void VerletSolver::setScene(const Scene& scene) {
    assert(compareScenes(m_scene, scene) != SceneChange::Start);
    m_scene = scene;
    m_pinned = pinnedMask(scene.cloth);
    m_pointMass = clothlab::pointMass(scene.cloth);
    setPinnedSlots();
    for (std::size_t s = 0; s < kStencils.size(); ++s) {
        m_data.enabled[s] = scene.cloth.enabled(kStencils[s].type);
        m_data.stiffness[s] = stiffness(scene.cloth, kStencils[s].type);
    }
    const double dt = scene.simulation.timeStep();
    for (int axis = 0; axis < 3; ++axis)
        m_data.weight[std::size_t(axis)] = m_pointMass * scene.simulation.gravity[axis] + 0.0; // not -0
    m_data.keep = 1 - scene.cloth.damping / 100;
    m_data.gain = dt * dt / m_pointMass;
    // Ten times around the sheet in one step is far beyond anything that cloth does at a useful step size.
    m_data.runawayDistance = 10 * (scene.cloth.width + scene.cloth.height);
    m_colliders.set(scene);
    m_selfCollision.setDistance(2 * scene.cloth.thickness);
    m_strainPipeline.configure(m_data);
}

// What lies around the points counts as pinned: nothing moves it.
void VerletSolver::setPinnedSlots() {
    const RowLayout& layout = m_data.layout;
    const std::size_t before =
        std::size_t(RowLayout::kRowsBefore) * std::size_t(layout.stride) + RowLayout::kLanes;
    m_pinnedSlots.assign(before + std::size_t(layout.slotCount() + RowLayout::kRowsAfter * layout.stride) +
                             RowLayout::kLanes,
                         1);
    m_data.pinned = m_pinnedSlots.data() + before;
    for (int y = 0; y < layout.height; ++y)
        std::copy_n(m_pinned.begin() + std::ptrdiff_t(y) * layout.width, layout.width,
                    m_pinnedSlots.begin() + std::ptrdiff_t(before) + layout.slot(0, y));
    m_selfCollision.setPinned(m_data.pinned);
}

void VerletSolver::store(ClothState& state) const {
    copyFromRows(m_data.position, m_data.layout, state.position);
    copyFromRows(m_data.last, m_data.layout, state.lastPosition);
}

int VerletSolver::owner(int passRow) const {
    int number = 0;
    while (number + 1 < threads() && m_members[std::size_t(number)].rows.end <= passRow)
        ++number;
    return number;
}

// Phases 1 and 2 of the next step, for rows of a member's, one after another.
void VerletSolver::moveRows(int number, RowRange rows, const StepData& data) {
    Member& member = m_members[std::size_t(number)];
    const int runaway = m_kernels->verletRows(data, rows, member.forces, rows.begin > member.rows.begin);
    if (member.runaway < 0)
        member.runaway = runaway;
    if (collidesWithItself())
        m_selfCollision.measure(number, data.last, rows);
}

// All members have to have moved their rows. When one is done, the others look at its points no more.
void VerletSolver::collideWithItself(int number, const StepData& data) {
    SelfCollision& self = m_selfCollision;
    if (!self.listsHold(number)) {
        if (number == 0)
            self.sortIntoCells(data.position);
        m_barrier->wait();
        self.list(number, data.position);
        m_barrier->wait();
    }
    self.findPairs(number, data.position);
    self.foretell(number, data.position, data.last);
    m_barrier->wait();
    if (!self.anyPairs())
        return;
    self.addUp(number, data.position);
    m_barrier->wait();
    self.apply(number, data.position, 1.0 / m_scene.simulation.stepsPerFrame);
}

bool VerletSolver::anyRunaway() const {
    return std::ranges::any_of(m_members, [](const Member& member) { return member.runaway >= 0; });
}

bool VerletSolver::anyRunawayAtEnd() const {
    return std::ranges::any_of(m_members, [](const Member& member) { return member.runawayAtEnd >= 0; });
}

void VerletSolver::begin(const ClothState& state) {
    copyToRows(state.position, m_data.layout, m_data.position);
    copyToRows(state.lastPosition, m_data.layout, m_data.last);
    for (int number = 0; collidesWithItself() && number < threads(); ++number)
        m_selfCollision.foretell(number, m_data.position, m_data.last);
    for (Member& member : m_members) {
        member.runaway = member.runawayAtEnd = -1;
        member.strainLimitCorrections = 0;
        member.rowsLimited.store(0, std::memory_order_relaxed);
    }
}

RunResult VerletSolver::run(ClothState& state, int steps, const std::atomic<bool>& stop) {
    RunResult result;
    if (steps <= 0 || stop.load(std::memory_order_relaxed))
        return result;
    begin(state);
    m_steps = steps;
    m_waveEnd.store(steps, std::memory_order_relaxed);
    m_stop = &stop;
    m_team->run(m_job);
    if (!collidesWithItself())
        endWave();
    result.steps = m_stepsDone;
    for (const Member& member : m_members)
        result.strainLimitCorrections += member.strainLimitCorrections;
    if (anyRunaway() || anyRunawayAtEnd())
        result.blowUp = findBlowUp(state, m_stepsDone);
    else
        store(state);
    return result;
}

StepResult VerletSolver::step(ClothState& state, const PhaseObserver* observer) {
    if (observer)
        return watchedStep(state, *observer);
    const std::atomic<bool> stop = false;
    const RunResult result = run(state, 1, stop);
    return {int(result.strainLimitCorrections), result.blowUp};
}

// The steps before the one that blew up once more, and that one phase by phase.
BlowUp VerletSolver::findBlowUp(ClothState state, int steps) {
    const std::atomic<bool> stop = false;
    run(state, steps, stop);
    const StepResult result = watchedStep(state, [](Phase, const ClothState&) {});
    assert(result.blowUp);
    return result.blowUp.value_or(BlowUp{Phase::StrainLimit, 0});
}

StepResult VerletSolver::watchedStep(ClothState& state, const PhaseObserver& observer) {
    begin(state);
    ClothState now = state;
    std::optional<BlowUp> first;
    const auto watch = [&](Phase phase) {
        observer(phase, now);
        if (const auto point = firstRunaway(now, m_data.runawayDistance); point && !first)
            first = BlowUp{phase, *point};
    };
    const auto share = [&](Phase phase, const std::function<void(int)>& job) {
        m_team->run(job);
        store(now);
        watch(phase);
    };

    observer(Phase::Forces, now);
    first = firstWithoutForce(state.position);
    m_team->run([&](int m) { moveRows(m, m_members[std::size_t(m)].rows, m_data); });
    std::swap(m_data.position, m_data.last);
    store(now);
    watch(Phase::Verlet);
    if (anyRunaway())
        return {0, first};
    share(Phase::SelfCollision, [&](int m) {
        if (collidesWithItself())
            collideWithItself(m, m_data);
    });
    share(Phase::Colliders,
          [&](int m) { m_colliders.collide(*m_kernels, m_data, m_members[std::size_t(m)].rows); });
    StepResult result;
    for (int row = 0; row < m_strainPipeline.rows(); ++row)
        result.strainLimitCorrections += m_strainPipeline.limitAt(row, m_data, *m_kernels);
    store(now);
    watch(Phase::StrainLimit);

    if (m_kernels->firstRunaway(m_data, {0, m_data.layout.height}) >= 0)
        result.blowUp = first;
    else
        state = std::move(now);
    return result;
}

// The first point that the forces on it would throw out of all bounds.
std::optional<BlowUp> VerletSolver::firstWithoutForce(const PointArray& position) const {
    PointArray force(position.size());
    forces(position, force);
    for (int i = 0; i < int(force.size()); ++i)
        if (m_pinned[std::size_t(i)] == 0 && !force.at(i).allFinite())
            return BlowUp{Phase::Forces, i};
    return std::nullopt;
}

void VerletSolver::forces(const PointArray& position, PointArray& force) const {
    const Vec3 weight = m_pointMass * m_scene.simulation.gravity;
    for (int i = 0; i < int(position.size()); ++i)
        force.set(i, weight);
    const int springs = m_sheet.grid.springCount();
    for (int number = 0; number < springs; ++number) {
        const Spring spring = m_sheet.grid.spring(number);
        if (!m_scene.cloth.enabled(spring.type()))
            continue;
        const Vec3 along = position.at(spring.b) - position.at(spring.a);
        const double length =
            std::sqrt(along.x() * along.x() + along.y() * along.y() + along.z() * along.z());
        // A spring without length has no direction to pull in.
        if (!(length > 0) && !std::isnan(length))
            continue;
        const double pull =
            m_data.stiffness[std::size_t(spring.stencil)] * (length - m_sheet.restLengthOf(spring));
        const Vec3 f = pull / length * along;
        force.set(spring.a, force.at(spring.a) + f);
        force.set(spring.b, force.at(spring.b) - f);
    }
}

std::size_t VerletSolver::bytes() const {
    std::size_t sum = m_arrays.bytes() + m_restRows.bytes() + m_pinnedSlots.size() + m_pinned.size() +
                      m_selfCollision.bytes() + 3 * sizeof(double) * m_sheet.start.size();
    for (const Member& member : m_members)
        sum += sizeof member + sizeof(double) * member.forces.values.size();
    return sum;
}

} // namespace clothlab
