#pragma once

#include "simcore/scene/scene.h"

#include <vector>

namespace clothlab {

// Where pins of a grid go when its numbers of points change: to the same place relative to the sheet, so that
// corners stay corners. Each place once, in the order of the first pin that goes there. Both grids have 2
// points or more either way.
std::vector<GridPoint> movedPins(const Cloth& from, int numWidthPoints, int numHeightPoints);

} // namespace clothlab
