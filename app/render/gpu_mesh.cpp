#include "app/render/gpu_mesh.h"

#include "app/render/shader_program.h"

#include <cstddef>

namespace clothlab::render {
namespace {

void attribute(Gl& gl, Attribute index, GLint components, std::size_t stride, std::size_t offset) {
    gl.glEnableVertexAttribArray(index);
    gl.glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                             reinterpret_cast<const void*>(offset));
}

// With the vertex array bound. Positions have three components, so that OpenGL adds w = 1.
void describeSurface(Gl& gl, GpuBuffer& vertices, GpuBuffer& uvs) {
    vertices.bind(gl, GL_ARRAY_BUFFER);
    attribute(gl, kPosition, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, position));
    attribute(gl, kNormal, 4, sizeof(SurfaceVertex), offsetof(SurfaceVertex, normal));
    attribute(gl, kTangent, 4, sizeof(SurfaceVertex), offsetof(SurfaceVertex, tangent));
    uvs.bind(gl, GL_ARRAY_BUFFER);
    attribute(gl, kUv, 2, 2 * sizeof(float), 0);
}

void destroyVertexArray(Gl& gl, GLuint& id) {
    gl.glDeleteVertexArrays(1, &id);
    id = 0;
}

} // namespace

void GpuBuffer::create(Gl& gl) {
    if (m_id == 0)
        gl.glGenBuffers(1, &m_id);
}

void GpuBuffer::bind(Gl& gl, GLenum target) {
    create(gl);
    gl.glBindBuffer(target, m_id);
}

void GpuBuffer::destroy(Gl& gl) {
    gl.glDeleteBuffers(1, &m_id);
    *this = GpuBuffer();
}

void StaticMesh::upload(Gl& gl, const SurfaceMesh& mesh) {
    gl.glGenVertexArrays(1, &m_vertexArray);
    gl.glBindVertexArray(m_vertexArray);
    m_vertices.upload(gl, GL_ARRAY_BUFFER, std::span(mesh.vertices), GL_STATIC_DRAW);
    m_uvs.upload(gl, GL_ARRAY_BUFFER, std::span(mesh.uvs), GL_STATIC_DRAW);
    m_indices.upload(gl, GL_ELEMENT_ARRAY_BUFFER, std::span(mesh.indices), GL_STATIC_DRAW);
    describeSurface(gl, m_vertices, m_uvs);
    gl.glBindVertexArray(0);
}

void StaticMesh::draw(Gl& gl) const {
    gl.glBindVertexArray(m_vertexArray);
    gl.glDrawElements(GL_TRIANGLES, m_indices.count(), GL_UNSIGNED_INT, nullptr);
}

void StaticMesh::destroy(Gl& gl) {
    destroyVertexArray(gl, m_vertexArray);
    for (GpuBuffer* buffer : {&m_vertices, &m_uvs, &m_indices})
        buffer->destroy(gl);
}

void SheetBuffers::initialize(Gl& gl) {
    gl.glGenVertexArrays(1, &m_vertexArray);
    gl.glBindVertexArray(m_vertexArray);
    describeSurface(gl, m_vertices, m_uvs);
    gl.glBindVertexArray(0);
}

void SheetBuffers::destroy(Gl& gl) {
    destroyVertexArray(gl, m_vertexArray);
    for (GpuBuffer* buffer : {&m_vertices, &m_uvs, &m_triangles, &m_strains, &m_rest, &m_pinned})
        buffer->destroy(gl);
    for (GpuBuffer& buffer : m_springs)
        buffer.destroy(gl);
    *this = SheetBuffers();
}

SheetMesh::Change SheetBuffers::update(Gl& gl, const SheetShape& sheet) {
    const SheetMesh::Change change = m_mesh.update(sheet);
    gl.glBindVertexArray(m_vertexArray);
    if (change == SheetMesh::Change::Size)
        uploadTopology(gl);
    if (change != SheetMesh::Change::Nothing)
        m_vertices.write<SurfaceVertex>(gl, GL_ARRAY_BUFFER, m_mesh.size(), GL_STREAM_DRAW,
                                        [this](std::span<SurfaceVertex> to) { m_mesh.writeVertices(to); });
    uploadStrains(gl, sheet);
    uploadRest(gl, sheet);
    uploadPinned(gl, sheet);
    return change;
}

