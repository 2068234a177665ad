#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace clothlab {

using Vec3 = Eigen::Vector3d; // metres unless said otherwise

} // namespace clothlab
