#include "simcore/inspect/inspect.h"

#include <algorithm>
#include <cmath>

namespace clothlab {

Vec3 velocity(const ClothState& state, int point, double timeStep) {
    return (state.position.at(point) - state.lastPosition.at(point)) / timeStep;
}

SpringMeasure measureSpring(const Cloth& cloth, const Sheet& sheet, const PointArray& position,
                            const Spring& spring) {
    SpringMeasure m;
    m.length = (position.at(spring.b) - position.at(spring.a)).norm();
    m.restLength = sheet.restLengthOf(spring);
    m.strain = m.restLength > 0 ? (m.length - m.restLength) / m.restLength : 0;
    m.force = cloth.enabled(spring.type()) ? stiffness(cloth, spring.type()) * (m.length - m.restLength) : 0;
    return m;
}

namespace {

template <typename Visit>
void forEachSpring(const Grid& grid, Visit visit) {
    for (int s = 0; s < int(kStencils.size()); ++s) {
        const Stencil& stencil = kStencils[std::size_t(s)];
        const StencilRange range = grid.range(stencil);
        for (int y = range.yBegin; y < range.yEnd; ++y)
            for (int x = range.xBegin; x < range.xEnd; ++x)
                visit(Spring{s, grid.index(x, y), grid.index(x + stencil.dx, y + stencil.dy)});
    }
}

} // namespace

std::array<double, kSpringTypes> maxStrain(const Sheet& sheet, const PointArray& position) {
    const Cloth cloth; // strain depends on no parameter of it
    std::array<double, kSpringTypes> greatest{};
    std::array<bool, kSpringTypes> any{};
    forEachSpring(sheet.grid, [&](const Spring& spring) {
        const double strain = measureSpring(cloth, sheet, position, spring).strain;
        const auto type = std::size_t(spring.type());
        greatest[type] = any[type] ? std::max(greatest[type], strain) : strain;
        any[type] = true;
    });
    return greatest;
}

double pointStrains(const Cloth& cloth, const Sheet& sheet, const PointArray& position,
                    std::vector<float>& strains) {
    strains.assign(position.size(), 0);
    double greatest = 0;
    forEachSpring(sheet.grid, [&](const Spring& spring) {
        if (!cloth.enabled(spring.type()))
            return;
        const double strain = measureSpring(cloth, sheet, position, spring).strain;
        greatest = std::max(greatest, std::abs(strain));
        for (const int point : {spring.a, spring.b}) {
            float& most = strains[std::size_t(point)];
            if (std::abs(strain) > std::abs(double(most)))
                most = float(strain);
        }
    });
    return greatest;
}

double kineticEnergy(const Scene& scene, const ClothState& state) {
    double sum = 0;
    for (int i = 0; i < int(state.size()); ++i)
        sum += velocity(state, i, scene.simulation.timeStep()).squaredNorm();
    return 0.5 * pointMass(scene.cloth) * sum;
}

double potentialEnergy(const Scene& scene, const Sheet& sheet, const PointArray& position) {
    double energy = 0;
    for (int i = 0; i < int(position.size()); ++i)
        energy -= pointMass(scene.cloth) * scene.simulation.gravity.dot(position.at(i));
    forEachSpring(sheet.grid, [&](const Spring& spring) {
        if (!scene.cloth.enabled(spring.type()))
            return;
        const SpringMeasure m = measureSpring(scene.cloth, sheet, position, spring);
        energy += 0.5 * stiffness(scene.cloth, spring.type()) * (m.length - m.restLength) *
                  (m.length - m.restLength);
    });
    return energy;
}

bool allFinite(const ClothState& state) {
    const auto finite = [](const std::vector<double>& values) {
        return std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
    };
    return finite(state.position.x) && finite(state.position.y) && finite(state.position.z) &&
           finite(state.lastPosition.x) && finite(state.lastPosition.y) && finite(state.lastPosition.z);
}

} // namespace clothlab
