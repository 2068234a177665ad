// Draws the sheet's surface, the colliders and their shadows.
#pragma once

#include "app/render/gpu_mesh.h"
#include "app/render/shader_library.h"
#include "app/render/shadow_map.h"
#include "app/render/texture_store.h"

namespace clothlab::render {

// The shader that draws springs instead of a surface.
bool isWireframe(const RenderFrame& frame);

// Holds GL objects of one context; nothing is freed by the destructor, which may run without a context.
class SurfacePass {
public:
    void initialize(Gl& gl);
    void destroy(Gl& gl);

    // Uploads what has changed, and draws the shadow map if the shader asks for one.
    void prepare(Gl& gl, const RenderFrame& frame, ShaderLibrary& shaders);
    void draw(Gl& gl, const RenderFrame& frame, ShaderLibrary& shaders, TextureStore& textures);

    SheetBuffers& sheet() { return m_sheet; } // as simulated

private:
    void updateMeshes(Gl& gl, const RenderFrame& frame);
    void updateSphere(Gl& gl, int resolution);
    void drawShadowMap(Gl& gl, const RenderFrame& frame, const ShaderProgram& program);
    void setUniforms(Gl& gl, const RenderFrame& frame, const ShaderProgram& program);
    void setShadows(Gl& gl, const RenderFrame& frame, const ShaderProgram& program);
    void drawColliders(Gl& gl, const RenderFrame& frame, const ShaderProgram& program);
    void drawSpheres(Gl& gl, const RenderFrame& frame, const ShaderProgram& program);
    SheetBuffers& surface(const RenderFrame& frame);

    SheetBuffers m_sheet;
    SheetBuffers m_resampled; // the surface, if its resolution is not the simulated one
    SheetShape m_resampledShape;
    int m_resampledCells = 0;
    bool m_resampledIsOld = false; // the sheet has moved since
    Bounds m_sheetBounds;
    bool m_sheetBoundsAreCurrent = false;
    StaticMesh m_sphere;
    int m_sphereResolution = -1;
    StaticMesh m_plane;
    ShadowMap m_shadowMap;
    QMatrix4x4 m_lightView; // of what is in the shadow map
};

} // namespace clothlab::render
