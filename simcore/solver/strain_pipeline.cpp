#include "simcore/solver/strain_pipeline.h"

#include "simcore/base/worker_team.h"

#include <algorithm>
#include <cstdlib>

namespace clothlab {

// A spring of a stencil that starts in row y moves points of the rows y and y + dy, dy <= 0. Before it, all
// springs of earlier stencils that end in these rows have to have had their turn: those that start as far
// below as they reach up.
void StrainPipeline::configure(int members, const StepData& data) {
    std::vector<Stage>& stages = m_stages;
    stages.clear();
    int behind = 0;
    int reach = 0;
    for (int s = 0; s < int(kStencils.size()); ++s) {
        if (!data.enabled[std::size_t(s)])
            continue;
        behind += reach;
        reach = -kStencils[std::size_t(s)].dy;
        stages.push_back({s, behind});
    }
    m_lastBehind = behind + 2; // no stencil reaches farther up
    m_rows = data.layout.height + m_lastBehind;
    m_count = members;
    m_members = std::make_unique<Member[]>(std::size_t(members));
    for (int m = 0; m < members; ++m)
        m_members[std::size_t(m)].stages.assign(stages.begin() + std::ptrdiff_t(stages.size()) * m / members,
                                                stages.begin() +
                                                    std::ptrdiff_t(stages.size()) * (m + 1) / members);
}

void StrainPipeline::restart() {
    for (int m = 0; m < m_count; ++m)
        m_members[std::size_t(m)].rowsDone.store(0, std::memory_order_relaxed);
}

void StrainPipeline::advance(int member, int pass, const StepData& data, const Kernels& kernels,
                             Result& result) {
    Member& mine = m_members[std::size_t(member)];
    const std::atomic<std::int64_t>* before =
        member > 0 ? &m_members[std::size_t(member - 1)].rowsDone : nullptr;
    const bool last = member == m_count - 1;
    const std::int64_t passed = std::int64_t(pass) * m_rows;
    const auto end = passed + m_rows;
    std::int64_t seen = 0;
    for (std::int64_t done = mine.rowsDone.load(std::memory_order_relaxed); done < end; ++done) {
        if (before != nullptr && seen <= done)
            waitUntil(*before, [&](std::int64_t value) { return (seen = value) > done; });
        const int row = int(done - passed);
        limit(mine.stages, row, data, kernels, result);
        mine.rowsDone.store(done + 1, std::memory_order_release);
        if (last)
            findRunaway(row, data, kernels, result);
    }
}

void StrainPipeline::limitAt(int row, const StepData& data, const Kernels& kernels, Result& result) const {
    limit(m_stages, row, data, kernels, result);
    findRunaway(row, data, kernels, result);
}

void StrainPipeline::limit(const std::vector<Stage>& stages, int row, const StepData& data,
                           const Kernels& kernels, Result& result) const {
    std::array<StencilRow, kStencils.size()> rows{};
    int count = 0;
    for (const Stage& stage : stages)
        if (const int y = row - stage.rowsBehind; y >= 0 && y < data.layout.height)
            rows[std::size_t(count++)] = {stage.stencil, y};
    result.corrections += kernels.limitRows(data, rows.data(), count);
}

void StrainPipeline::findRunaway(int row, const StepData& data, const Kernels& kernels,
                                 Result& result) const {
    const int y = row - m_lastBehind;
    if (y >= 0 && y < data.layout.height && result.runaway < 0)
        result.runaway = kernels.firstRunaway(data, {y, y + 1});
}

} // namespace clothlab
