// Triangles, normals, tangents and texture coordinates of a grid of points.
#pragma once

#include "app/render/render_frame.h"
#include "app/render/sheet_normals.h"
#include "app/render/surface_mesh.h"

#include <span>

namespace clothlab::render {

// Each cell of the grid is two triangles that share the diagonal from (x + 1, y) to (x, y + 1). The normal's
// side is that of (row direction) x (column direction) = dp/dv x dp/du: up, for a sheet with x to +x and y to
// +z.
class SheetMesh {
public:
    enum class Change { Nothing, Positions, Size };

    // Takes the sheet's shape over; says what has to be uploaded again. Memory is only taken when the size
    // changes. A sheet whose number of positions is not 3 * width * height, or that is empty, leaves an empty
    // mesh. A sheet one point wide or high has vertices but no triangles.
    //
    // Normals are averages over the triangles of a point, weighted by the angle there (Thuermer and Wuethrich
    // 1998), of unit length; (0, 1, 0) where there is no triangle with an area. Tangents are dp/du, made
    // perpendicular to the normal, of unit length; some perpendicular direction where dp/du vanishes.
    Change update(const SheetShape& sheet);

    // The mesh, as in SurfaceMesh. Vertices are written where they are wanted, size() of them: a large
    // sheet's are too many to be kept twice.
    void writeVertices(std::span<SurfaceVertex> to) const;
    const std::vector<std::array<float, 2>>& uvs() const { return m_uvs; }
    const std::vector<std::uint32_t>& indices() const { return m_indices; }
    std::size_t size() const { return m_positions.x.size(); }
    const FloatRows& positions() const { return m_positions; } // of the vertices
    int width() const { return m_width; }
    int height() const { return m_height; }
    bool isEmpty() const { return size() == 0; }

private:
    void resize(int width, int height);
    bool takePositions(const std::vector<float>& positions); // true if any is another one

    int m_width = 0;
    int m_height = 0;
    FloatRows m_positions;
    FloatRows m_normals;
    FloatRows m_tangents;
    NormalScratch m_scratch;
    std::vector<std::array<float, 2>> m_uvs;
    std::vector<std::uint32_t> m_indices;
};

} // namespace clothlab::render
