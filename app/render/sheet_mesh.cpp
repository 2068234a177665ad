#include "app/render/sheet_mesh.h"

namespace clothlab::render {
namespace {

void makeIndices(int width, int height, std::vector<std::uint32_t>& indices) {
    indices.clear();
    for (int y = 0; y + 1 < height; ++y) {
        for (int x = 0; x + 1 < width; ++x) {
            const auto a = static_cast<std::uint32_t>(y * width + x);
            const auto below = a + static_cast<std::uint32_t>(width);
            indices.insert(indices.end(), {a, below, a + 1, a + 1, below, below + 1});
        }
    }
}

float fraction(int index, int count) {
    return count > 1 ? static_cast<float>(index) / static_cast<float>(count - 1) : 0.0F;
}

} // namespace

SheetMesh::Change SheetMesh::update(const SheetShape& sheet) {
    const bool fits = sheet.width > 0 && sheet.height > 0 &&
                      sheet.positions.size() ==
                          3 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height);
    const int width = fits ? sheet.width : 0;
    const int height = fits ? sheet.height : 0;
    const bool resized = width != m_width || height != m_height;
    if (!resized && !fits)
        return Change::Nothing;
    if (resized)
        resize(width, height);
    if (!fits)
        return Change::Size;
    if (!takePositions(sheet.positions) && !resized)
        return Change::Nothing;
    computeDirections(m_positions, width, height, m_scratch, m_normals, m_tangents);
    return resized ? Change::Size : Change::Positions;
}

void SheetMesh::resize(int width, int height) {
    m_width = width;
    m_height = height;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (FloatRows* rows : {&m_positions, &m_normals, &m_tangents})
        rows->resize(count);
    m_uvs.resize(count);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            m_uvs[static_cast<std::size_t>(y * width + x)] = {fraction(x, width), fraction(y, height)};
    makeIndices(width, height, m_indices);
}

bool SheetMesh::takePositions(const std::vector<float>& positions) {
    unsigned changed = 0;
    const auto take = [&changed](float& to, float from) {
        changed |= static_cast<unsigned>(to != from);
        to = from;
    };
    for (std::size_t i = 0; i < size(); ++i) {
        take(m_positions.x[i], positions[3 * i]);
        take(m_positions.y[i], positions[3 * i + 1]);
        take(m_positions.z[i], positions[3 * i + 2]);
    }
    return changed != 0;
}

void SheetMesh::writeVertices(std::span<SurfaceVertex> to) const {
    for (std::size_t i = 0; i < size(); ++i)
        to[i] = {{m_positions.x[i], m_positions.y[i], m_positions.z[i]},
                 {m_normals.x[i], m_normals.y[i], m_normals.z[i], 0},
                 {m_tangents.x[i], m_tangents.y[i], m_tangents.z[i], 0}};
}

} // namespace clothlab::render
