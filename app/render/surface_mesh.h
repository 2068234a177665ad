// The vertices and triangles that every surface shader takes, sheet and colliders alike.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace clothlab::render {

// Laid out as it is uploaded. The directions carry their w = 0, because OpenGL would fill in 1.
struct SurfaceVertex {
    std::array<float, 3> position{};
    std::array<float, 4> normal{};
    std::array<float, 4> tangent{};
};

struct SurfaceMesh {
    std::vector<SurfaceVertex> vertices;
    std::vector<std::array<float, 2>> uvs; // as many as vertices
    std::vector<std::uint32_t> indices;    // three a triangle, counter-clockwise seen from the normal's side
};

} // namespace clothlab::render
