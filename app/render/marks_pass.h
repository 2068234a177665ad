// Draws what is not a surface: grid, springs, highlights, pinned points, axes.
#pragma once

#include "app/render/axes_gizmo.h"
#include "app/render/gpu_mesh.h"
#include "app/render/shader_library.h"
#include "app/render/texture_store.h"

#include <QSize>

namespace clothlab::render {

// Holds GL objects of one context; nothing is freed by the destructor, which may run without a context.
class MarksPass {
public:
    void initialize(Gl& gl);
    void destroy(Gl& gl);

    // With blending on.
    void draw(Gl& gl, const RenderFrame& frame, QSize pixels, ShaderLibrary& shaders, TextureStore& textures,
              SheetBuffers& sheet);

private:
    void drawGround(Gl& gl, const RenderFrame& frame, const ShaderProgram& program);
    void drawSprings(Gl& gl, const RenderFrame& frame, const ShaderProgram& program, TextureStore& textures,
                     SheetBuffers& sheet);
    void drawHighlight(Gl& gl, const RenderFrame& frame, const ShaderLibrary& shaders);
    void drawPinned(Gl& gl, const RenderFrame& frame, const ShaderProgram& program, SheetBuffers& sheet);
    void drawAxes(Gl& gl, const RenderFrame& frame, const ShaderProgram& program);
    void setView(Gl& gl, const ShaderProgram& program, const QMatrix4x4& viewProjection) const;

    QSize m_pixels;
    PositionBuffer m_highlightPoints;
    PositionBuffer m_highlightLines;
    PositionBuffer m_axesLines;
    std::array<GizmoAxis, 3> m_axes;
};

} // namespace clothlab::render
