// The running state of a sheet as a structure of arrays, and the rest data that stay the same during a run.
#pragma once

#include "simcore/cloth/grid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace clothlab {

// n points, metres.
struct PointArray {
    std::vector<double> x, y, z;

    PointArray() = default;
    explicit PointArray(std::size_t n) : x(n), y(n), z(n) {}
    std::size_t size() const { return x.size(); }
    Vec3 at(int i) const { return {x[std::size_t(i)], y[std::size_t(i)], z[std::size_t(i)]}; }
    void set(int i, const Vec3& p) {
        x[std::size_t(i)] = p.x();
        y[std::size_t(i)] = p.y();
        z[std::size_t(i)] = p.z();
    }
    friend bool operator==(const PointArray&, const PointArray&) = default;
};

struct ClothState {
    PointArray position;
    PointArray lastPosition; // one step earlier
    std::size_t size() const { return position.size(); }
    friend bool operator==(const ClothState&, const ClothState&) = default;
};

// What is fixed when a run starts. Springs and their rest lengths are computed, not stored.
struct Sheet {
    Grid grid;
    PointArray start; // where the points were when their springs were at rest

    double restLengthOf(const Spring& s) const { return (start.at(s.b) - start.at(s.a)).norm(); } // m
};

// Where the sheet starts, at rest. The unevenness of a vertical sheet is, for point after point in
// row-major order, e = -0.001 + 0.002 * u with u the next output of SplitMix64 (Steele, Lea and Flood
// 2014, "Fast splittable pseudorandom number generators") seeded with simulation.seed, shifted right by 11
// and multiplied by 2^-53.
ClothState startState(const Scene& scene);

double pointMass(const Cloth& cloth);                  // kg
double stiffness(const Cloth& cloth, SpringType type); // N/m, also of a type that is switched off

// One entry a point: 1 if it is pinned.
std::vector<std::uint8_t> pinnedMask(const Cloth& cloth);

// XXH3 (simcore/base/checksum.h) over the bits of the x of all positions, then y, then z, and the same of the
// last positions. Equal for equal states on every platform.
std::uint64_t stateHash(const ClothState& state);

} // namespace clothlab
