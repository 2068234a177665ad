#include "simcore/cloth/cloth_state.h"

#include "simcore/base/checksum.h"

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
    Checksum hash;
    for (const PointArray* points : {&state.position, &state.lastPosition})
        for (const std::vector<double>* coordinates : {&points->x, &points->y, &points->z})
            hash.add(*coordinates);
    return hash.value();
}

} // namespace clothlab
