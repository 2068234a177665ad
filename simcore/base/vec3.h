#pragma once

#include <Eigen/Core>

namespace clothlab {

using Vec3 = Eigen::Vector3d; // metres unless said otherwise

} // namespace clothlab
