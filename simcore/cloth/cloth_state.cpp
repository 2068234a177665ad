#include "simcore/cloth/cloth_state.h"

#include <bit>
#include <cmath>

namespace clothlab {
namespace {

// SplitMix64, mapped to [0, 1).
class UniformGenerator {
public:
    explicit UniformGenerator(std::uint64_t seed) : m_state(seed) {}
    double next() {
        std::uint64_t z = (m_state += 0x9E3779B97F4A7C15U);
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1.0p-53;
    }

private:
    std::uint64_t m_state;
};

} // namespace

ClothState startState(const Scene& scene) {
    const Cloth& cloth = scene.cloth;
    const Grid grid = gridOf(cloth);
    const double dx = cloth.width / (grid.width - 1);
    const double dy = cloth.height / (grid.height - 1);
    UniformGenerator uniform(scene.simulation.seed);
    PointArray points(std::size_t(grid.pointCount()));
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            points.set(grid.index(x, y), cloth.orientation == Orientation::Horizontal
                                             ? Vec3(x * dx, 1, y * dy)
                                             : Vec3(x * dx, y * dy, -0.001 + 0.002 * uniform.next()));
    return {points, points};
}

double pointMass(const Cloth& cloth) {
    return cloth.width * cloth.height * cloth.density / cloth.pointCount();
}

double stiffness(const Cloth& cloth, SpringType type) {
    return type == SpringType::Bending ? 0.2 * cloth.ks : cloth.ks;
}

std::vector<std::uint8_t> pinnedMask(const Cloth& cloth) {
    const Grid grid = gridOf(cloth);
    std::vector<std::uint8_t> mask(std::size_t(grid.pointCount()), 0);
    for (const GridPoint& p : cloth.pinned)
        mask[std::size_t(grid.index(p))] = 1;
    return mask;
}

std::uint64_t stateHash(const ClothState& state) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    const auto add = [&hash](double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        for (unsigned shift = 0; shift < 64; shift += 8)
            hash = (hash ^ ((bits >> shift) & 0xFFU)) * 0x100000001B3U;
    };
    for (const PointArray* points : {&state.position, &state.lastPosition})
        for (std::size_t i = 0; i < points->size(); ++i) {
            add(points->x[i]);
            add(points->y[i]);
            add(points->z[i]);
        }
    return hash;
}

} // namespace clothlab
