// The sheet as the mesh that every file holds: points in index order, two triangles a grid cell.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <array>

namespace clothlab {

// Area-weighted normal of the cells around a point; +y where the sheet has shrunk to nothing.
Vec3 pointNormal(const Grid& grid, const PointArray& position, GridPoint p);

// Across and along the sheet, from 0 at point (0, 0) to 1.
std::array<double, 2> textureCoordinate(const Grid& grid, GridPoint p);

inline int triangleCount(const Grid& grid) {
    return 2 * (grid.width - 1) * (grid.height - 1);
}

// Calls with the indices of the three corners of each triangle. Counter-clockwise seen from where normals
// point to.
template <typename Call>
void forEachTriangle(const Grid& grid, Call call) {
    for (int y = 0; y + 1 < grid.height; ++y)
        for (int x = 0; x + 1 < grid.width; ++x) {
            call(grid.index(x, y), grid.index(x, y + 1), grid.index(x + 1, y));
            call(grid.index(x + 1, y), grid.index(x, y + 1), grid.index(x + 1, y + 1));
        }
}

} // namespace clothlab
