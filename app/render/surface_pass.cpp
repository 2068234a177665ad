#include "app/render/surface_pass.h"

#include "app/render/resample.h"
#include "app/render/shader_inputs.h"
#include "app/render/shapes.h"
#include "app/render/strain_colors.h"

#include <algorithm>

namespace clothlab::render {
namespace {

// Calmer than the sheet, which is drawn in the frame's own colour.
const QVector4D kColliderColor{0.46F, 0.48F, 0.51F, 1};
const QVector4D kPlaneColor{0.36F, 0.37F, 0.39F, 1};

constexpr int kSphereSegments = 96; // and half as many rings, unless a resolution is asked for
constexpr int kFinest = 512;

Bounds boundsOf(const FloatRows& positions) {
    if (positions.x.empty())
        return {};
    const auto x = std::minmax_element(positions.x.begin(), positions.x.end());
    const auto y = std::minmax_element(positions.y.begin(), positions.y.end());
    const auto z = std::minmax_element(positions.z.begin(), positions.z.end());
    return {{*x.first, *y.first, *z.first}, {*x.second, *y.second, *z.second}};
}

} // namespace

bool isWireframe(const RenderFrame& frame) {
    return frame.surface.shader == QLatin1String("Wireframe");
}

void SurfacePass::initialize(Gl& gl) {
    // Objects of an earlier context that was lost are gone with it.
    *this = SurfacePass();
    m_sheet.initialize(gl);
    m_resampled.initialize(gl);
    m_plane.upload(gl, makePlaneSquare());
}

void SurfacePass::destroy(Gl& gl) {
    m_sheet.destroy(gl);
    m_resampled.destroy(gl);
    m_sphere.destroy(gl);
    m_plane.destroy(gl);
    m_shadowMap.destroy(gl);
}

void SurfacePass::prepare(Gl& gl, const RenderFrame& frame, ShaderLibrary& shaders) {
    updateMeshes(gl, frame);
    if (!isWireframe(frame) && frame.light.shadows &&
        shaders.surface(gl, frame.surface.shader).has(Uniform::ShadowMap))
        drawShadowMap(gl, frame, shaders.shadow());
}

void SurfacePass::updateMeshes(Gl& gl, const RenderFrame& frame) {
    const SheetMesh::Change change = m_sheet.update(gl, frame.sheet);
    m_sheetBoundsAreCurrent = m_sheetBoundsAreCurrent && change == SheetMesh::Change::Nothing;
    const int cells = std::clamp(frame.surface.meshResolution, 0, kFinest);
    updateSphere(gl, cells);
    m_resampledIsOld = m_resampledIsOld || change != SheetMesh::Change::Nothing || cells != m_resampledCells;
    if (cells > 0 && !isWireframe(frame)) {
        // Strains may be other ones without the sheet having moved.
        if (m_resampledIsOld || !frame.sheet.strains.empty() || !m_resampledShape.strains.empty())
            resample(frame.sheet, cells, m_resampledShape);
        m_resampled.update(gl, m_resampledShape);
        m_resampledIsOld = false;
    }
    m_resampledCells = cells;
}

void SurfacePass::updateSphere(Gl& gl, int resolution) {
    if (resolution == m_sphereResolution)
        return;
    m_sphereResolution = resolution;
    m_sphere.destroy(gl);
    m_sphere.upload(gl, resolution > 0 ? makeUnitSphere(resolution, resolution)
                                       : makeUnitSphere(kSphereSegments, kSphereSegments / 2));
}

SheetBuffers& SurfacePass::surface(const RenderFrame& frame) {
    return frame.surface.meshResolution > 0 ? m_resampled : m_sheet;
}

void SurfacePass::drawShadowMap(Gl& gl, const RenderFrame& frame, const ShaderProgram& program) {
    if (!m_sheetBoundsAreCurrent)
        m_sheetBounds = boundsOf(m_sheet.mesh().positions());
    m_sheetBoundsAreCurrent = true;
    Bounds bounds = m_sheetBounds;
    for (const SphereShape& sphere : frame.spheres) {
        const QVector3D reach(sphere.radius, sphere.radius, sphere.radius);
        bounds.add(sphere.origin - reach);
        bounds.add(sphere.origin + reach);
    }
    m_lightView = lightViewProjection(frame.light.position, bounds);
    m_shadowMap.begin(gl);
    program.use(gl);
    program.set(gl, Uniform::ViewProjection, m_lightView);
    drawSpheres(gl, frame, program);
    program.set(gl, Uniform::Model, QMatrix4x4());
    surface(frame).drawSurface(gl);
    m_shadowMap.end(gl);
}

void SurfacePass::draw(Gl& gl, const RenderFrame& frame, ShaderLibrary& shaders, TextureStore& textures) {
    const bool wireframe = isWireframe(frame);
    const ShaderProgram& program =
        wireframe ? shaders.plainSurface() : shaders.surface(gl, frame.surface.shader);
    program.use(gl);
    setUniforms(gl, frame, program);
    setTextures(gl, frame.surface, program, textures);
    setShadows(gl, frame, program);
    setUserUniforms(gl, frame.surface, shaders.surfaceInUse(), program, textures);
    drawColliders(gl, frame, program);
    if (wireframe)
        return;
    program.set(gl, Uniform::Model, QMatrix4x4());
    program.set(gl, Uniform::Color, frame.surface.color);
    program.set(gl, Uniform::BackColor, frame.surface.backColor.value_or(frame.surface.color));
    surface(frame).drawSurface(gl);
}

void SurfacePass::setUniforms(Gl& gl, const RenderFrame& frame, const ShaderProgram& program) {
    program.set(gl, Uniform::ViewProjection, frame.viewProjection);
    program.set(gl, Uniform::CameraPosition, frame.cameraPosition);
    program.set(gl, Uniform::LightPosition, frame.light.position);
    program.set(gl, Uniform::LightIntensity, frame.light.intensity);
    program.set(gl, Uniform::NormalScaling, frame.surface.normalScaling);
    program.set(gl, Uniform::HeightScaling, frame.surface.heightScaling);
    program.set(gl, Uniform::TwoSided, frame.surface.twoSided ? 1 : 0);
    program.set(gl, Uniform::Time, frame.time);
    program.set(gl, Uniform::StrainRange, frame.strainRange);
    program.set(gl, Uniform::StrainColors, kStrainColors);
}

void SurfacePass::setShadows(Gl& gl, const RenderFrame& frame, const ShaderProgram& program) {
    if (program.has(Uniform::ShadowMap)) {
        bindTexture(gl, kShadowUnit, GL_TEXTURE_2D, m_shadowMap.texture(gl));
        program.set(gl, Uniform::ShadowMap, kShadowUnit);
    }
    QMatrix4x4 toTexture; // from clip space
    toTexture.translate(0.5F, 0.5F, 0.5F);
    toTexture.scale(0.5F);
    program.set(gl, Uniform::ShadowMatrix, toTexture * m_lightView);
    program.set(gl, Uniform::ShadowStrength, frame.light.shadows ? 1.0F : 0.0F);
}

void SurfacePass::drawColliders(Gl& gl, const RenderFrame& frame, const ShaderProgram& program) {
    program.set(gl, Uniform::Color, kPlaneColor);
    program.set(gl, Uniform::BackColor, kPlaneColor);
    for (const PlaneShape& plane : frame.planes) {
        if (plane.normal.isNull())
            continue;
        program.set(gl, Uniform::Model, planeModel(plane));
        m_plane.draw(gl);
    }
    program.set(gl, Uniform::Color, kColliderColor);
    program.set(gl, Uniform::BackColor, kColliderColor);
    drawSpheres(gl, frame, program);
}

void SurfacePass::drawSpheres(Gl& gl, const RenderFrame& frame, const ShaderProgram& program) {
    for (const SphereShape& sphere : frame.spheres) {
        if (!(sphere.radius > 0))
            continue;
        program.set(gl, Uniform::Model, sphereModel(sphere));
        m_sphere.draw(gl);
    }
}

} // namespace clothlab::render
