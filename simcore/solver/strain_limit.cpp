// Phase 5: no spring longer than 1.1 times its rest length, spring after spring.
#include "simcore/solver/verlet_solver.h"

#include <cmath>

namespace clothlab {

int VerletSolver::limitStrain(ClothState& state) {
    PointArray& position = state.position;
    int corrections = 0;
    for (std::size_t s = 0; s < kStencils.size(); ++s) {
        const Stencil& stencil = kStencils[s];
        if (!m_scene.cloth.enabled(stencil.type))
            continue;
        const StencilRange range = m_sheet.grid.range(stencil);
        const int offset = m_sheet.grid.index(stencil.dx, stencil.dy);
        for (int y = range.yBegin; y < range.yEnd; ++y)
            for (int x = range.xBegin; x < range.xEnd; ++x) {
                const int a = m_sheet.grid.index(x, y);
                const int b = a + offset;
                const double limit = (1 + kMaxStrain) * m_sheet.restLength[s][std::size_t(a)];
                const Vec3 pa = position.at(a);
                const Vec3 pb = position.at(b);
                const Vec3 along = pb - pa;
                const double lengthSquared = along.squaredNorm();
                const bool aPinned = m_pinned[std::size_t(a)] != 0;
                const bool bPinned = m_pinned[std::size_t(b)] != 0;
                if (lengthSquared <= limit * limit || (aPinned && bPinned))
                    continue;
                const double length = std::sqrt(lengthSquared);
                const Vec3 excess = along * ((length - limit) / length);
                const double shareOfA = aPinned ? 0 : bPinned ? 1 : 0.5;
                position.set(a, pa + shareOfA * excess);
                position.set(b, pb - (1 - shareOfA) * excess);
                ++corrections;
            }
    }
    return corrections;
}

} // namespace clothlab
