// The topology of a sheet: points in a grid and the springs that join them, computed, not stored.
#pragma once

#include "simcore/scene/scene.h"

#include <array>
#include <span>
#include <vector>

namespace clothlab {

// One of the six half-stencils: a spring joins each point (x, y) with (x + dx, y + dy) where both exist.
struct Stencil {
    SpringType type;
    int dx;
    int dy;
};

// In the order in which the strain limit goes through them.
inline constexpr std::array<Stencil, 6> kStencils{{{SpringType::Structural, -1, 0},
                                                   {SpringType::Structural, 0, -1},
                                                   {SpringType::Shearing, -1, -1},
                                                   {SpringType::Shearing, 1, -1},
                                                   {SpringType::Bending, -2, 0},
                                                   {SpringType::Bending, 0, -2}}};

// Points a spring can start from: columns [xBegin, xEnd) of rows [yBegin, yEnd). Empty if the grid is too
// small.
struct StencilRange {
    int xBegin, xEnd, yBegin, yEnd;
    int columns() const { return xEnd > xBegin ? xEnd - xBegin : 0; }
    int rows() const { return yEnd > yBegin ? yEnd - yBegin : 0; }
    int count() const { return columns() * rows(); }
};

struct Spring {
    int stencil; // index into kStencils
    int a;       // index of the point it starts from
    int b;       // index of the point it joins that one with
    SpringType type() const { return kStencils[static_cast<std::size_t>(stencil)].type; }
};

// width × height points, row-major: index = y * width + x. Both at least 1.
struct Grid {
    int width = 0;
    int height = 0;
    friend bool operator==(const Grid&, const Grid&) = default;

    int pointCount() const { return width * height; }
    int index(int x, int y) const { return y * width + x; }
    int index(GridPoint p) const { return index(p.x, p.y); }
    GridPoint place(int index) const { return {index % width, index / width}; }

    StencilRange range(const Stencil& stencil) const;
    int springCount() const;
    int springCount(SpringType type) const;

    // Springs are numbered in the order of the strain limit: stencil after stencil, row-major within each.
    Spring spring(int number) const;             // precondition: 0 <= number < springCount()
    int springNumber(int stencil, int a) const;  // -1 if no such spring starts at a
    std::vector<int> springsOf(int point) const; // numbers of all springs that end there, ascending
};

inline Grid gridOf(const Cloth& cloth) {
    return {cloth.numWidthPoints, cloth.numHeightPoints};
}

std::string_view name(SpringType type); // "structural"

} // namespace clothlab
