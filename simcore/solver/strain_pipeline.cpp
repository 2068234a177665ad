#include "simcore/solver/strain_pipeline.h"

#include <algorithm>
#include <array>

namespace clothlab {

// A spring of a stencil that starts in row y moves points of the rows y and y + dy, dy <= 0. Before it, all
// springs of earlier stencils that end in these rows have to have had their turn: those that start as far
// below as they reach up.
void StrainPipeline::configure(const StepData& data) {
    m_stages.clear();
    int behind = 0;
    int reach = 0;
    for (int s = 0; s < int(kStencils.size()); ++s) {
        if (!data.enabled[std::size_t(s)])
            continue;
        behind += reach;
        reach = -kStencils[std::size_t(s)].dy;
        m_stages.push_back({s, behind});
    }
    m_rowsBehind = behind + 2; // no stencil reaches farther up
    m_rows = data.layout.height + m_rowsBehind;
}

int StrainPipeline::limitAt(int row, const StepData& data, const Kernels& kernels) const {
    std::array<StencilRow, kStencils.size()> rows{};
    int count = 0;
    for (const Stage& stage : m_stages)
        if (const int y = row - stage.rowsBehind; y >= 0 && y < data.layout.height)
            rows[std::size_t(count++)] = {stage.stencil, y};
    return kernels.limitRows(data, rows.data(), count);
}

int StrainPipeline::limitAt(int row, const StepData& data, const Kernels& kernels, Glance& glance) const {
    int corrections = 0;
    for (const Stage& stage : m_stages) {
        const int y = row - stage.rowsBehind;
        if (y < 0 || y >= data.layout.height || glance.isCalm(stage.stencil, y))
            continue;
        const StencilRow springs{stage.stencil, y};
        if (const int shortened = kernels.limitRows(data, &springs, 1); shortened > 0) {
            corrections += shortened;
            glance.setMoved(y);
            glance.setMoved(y + kStencils[std::size_t(stage.stencil)].dy);
        }
    }
    return corrections;
}

void StrainPipeline::look(const StepData& data, const Kernels& kernels, Glance& glance) const {
    const RowRange rows = glance.m_rows;
    for (int y = rows.begin; y < rows.end; ++y) {
        unsigned tooLong = 0;
        for (const Stage& stage : m_stages)
            if (y + kStencils[std::size_t(stage.stencil)].dy >= rows.begin &&
                kernels.anyTooLong(data, {stage.stencil, y}))
                tooLong |= 1U << unsigned(stage.stencil);
        glance.m_tooLong[std::size_t(y - rows.begin)] = std::uint8_t(tooLong);
    }
    std::ranges::fill(glance.m_moved, std::uint8_t(0));
}

StrainPipeline::Glance::Glance(RowRange rows)
    : m_rows(rows), m_tooLong(std::size_t(rows.end - rows.begin)), m_moved(m_tooLong.size()) {}

// Of rows above those, nothing is known. None below is ever asked for.
bool StrainPipeline::Glance::isCalm(int stencil, int y) const {
    const int end = y + kStencils[std::size_t(stencil)].dy;
    if (end < m_rows.begin)
        return false;
    return (m_tooLong[std::size_t(y - m_rows.begin)] >> unsigned(stencil) & 1U) == 0 &&
           m_moved[std::size_t(y - m_rows.begin)] == 0 && m_moved[std::size_t(end - m_rows.begin)] == 0;
}

void StrainPipeline::Glance::setMoved(int y) {
    if (y >= m_rows.begin)
        m_moved[std::size_t(y - m_rows.begin)] = 1;
}

} // namespace clothlab
