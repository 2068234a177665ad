#include "simcore/inspect/frame_measure.h"

#include "simcore/inspect/inspect.h"

#include <algorithm>
#include <cmath>

namespace clothlab {
namespace {

// The greatest of length² / rest length² of the springs of a row that start at `a` and end at `b`.
double greatestRatio(const PointArray& position, std::size_t a, std::size_t b, int count,
                     const double* perRestSquared) {
    const double* const x = position.x.data();
    const double* const y = position.y.data();
    const double* const z = position.z.data();
    constexpr std::size_t lanes = 4; // that need not wait for each other
    std::array<double, lanes> greatest{};
    const auto n = std::size_t(count);
    for (std::size_t i = 0; i < n; ++i) {
        const double dx = x[b + i] - x[a + i];
        const double dy = y[b + i] - y[a + i];
        const double dz = z[b + i] - z[a + i];
        const double ratio = (dx * dx + dy * dy + dz * dz) * perRestSquared[i];
        double& lane = greatest[i % lanes];
        lane = ratio > lane ? ratio : lane;
    }
    return *std::max_element(greatest.begin(), greatest.end());
}

} // namespace

FrameMeasure::FrameMeasure(const Sheet& sheet)
    : m_grid(sheet.grid), m_touchingPoints(sheet.grid), m_touches(std::size_t(sheet.grid.pointCount())) {
    for (std::size_t s = 0; s < kStencils.size(); ++s) {
        const Stencil& stencil = kStencils[s];
        const StencilRange range = m_grid.range(stencil);
        for (int y = range.yBegin; y < range.yEnd; ++y)
            for (int x = range.xBegin; x < range.xEnd; ++x) {
                const int a = m_grid.index(x, y);
                const int b = m_grid.index(x + stencil.dx, y + stencil.dy);
                const double squared = (sheet.start.at(b) - sheet.start.at(a)).squaredNorm();
                m_perRestSquared[s].push_back(squared > 0 ? 1 / squared : 0);
            }
    }
}

double FrameMeasure::greatestStrain(const Cloth& cloth, const PointArray& position) const {
    double greatest = 0;
    bool any = false;
    for (std::size_t s = 0; s < kStencils.size(); ++s) {
        const Stencil& stencil = kStencils[s];
        const StencilRange range = m_grid.range(stencil);
        if (!cloth.enabled(stencil.type) || range.count() == 0)
            continue;
        any = true;
        const double* perRestSquared = m_perRestSquared[s].data();
        for (int y = range.yBegin; y < range.yEnd; ++y, perRestSquared += range.columns()) {
            const auto a = std::size_t(m_grid.index(range.xBegin, y));
            const auto b = std::size_t(m_grid.index(range.xBegin + stencil.dx, y + stencil.dy));
            greatest = std::max(greatest, greatestRatio(position, a, b, range.columns(), perRestSquared));
        }
    }
    return any ? std::sqrt(greatest) - 1 : 0;
}

void FrameMeasure::touchColliders(const Scene& scene, const PointArray& position) {
    const std::size_t n = m_touches.size();
    for (const Sphere& sphere : scene.spheres) {
        const double reach = sphere.radius + kContactDistance;
        for (std::size_t i = 0; i < n; ++i) {
            const double dx = position.x[i] - sphere.origin.x();
            const double dy = position.y[i] - sphere.origin.y();
            const double dz = position.z[i] - sphere.origin.z();
            m_touches[i] |= dx * dx + dy * dy + dz * dz <= reach * reach ? 1 : 0;
        }
    }
    for (const Plane& plane : scene.planes) {
        const Vec3 normal = plane.normal.normalized();
        const double height = normal.dot(plane.point);
        for (std::size_t i = 0; i < n; ++i) {
            const double above =
                normal.x() * position.x[i] + normal.y() * position.y[i] + normal.z() * position.z[i] - height;
            m_touches[i] |= std::abs(above) <= kContactDistance ? 1 : 0;
        }
    }
}

FrameFacts FrameMeasure::factsOf(const Frame& frame) {
    const Scene& scene = *frame.scene;
    const PointArray& position = frame.state.position;
    FrameFacts facts;
    facts.time = frame.time;
    facts.milliseconds = frame.milliseconds;
    facts.strainLimitCorrections = frame.strainLimitCorrections;
    facts.stateHash = stateHash(frame.state);
    facts.kineticEnergy = kineticEnergy(scene, frame.state);
    facts.greatestStrain = greatestStrain(scene.cloth, position);
    if (!std::isfinite(facts.kineticEnergy) || !allFinite(frame.state))
        return facts;
    std::fill(m_touches.begin(), m_touches.end(), std::uint8_t(0));
    touchColliders(scene, position);
    if (scene.cloth.thickness > 0)
        m_touchingPoints.find(position, 2 * scene.cloth.thickness, m_touches);
    facts.contacts = std::count(m_touches.begin(), m_touches.end(), 1);
    return facts;
}

FrameFacts factsOf(const Frame& frame, const Sheet& sheet) {
    return FrameMeasure(sheet).factsOf(frame);
}

} // namespace clothlab
