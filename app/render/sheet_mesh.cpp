#include "app/render/sheet_mesh.h"

#include "app/render/vector_math.h"

#include <algorithm>
#include <numbers>

namespace clothlab::render {
namespace {

// Angle whose cosine is given, within 7e-5 rad (Abramowitz and Stegun 4.4.45): a weight needs no more, and
// std::acos would be most of the time of a large sheet.
float approximateAcos(float cosine) {
    const float x = std::min(std::abs(cosine), 1.0F);
    const float angle =
        std::sqrt(1 - x) * (1.5707288F + x * (-0.2121144F + x * (0.0742610F - x * 0.0187293F)));
    return cosine < 0 ? std::numbers::pi_v<float> - angle : angle;
}

void accumulate(SurfaceVertex& vertex, float weight, const Vec3& unitNormal) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        vertex.normal[axis] += weight * unitNormal[axis];
}

void addTriangle(SurfaceVertex& a, SurfaceVertex& b, SurfaceVertex& c) {
    const Vec3 ab = b.position - a.position;
    const Vec3 ac = c.position - a.position;
    const Vec3 bc = c.position - b.position;
    const Vec3 areaNormal = cross(ab, ac);
    const float doubleArea = std::sqrt(dot(areaNormal, areaNormal));
    if (!(doubleArea > 1e-20F) || !std::isfinite(doubleArea))
        return;
    const Vec3 normal = (1 / doubleArea) * areaNormal;
    const float abSquared = dot(ab, ab);
    const float angleA = approximateAcos(dot(ab, ac) / std::sqrt(abSquared * dot(ac, ac)));
    const float angleB = approximateAcos(-dot(ab, bc) / std::sqrt(abSquared * dot(bc, bc)));
    accumulate(a, angleA, normal);
    accumulate(b, angleB, normal);
    accumulate(c, std::max(0.0F, std::numbers::pi_v<float> - angleA - angleB), normal);
}

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
    if (!resized && (!fits || sheet.positions == m_positions))
        return Change::Nothing;
    if (resized)
        resize(width, height);
    if (!fits)
        return Change::Size;
    m_positions = sheet.positions;
    for (std::size_t i = 0; i < m_mesh.vertices.size(); ++i)
        m_mesh.vertices[i] = {{m_positions[3 * i], m_positions[3 * i + 1], m_positions[3 * i + 2]}, {}, {}};
    computeNormals();
    computeTangents();
    return resized ? Change::Size : Change::Positions;
}

void SheetMesh::resize(int width, int height) {
    m_width = width;
    m_height = height;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    m_positions.clear();
    m_mesh.vertices.assign(count, {});
    m_mesh.uvs.resize(count);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            m_mesh.uvs[static_cast<std::size_t>(y * width + x)] = {fraction(x, width), fraction(y, height)};
    makeIndices(width, height, m_mesh.indices);
}

void SheetMesh::computeNormals() {
    for (std::size_t i = 0; i + 2 < m_mesh.indices.size(); i += 3)
        addTriangle(m_mesh.vertices[m_mesh.indices[i]], m_mesh.vertices[m_mesh.indices[i + 1]],
                    m_mesh.vertices[m_mesh.indices[i + 2]]);
    for (SurfaceVertex& vertex : m_mesh.vertices) {
        const Vec3 sum{vertex.normal[0], vertex.normal[1], vertex.normal[2]};
        const Vec3 n = normalizedOr(sum, {0, 1, 0});
        vertex.normal = {n[0], n[1], n[2], 0};
    }
}

// On a grid dp/du is the difference along the row: of the neighbours on both sides, or at the border of the
// one.
void SheetMesh::computeTangents() {
    for (int y = 0; y < m_height; ++y) {
        SurfaceVertex* row = m_mesh.vertices.data() + static_cast<std::ptrdiff_t>(y) * m_width;
        for (int x = 0; x < m_width; ++x) {
            const Vec3 along = row[std::min(x + 1, m_width - 1)].position - row[std::max(x - 1, 0)].position;
            const Vec3 n{row[x].normal[0], row[x].normal[1], row[x].normal[2]};
            const Vec3 t = normalizedOr(along - dot(along, n) * n, anyPerpendicular(n));
            row[x].tangent = {t[0], t[1], t[2], 0};
        }
    }
}

} // namespace clothlab::render
