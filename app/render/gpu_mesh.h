// Buffers and vertex arrays. They hold GL objects of one context; nothing is freed by destructors, which may
// run without a context: destroy() frees.
#pragma once

#include "app/render/gl_functions.h"
#include "app/render/render_frame.h"
#include "app/render/sheet_mesh.h"
#include "app/render/springs.h"

#include <memory>
#include <span>

namespace clothlab::render {

// A buffer object whose content is replaced whole.
class GpuBuffer {
public:
    // Leaves the buffer bound to `target`. The old store is given up, so that no draw call is waited for.
    template <typename T>
    void upload(Gl& gl, GLenum target, std::span<const T> data, GLenum usage) {
        create(gl);
        gl.glBindBuffer(target, m_id);
        gl.glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), usage);
        m_count = static_cast<GLsizei>(data.size());
    }
    // As upload(), but `fill` writes the data where they are to be: a span of `count`, to be written only.
    template <typename T, typename Fill>
    void write(Gl& gl, GLenum target, std::size_t count, GLenum usage, Fill fill) {
        create(gl);
        gl.glBindBuffer(target, m_id);
        const auto bytes = static_cast<GLsizeiptr>(count * sizeof(T));
        gl.glBufferData(target, bytes, nullptr, usage);
        m_count = static_cast<GLsizei>(count);
        void* const mapped =
            bytes > 0 ? gl.glMapBufferRange(target, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT)
                      : nullptr;
        if (mapped) {
            fill(std::span(static_cast<T*>(mapped), count));
            if (gl.glUnmapBuffer(target) == GL_TRUE)
                return;
        }
        // Not to be had, or lost while it was written, as when the screen's mode changes.
        std::vector<T> data(count);
        fill(std::span(data));
        gl.glBufferSubData(target, 0, bytes, data.data());
    }
    void bind(Gl& gl, GLenum target);
    void destroy(Gl& gl);
    GLsizei count() const { return m_count; } // elements last uploaded

private:
    void create(Gl& gl);

    GLuint m_id = 0;
    GLsizei m_count = 0;
};

// A surface that stays as it is: a collider.
class StaticMesh {
public:
    void upload(Gl& gl, const SurfaceMesh& mesh);
    void draw(Gl& gl) const;
    void destroy(Gl& gl);

private:
    GLuint m_vertexArray = 0;
    GpuBuffer m_vertices;
    GpuBuffer m_uvs;
    GpuBuffer m_indices;
};

// The sheet: one vertex array, with index buffers for what is drawn of it.
class SheetBuffers {
public:
    void initialize(Gl& gl);
    void destroy(Gl& gl);

    // Uploads what has changed since the last call, and nothing else. Says whether the mesh is another one.
    SheetMesh::Change update(Gl& gl, const SheetShape& sheet);

    const SheetMesh& mesh() const { return m_mesh; }
    void drawSurface(Gl& gl);
    void drawSprings(Gl& gl, SpringType type);
    void drawPinned(Gl& gl); // as GL_POINTS
    bool hasPinned() const { return m_pinned.count() > 0; }
    bool isEmpty() const { return m_mesh.isEmpty(); }

private:
    void uploadTopology(Gl& gl);
    void uploadPinned(Gl& gl, const SheetShape& sheet);
    void uploadStrains(Gl& gl, const SheetShape& sheet);
    void uploadRest(Gl& gl, const SheetShape& sheet);
    void drawElements(Gl& gl, GLenum mode, GpuBuffer& indices);

    SheetMesh m_mesh;
    GLuint m_vertexArray = 0;
    GpuBuffer m_vertices;
    GpuBuffer m_uvs;
    GpuBuffer m_triangles;
    std::array<GpuBuffer, kSpringTypes> m_springs;
    std::array<bool, kSpringTypes> m_springsUploaded{}; // made when first drawn: long lists for large sheets
    GpuBuffer m_strains;
    bool m_hasStrains = false;
    GpuBuffer m_rest;
    std::shared_ptr<const std::vector<float>> m_restPositions; // what was uploaded
    GpuBuffer m_pinned;
    std::vector<std::uint32_t> m_pinnedIndices; // those in range
};

// Positions that change from frame to frame, drawn as points or as lines of two.
class PositionBuffer {
public:
    void initialize(Gl& gl);
    void destroy(Gl& gl);
    void upload(Gl& gl, std::span<const QVector3D> positions);
    void draw(Gl& gl, GLenum mode) const;
    void bind(Gl& gl) const { gl.glBindVertexArray(m_vertexArray); }

private:
    GLuint m_vertexArray = 0;
    GpuBuffer m_positions;
};

} // namespace clothlab::render
