#include "simcore/export/sheet_mesh.h"

#include <algorithm>

namespace clothlab {

Vec3 pointNormal(const Grid& grid, const PointArray& position, GridPoint p) {
    const auto at = [&](int x, int y) {
        return position.at(grid.index(std::clamp(x, 0, grid.width - 1), std::clamp(y, 0, grid.height - 1)));
    };
    const Vec3 across = at(p.x + 1, p.y) - at(p.x - 1, p.y);
    const Vec3 down = at(p.x, p.y + 1) - at(p.x, p.y - 1);
    const Vec3 normal = down.cross(across);
    return normal.norm() > 0 ? normal.normalized() : Vec3::UnitY();
}

std::array<double, 2> textureCoordinate(const Grid& grid, GridPoint p) {
    return {double(p.x) / (grid.width - 1), double(p.y) / (grid.height - 1)};
}

} // namespace clothlab
