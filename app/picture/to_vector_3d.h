// Places and colours of simcore, which knows no Qt, as Qt's vectors.
#pragma once

#include "simcore/base/vec3.h"

#include <QVector3D>

#include <array>

namespace clothlab {

inline QVector3D toVector3D(const Vec3& v) {
    return {float(v.x()), float(v.y()), float(v.z())};
}

inline QVector3D toVector3D(const std::array<double, 3>& v) {
    return {float(v[0]), float(v[1]), float(v[2])};
}

} // namespace clothlab
