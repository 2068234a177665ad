// States of a sheet for tests to start from, and how far apart two of them are.
#pragma once

#include "simcore/cloth/cloth_state.h"
#include "tests/support/oracle.h"

#include <functional>
#include <string>

namespace clothlab {

double greatestDistance(const PointArray& a, const PointArray& b); // m; infinite if any number is not finite
double greatestDistance(const PointArray& a, const std::vector<oracle::PointMass>& b);

// The same place, as if it had come there with the given velocity (of point index at position). Pinned
// points stay at rest.
using VelocityField = std::function<Vec3(int, const Vec3&)>;
void throwSheet(const Scene& scene, ClothState& state, const VelocityField& velocity);
void throwSheet(const Scene& scene, ClothState& state, const Vec3& velocity);

// At rest, with the half beyond the middle of the width laid back over the other half, `gap` beside it.
void foldSheet(const Scene& scene, ClothState& state, double gap);

void copyState(const ClothState& from, std::vector<oracle::PointMass>& to);
ClothState mapState(const ClothState& state, const std::function<Vec3(const Vec3&)>& map);

std::vector<oracle::PointMass> toPointMasses(const PointArray& positions,
                                             const std::vector<std::uint8_t>& pinned);

} // namespace clothlab
