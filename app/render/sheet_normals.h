// Normals and tangents of a grid of points, row after row, in loops that compilers turn into vector code.
#pragma once

#include <cstddef>
#include <vector>

namespace clothlab::render {

// n floats for each axis.
struct FloatRows {
    std::vector<float> x, y, z;

    void resize(std::size_t n) {
        for (std::vector<float>* axis : {&x, &y, &z})
            axis->resize(n);
    }
};

// Working memory of the function below, kept from frame to frame.
struct NormalScratch {
    struct Triangles {
        FloatRows normal;           // of unit length where the angles are not 0
        std::vector<float> a, b, c; // angles, radians; 0 where the triangle has no area
    };
    Triangles upper, lower; // of the cells of one row
};

// width * height points, row-major, at least one; what is computed replaces `normals` and `tangents`, of the
// same size.
//
// Each cell is two triangles that share the diagonal from (x + 1, y) to (x, y + 1). Normals are averages over
// the triangles of a point, weighted by the angle there (Thuermer and Wuethrich 1998), of unit length, on the
// side of dp/dv x dp/du with u along the rows and v from row to row; (0, 1, 0) where no triangle has an area.
// Tangents are dp/du, made perpendicular to the normal, of unit length; some perpendicular direction where
// dp/du vanishes.
void computeDirections(const FloatRows& positions, int width, int height, NormalScratch& scratch,
                       FloatRows& normals, FloatRows& tangents);

} // namespace clothlab::render
