#include "simcore/scene/pins.h"

#include <cmath>
#include <set>

namespace clothlab {
namespace {

int moved(int index, int from, int to) {
    return static_cast<int>(std::lround(static_cast<double>(index) * (to - 1) / (from - 1)));
}

} // namespace

std::vector<GridPoint> movedPins(const Cloth& from, int numWidthPoints, int numHeightPoints) {
    std::set<GridPoint> taken;
    std::vector<GridPoint> pins;
    for (const GridPoint& pin : from.pinned) {
        const GridPoint to{moved(pin.x, from.numWidthPoints, numWidthPoints),
                           moved(pin.y, from.numHeightPoints, numHeightPoints)};
        if (taken.insert(to).second)
            pins.push_back(to);
    }
    return pins;
}

} // namespace clothlab
