// Phase 1: gravity and springs.
#include "simcore/solver/verlet_solver.h"

#include <cmath>
#include <utility>

namespace clothlab {
namespace {

struct RowPointers {
    double* x;
    double* y;
    double* z;
};

struct ConstRowPointers {
    const double* x;
    const double* y;
    const double* z;
};

ConstRowPointers rowOf(const PointArray& points, int index) {
    return {points.x.data() + index, points.y.data() + index, points.z.data() + index};
}

RowPointers rowOf(PointArray& points, int index) {
    return {points.x.data() + index, points.y.data() + index, points.z.data() + index};
}

// Forces on the ends a of a row of springs, into a buffer of their own so that the loop can be vectorised.
void springForces(int count, double stiffness, const double* rest, ConstRowPointers a, ConstRowPointers b,
                  RowPointers force) {
    for (int i = 0; i < count; ++i) {
        const double dx = b.x[i] - a.x[i];
        const double dy = b.y[i] - a.y[i];
        const double dz = b.z[i] - a.z[i];
        const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
        // A spring without length has no direction to pull in.
        const double scale = length > 0 ? stiffness * (length - rest[i]) / length : 0;
        force.x[i] = scale * dx;
        force.y[i] = scale * dy;
        force.z[i] = scale * dz;
    }
}

void addRow(int count, ConstRowPointers row, RowPointers to) {
    for (int i = 0; i < count; ++i)
        to.x[i] += row.x[i];
    for (int i = 0; i < count; ++i)
        to.y[i] += row.y[i];
    for (int i = 0; i < count; ++i)
        to.z[i] += row.z[i];
}

void subtractRow(int count, ConstRowPointers row, RowPointers from) {
    for (int i = 0; i < count; ++i)
        from.x[i] -= row.x[i];
    for (int i = 0; i < count; ++i)
        from.y[i] -= row.y[i];
    for (int i = 0; i < count; ++i)
        from.z[i] -= row.z[i];
}

} // namespace

void VerletSolver::forces(const PointArray& position, PointArray& force) {
    const Vec3 weight = m_pointMass * m_scene.simulation.gravity;
    force.x.assign(position.size(), weight.x());
    force.y.assign(position.size(), weight.y());
    force.z.assign(position.size(), weight.z());

    for (std::size_t s = 0; s < kStencils.size(); ++s) {
        const Stencil& stencil = kStencils[s];
        if (!m_scene.cloth.enabled(stencil.type))
            continue;
        const double stiffness = clothlab::stiffness(m_scene.cloth, stencil.type);
        const StencilRange range = m_sheet.grid.range(stencil);
        for (int y = range.yBegin; y < range.yEnd; ++y) {
            const int a = m_sheet.grid.index(range.xBegin, y);
            const int b = m_sheet.grid.index(range.xBegin + stencil.dx, y + stencil.dy);
            springForces(range.columns(), stiffness, m_sheet.restLength[s].data() + a, rowOf(position, a),
                         rowOf(position, b), rowOf(m_row, 0));
            addRow(range.columns(), rowOf(std::as_const(m_row), 0), rowOf(force, a));
            subtractRow(range.columns(), rowOf(std::as_const(m_row), 0), rowOf(force, b));
        }
    }
}

} // namespace clothlab
