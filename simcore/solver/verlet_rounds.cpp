// The part of VerletSolver that steps a sheet which collides with itself.
//
// Any point may touch any other, so all members meet in each step, between Verlet and the strain limit. From
// one meeting to the next each has its band of rows: it shortens what is too long, when the members before it
// have, and moves its rows on as soon as those that their springs reach are in their final places. While a
// member waits for its turn it looks which of its springs are too long; if they are few, its turn is short.
#include "simcore/solver/verlet_solver.h"

#include <algorithm>
#include <utility>

namespace clothlab {

void VerletSolver::waitInRound(int step, int passRow) const {
    const std::int64_t limited = std::int64_t(step) * m_strainPipeline.rows() + passRow + 1;
    waitUntil(m_members[std::size_t(owner(passRow))].rowsLimited,
              [&](std::int64_t done) { return done >= limited; });
}

void VerletSolver::limitRows(int number, int step, RowRange passRows, const StepData& data) {
    Member& member = m_members[std::size_t(number)];
    for (int row = passRows.begin; row < passRows.end; ++row)
        member.strainLimitCorrections += number == 0
                                             ? m_strainPipeline.limitAt(row, data, *m_kernels)
                                             : m_strainPipeline.limitAt(row, data, *m_kernels, member.glance);
    member.rowsLimited.store(std::int64_t(step) * m_strainPipeline.rows() + passRows.end,
                             std::memory_order_release);
}

// What is left to do with rows that are in their final places.
void VerletSolver::finishRows(int number, RowRange rows, bool isLast, const StepData& data) {
    Member& member = m_members[std::size_t(number)];
    if (member.runawayAtEnd < 0)
        member.runawayAtEnd = m_kernels->firstRunaway(data, rows);
    if (!isLast)
        moveRows(number, rows, data);
}

// All that is between two meetings.
void VerletSolver::finishStep(int number, int step, bool isLast, StepData& data) {
    Member& member = m_members[std::size_t(number)];
    const RowRange mine = member.rows;
    const int height = data.layout.height;
    const int behind = m_strainPipeline.rowsBehind();
    if (number > 0) {
        m_colliders.collide(*m_kernels, data, mine);
        m_strainPipeline.look(data, *m_kernels, member.glance);
        waitInRound(step, mine.begin - 1);
    }
    int finished = mine.begin;
    const auto finishUpTo = [&](int end) {
        if (end > finished)
            finishRows(number, {std::exchange(finished, end), end}, isLast, data);
    };
    const bool isAwaited = number + 1 < threads();
    const int passEnd = isAwaited ? mine.end : m_strainPipeline.rows();
    for (int row = mine.begin; row < passEnd; row += kRowsAtATime) {
        const RowRange rows{row, std::min(row + kRowsAtATime, passEnd)};
        if (number == 0)
            m_colliders.collide(*m_kernels, data, {rows.begin, std::min(rows.end, height)});
        limitRows(number, step, rows, data);
        if (!isAwaited)
            finishUpTo(rows.end == passEnd ? height : rows.end - behind - kReach);
    }
    while (finished < mine.end) {
        const int end = std::min(finished + kRowsAtATime, mine.end);
        waitInRound(step, std::min(end - 1 + kReach, height - 1) + behind);
        finishUpTo(end);
    }
    if (!isLast)
        std::swap(data.position, data.last);
}

void VerletSolver::workInRounds(int number) {
    StepData data = m_data;
    moveRows(number, m_members[std::size_t(number)].rows, data);
    std::swap(data.position, data.last);
    int done = 0;
    for (bool isLast = false;; ++done) {
        m_barrier->wait();
        if (anyRunawayAtEnd()) {
            --done;
            break;
        }
        // Before anything looks for neighbours: what is not a number has no cell, and would spread.
        if (isLast || anyRunaway())
            break;
        if (number == 0 && m_stop->load(std::memory_order_relaxed))
            m_steps = done + 1;
        collideWithItself(number, data);
        isLast = done + 1 == m_steps;
        finishStep(number, done, isLast, data);
    }
    if (number == 0) {
        m_stepsDone = done;
        m_data = data;
    }
}

} // namespace clothlab
