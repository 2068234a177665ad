// The part of VerletSolver that steps a sheet which does not collide with itself.
//
// Each member keeps to its band of rows and goes on to the next step as soon as it can, so that steps run
// through the sheet like waves, one behind the other: the strain limit goes from row to row, so a member
// begins with it when the member before has done its rows, and Verlet of the next step needs nothing but rows
// nearby in their final places. A band is half a step behind the one before if there are two, and no one
// waits.
#include "simcore/solver/verlet_solver.h"

#include <algorithm>
#include <utility>

namespace clothlab {

// All steps before this one are still to be done, so that the first of all to find something decides.
void VerletSolver::endWaveBefore(int step) {
    int end = m_waveEnd.load(std::memory_order_relaxed);
    while (step < end && !m_waveEnd.compare_exchange_weak(end, step, std::memory_order_acq_rel)) {
    }
}

// For the member to have done so many rows, counted over all steps. False: this step is not to be done any
// more.
bool VerletSolver::waitInWave(int number, int step, std::int64_t rowsLimited) const {
    const auto isToEnd = [&] { return step >= m_waveEnd.load(std::memory_order_acquire); };
    waitUntil(m_members[std::size_t(number)].rowsLimited,
              [&](std::int64_t done) { return done >= rowsLimited || isToEnd(); });
    return !isToEnd();
}

// Verlet and colliders. The rows that it reads have to be where the step before put them for good. Then no
// member reads any more what it overwrites, either: places of two steps ago.
bool VerletSolver::moveInWave(int number, int step, StepData& data) {
    Member& member = m_members[std::size_t(number)];
    StepData next = data;
    std::swap(next.position, next.last);
    const int height = data.layout.height;
    for (int y = member.rows.begin; y < member.rows.end; y += kRowsAtATime) {
        const RowRange rows{y, std::min(y + kRowsAtATime, member.rows.end)};
        const int last = std::min(rows.end - 1 + kReach, height - 1) + m_strainPipeline.rowsBehind();
        const std::int64_t passed = std::int64_t(step - 1) * m_strainPipeline.rows();
        if (step > 0 && owner(last) != number && !waitInWave(owner(last), step, passed + last + 1))
            return false;
        moveRows(number, rows, data);
        if (member.runaway >= 0) {
            endWaveBefore(step);
            return false;
        }
        m_colliders.collide(*m_kernels, next, rows);
        if (number == 0 && !limitInWave(number, step, rows, next))
            return false;
    }
    data = next;
    return true;
}

// The strain limit for rows of its pass; the last member also does those that are more than the sheet has.
bool VerletSolver::limitInWave(int number, int step, RowRange rows, const StepData& data) {
    Member& member = m_members[std::size_t(number)];
    const int end = rows.end == data.layout.height ? m_strainPipeline.rows() : rows.end;
    const int behind = m_strainPipeline.rowsBehind();
    const std::int64_t passed = std::int64_t(step) * m_strainPipeline.rows();
    for (int row = rows.begin; row < end; ++row) {
        member.strainLimitCorrections += m_strainPipeline.limitAt(row, data, *m_kernels);
        if (row >= behind)
            member.runawayAtEnd = m_kernels->firstRunaway(data, {row - behind, row - behind + 1});
        if (member.runawayAtEnd >= 0) {
            endWaveBefore(step);
            return false;
        }
        // Not after each row: whoever waits for this takes the cache line away.
        if ((row + 1) % kRowsAtATime == 0 || row + 1 == end)
            member.rowsLimited.store(passed + row + 1, std::memory_order_release);
    }
    return true;
}

bool VerletSolver::stepInWave(int number, int step, StepData& data) {
    Member& member = m_members[std::size_t(number)];
    if (!moveInWave(number, step, data))
        return false;
    if (number > 0) {
        const std::int64_t passed = std::int64_t(step) * m_strainPipeline.rows();
        if (!waitInWave(number - 1, step, passed + member.rows.begin) ||
            !limitInWave(number, step, member.rows, data))
            return false;
    }
    return true;
}

void VerletSolver::workInWave(int number) {
    StepData data = m_data;
    for (int step = 0; step < m_waveEnd.load(std::memory_order_acquire); ++step) {
        // The others are at this step or behind: it is the last that all of them can still end with.
        if (number == 0 && m_stop->load(std::memory_order_relaxed))
            endWaveBefore(step + 1);
        if (!stepInWave(number, step, data))
            break;
    }
}

// What all threads read is for one to change, when they are done.
void VerletSolver::endWave() {
    m_stepsDone = m_waveEnd.load(std::memory_order_relaxed);
    if (m_stepsDone % 2 == 1)
        std::swap(m_data.position, m_data.last);
}

} // namespace clothlab
