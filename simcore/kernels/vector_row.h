// The places of as many points as there are lanes.
#pragma once

#include "simcore/kernels/kernels.h"
#include "simcore/kernels/lanes.h"

namespace clothlab {
namespace { // a copy for each file, see lanes.h

template <typename L>
struct VectorRow {
    using V = typename L::Vector;
    V x, y, z;

    static VectorRow load(const ConstPointRows& rows, int slot) {
        return {L::load(rows.x + slot), L::load(rows.y + slot), L::load(rows.z + slot)};
    }
    void store(const PointRows& rows, int slot) const {
        L::store(rows.x + slot, x);
        L::store(rows.y + slot, y);
        L::store(rows.z + slot, z);
    }
    VectorRow operator-(const VectorRow& b) const { return {x - b.x, y - b.y, z - b.z}; }
    VectorRow operator+(const VectorRow& b) const { return {x + b.x, y + b.y, z + b.z}; }
    VectorRow operator*(V scale) const { return {x * scale, y * scale, z * scale}; }
    // The order of the sum is part of the result.
    V lengthSquared() const { return (x * x + y * y) + z * z; }
    static VectorRow choose(typename L::Mask mask, const VectorRow& yes, const VectorRow& no) {
        return {L::choose(mask, yes.x, no.x), L::choose(mask, yes.y, no.y), L::choose(mask, yes.z, no.z)};
    }
};

// Of the lanes of a mask, as bits. Precondition: there is one.
inline int firstLane(unsigned bits) {
    return __builtin_ctz(bits);
}

} // namespace
} // namespace clothlab