// What no array gives is 0 in every shader.
void SheetBuffers::uploadStrains(Gl& gl, const SheetShape& sheet) {
    const bool fits = !isEmpty() && sheet.strains.size() == m_mesh.size();
    if (fits) {
        m_strains.upload(gl, GL_ARRAY_BUFFER, std::span(sheet.strains), GL_STREAM_DRAW);
        attribute(gl, kStrain, 1, sizeof(float), 0);
    } else if (m_hasStrains) {
        gl.glDisableVertexAttribArray(kStrain);
    }
    m_hasStrains = fits;
}

void SheetBuffers::uploadRest(Gl& gl, const SheetShape& sheet) {
    const auto& rest = sheet.restPositions;
    const bool fits = rest && !isEmpty() && rest->size() == 3 * m_mesh.size();
    if (!fits) {
        gl.glDisableVertexAttribArray(kRest);
        m_restPositions.reset();
    } else if (rest != m_restPositions) {
        m_rest.upload(gl, GL_ARRAY_BUFFER, std::span(*rest), GL_STATIC_DRAW);
        attribute(gl, kRest, 3, 3 * sizeof(float), 0);
        m_restPositions = rest;
    }
}

void SheetBuffers::uploadTopology(Gl& gl) {
    m_uvs.upload(gl, GL_ARRAY_BUFFER, std::span(m_mesh.uvs()), GL_STATIC_DRAW);
    m_triangles.upload(gl, GL_ELEMENT_ARRAY_BUFFER, std::span(m_mesh.indices()), GL_STATIC_DRAW);
    m_springsUploaded.fill(false);
}

void SheetBuffers::uploadPinned(Gl& gl, const SheetShape& sheet) {
    m_pinnedIndices.clear();
    for (const std::uint32_t index : sheet.pinned)
        if (index < m_mesh.size())
            m_pinnedIndices.push_back(index);
    m_pinned.upload(gl, GL_ELEMENT_ARRAY_BUFFER, std::span<const std::uint32_t>(m_pinnedIndices),
                    GL_STREAM_DRAW);
}

void SheetBuffers::drawElements(Gl& gl, GLenum mode, GpuBuffer& indices) {
    if (indices.count() == 0)
        return;
    gl.glBindVertexArray(m_vertexArray);
    indices.bind(gl, GL_ELEMENT_ARRAY_BUFFER);
    gl.glDrawElements(mode, indices.count(), GL_UNSIGNED_INT, nullptr);
}

void SheetBuffers::drawSurface(Gl& gl) {
    drawElements(gl, GL_TRIANGLES, m_triangles);
}

void SheetBuffers::drawSprings(Gl& gl, SpringType type) {
    const auto i = static_cast<std::size_t>(type);
    if (!m_springsUploaded[i]) {
        const std::vector<std::uint32_t> indices = springIndices(m_mesh.width(), m_mesh.height(), type);
        gl.glBindVertexArray(m_vertexArray);
        m_springs[i].upload(gl, GL_ELEMENT_ARRAY_BUFFER, std::span(indices), GL_STATIC_DRAW);
        m_springsUploaded[i] = true;
    }
    drawElements(gl, GL_LINES, m_springs[i]);
}

void SheetBuffers::drawPinned(Gl& gl) {
    drawElements(gl, GL_POINTS, m_pinned);
}

void PositionBuffer::initialize(Gl& gl) {
    static_assert(sizeof(QVector3D) == 3 * sizeof(float));
    gl.glGenVertexArrays(1, &m_vertexArray);
    gl.glBindVertexArray(m_vertexArray);
    m_positions.bind(gl, GL_ARRAY_BUFFER);
    attribute(gl, kPosition, 3, sizeof(QVector3D), 0);
    gl.glBindVertexArray(0);
}

void PositionBuffer::destroy(Gl& gl) {
    destroyVertexArray(gl, m_vertexArray);
    m_positions.destroy(gl);
}

void PositionBuffer::upload(Gl& gl, std::span<const QVector3D> positions) {
    m_positions.upload(gl, GL_ARRAY_BUFFER, positions, GL_STREAM_DRAW);
}

void PositionBuffer::draw(Gl& gl, GLenum mode) const {
    bind(gl);
    gl.glDrawArrays(mode, 0, m_positions.count());
}

} // namespace clothlab::render
