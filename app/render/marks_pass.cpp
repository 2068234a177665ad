#include "app/render/marks_pass.h"

#include "app/render/shader_inputs.h"
#include "app/render/strain_colors.h"
#include "app/render/surface_pass.h"
#include "app/render/view_metrics.h"

#include <algorithm>

namespace clothlab::render {
namespace {

const QVector4D kGridColor{0.62F, 0.65F, 0.69F, 1};

// Pixels at scale 1. Bending springs lie under structural ones on a flat sheet: drawn wider, they show on
// both sides.
constexpr std::array<float, kSpringTypes> kSpringWidth{1.6F, 1.2F, 2.8F};
constexpr std::array<float, kSpringTypes> kSpringMaxFill{0.16F, 0.10F, 0.15F}; // of their own length
constexpr std::array<float, kSpringTypes> kSpringNearer{4.0F, 3.5F, 3.0F};
constexpr float kHighlightWidth = 4;
constexpr float kDotRadius = 5;
constexpr float kPinnedRadius = 4;
constexpr float kOnTop = 6;         // nearer to the viewer, in pixels' size
constexpr float kGhostAlpha = 0.3F; // of dots and highlights behind something

QVector4D toVector(const QColor& color) {
    return {color.redF(), color.greenF(), color.blueF(), color.alphaF()};
}

QVector4D faded(QVector4D color, float factor) {
    color.setW(color.w() * factor);
    return color;
}

// Draws what is in front, then faintly what is behind something: two sets of pixels that don't overlap.
template <typename Draw>
void drawOnTop(Gl& gl, const ShaderProgram& program, const QVector4D& color, Draw draw) {
    gl.glDepthMask(GL_FALSE);
    program.set(gl, Uniform::Color, color);
    draw();
    gl.glDepthFunc(GL_GREATER);
    program.set(gl, Uniform::Color, faded(color, kGhostAlpha));
    draw();
    gl.glDepthFunc(GL_LEQUAL);
    gl.glDepthMask(GL_TRUE);
}

} // namespace

void MarksPass::initialize(Gl& gl) {
    // Objects of an earlier context that was lost are gone with it.
    *this = MarksPass();
    for (PositionBuffer* buffer : {&m_highlightPoints, &m_highlightLines, &m_axesLines})
        buffer->initialize(gl);
}

void MarksPass::destroy(Gl& gl) {
    for (PositionBuffer* buffer : {&m_highlightPoints, &m_highlightLines, &m_axesLines})
        buffer->destroy(gl);
}

void MarksPass::draw(Gl& gl, const RenderFrame& frame, QSize pixels, ShaderLibrary& shaders,
                     TextureStore& textures, SheetBuffers& sheet) {
    m_pixels = pixels;
    drawGround(gl, frame, shaders.ground());
    if (isWireframe(frame) || frame.springs.overSurface)
        drawSprings(gl, frame, shaders.springs(gl), textures, sheet);
    drawHighlight(gl, frame, shaders);
    drawPinned(gl, frame, shaders.dots(), sheet);
    drawAxes(gl, frame, shaders.lines());
}

void MarksPass::drawGround(Gl& gl, const RenderFrame& frame, const ShaderProgram& program) {
    if (!frame.groundGrid || !(frame.gridOpacity > 0))
        return;
    program.use(gl);
    program.set(gl, Uniform::ViewProjection, frame.viewProjection);
    program.set(gl, Uniform::CameraPosition, frame.cameraPosition);
    program.set(gl, Uniform::Radius, 4 * frame.cameraPosition.length() + 2);
    program.set(gl, Uniform::Width, frame.devicePixelRatio);
    program.set(gl, Uniform::Color, faded(kGridColor, frame.gridOpacity));
    gl.glDepthMask(GL_FALSE);
    // A plane at y = 0 is where the grid is, too.
    gl.glEnable(GL_POLYGON_OFFSET_FILL);
    gl.glPolygonOffset(-1, -4);
    m_highlightPoints.bind(gl); // any vertex array: the square is made of vertex numbers
    gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl.glDisable(GL_POLYGON_OFFSET_FILL);
    gl.glDepthMask(GL_TRUE);
}

void MarksPass::setView(Gl& gl, const ShaderProgram& program, const QMatrix4x4& viewProjection) const {
    program.set(gl, Uniform::ViewProjection, viewProjection);
    program.set(gl, Uniform::Viewport,
                QVector2D(static_cast<float>(m_pixels.width()), static_cast<float>(m_pixels.height())));
    program.set(gl, Uniform::PixelSize, pixelSize(viewProjection, m_pixels));
    program.set(gl, Uniform::DepthSlope, depthSlope(viewProjection));
}

// The thin ones last, so that their smooth edges blend with what lies under them.
void MarksPass::drawSprings(Gl& gl, const RenderFrame& frame, const ShaderProgram& program,
                            TextureStore& textures, SheetBuffers& sheet) {
    program.use(gl);
    setView(gl, program, frame.viewProjection);
    program.set(gl, Uniform::Model, QMatrix4x4());
    program.set(gl, Uniform::CameraPosition, frame.cameraPosition);
    program.set(gl, Uniform::LightPosition, frame.light.position);
    program.set(gl, Uniform::LightIntensity, frame.light.intensity);
    setTextures(gl, frame.surface, program, textures);
    setUserUniforms(gl, frame.surface, QStringLiteral("Wireframe"), program, textures);
    program.set(gl, Uniform::ByStrain, frame.springs.coloredByStrain ? 1 : 0);
    program.set(gl, Uniform::StrainRange, frame.strainRange);
    program.set(gl, Uniform::StrainColors, kStrainColors);
    for (const SpringType type : {SpringType::Bending, SpringType::Shearing, SpringType::Structural}) {
        const auto i = static_cast<std::size_t>(type);
        if (!frame.springs.drawn[i])
            continue;
        program.set(gl, Uniform::Color, toVector(frame.springs.colors[i]));
        program.set(gl, Uniform::Width, kSpringWidth[i] * frame.devicePixelRatio);
        program.set(gl, Uniform::MaxFill, kSpringMaxFill[i]);
        program.set(gl, Uniform::DepthBias, kSpringNearer[i] * frame.devicePixelRatio);
        sheet.drawSprings(gl, type);
    }
}

void MarksPass::drawHighlight(Gl& gl, const RenderFrame& frame, const ShaderLibrary& shaders) {
    const QVector4D color = toVector(frame.highlightColor);
    if (const auto& segments = frame.highlight.segments; !segments.empty()) {
        const ShaderProgram& program = shaders.lines();
        program.use(gl);
        setView(gl, program, frame.viewProjection);
        program.set(gl, Uniform::Width, kHighlightWidth * frame.devicePixelRatio);
        program.set(gl, Uniform::MaxFill, 0.0F);
        program.set(gl, Uniform::DepthBias, kOnTop * frame.devicePixelRatio);
        m_highlightLines.upload(gl, std::span(segments.front().data(), 2 * segments.size()));
        drawOnTop(gl, program, color, [&] { m_highlightLines.draw(gl, GL_LINES); });
    }
    if (const auto& points = frame.highlight.points; !points.empty()) {
        const ShaderProgram& program = shaders.dots();
        program.use(gl);
        setView(gl, program, frame.viewProjection);
        program.set(gl, Uniform::Radius, kDotRadius * frame.devicePixelRatio);
        program.set(gl, Uniform::DepthBias, kOnTop * frame.devicePixelRatio);
        m_highlightPoints.upload(gl, std::span(points));
        drawOnTop(gl, program, color, [&] { m_highlightPoints.draw(gl, GL_POINTS); });
    }
}

void MarksPass::drawPinned(Gl& gl, const RenderFrame& frame, const ShaderProgram& program,
                           SheetBuffers& sheet) {
    if (!sheet.hasPinned())
        return;
    program.use(gl);
    setView(gl, program, frame.viewProjection);
    program.set(gl, Uniform::Radius, kPinnedRadius * frame.devicePixelRatio);
    program.set(gl, Uniform::DepthBias, kOnTop * frame.devicePixelRatio);
    drawOnTop(gl, program, toVector(frame.pinnedColor), [&] { sheet.drawPinned(gl); });
}

void MarksPass::drawAxes(Gl& gl, const RenderFrame& frame, const ShaderProgram& program) {
    gl.glDisable(GL_DEPTH_TEST);
    if (!frame.axes)
        return;
    const float radius = kGizmoRadius * frame.devicePixelRatio;
    QMatrix4x4 corner; // pixels from the gizmo's middle to clip space
    const auto width = static_cast<float>(m_pixels.width());
    const auto height = static_cast<float>(m_pixels.height());
    const float middle = 1.35F * radius;
    corner.ortho(-middle, width - middle, -middle, height - middle, -1, 1);

    program.use(gl);
    setView(gl, program, corner);
    program.set(gl, Uniform::Width, 2 * frame.devicePixelRatio);
    program.set(gl, Uniform::MaxFill, 0.0F);
    program.set(gl, Uniform::DepthBias, 0.0F);
    makeAxesGizmo(frame.viewProjection, frame.devicePixelRatio, m_axes);
    for (const GizmoAxis& axis : m_axes) {
        program.set(gl, Uniform::Color, axis.color);
        m_axesLines.upload(gl, std::span(axis.lines));
        m_axesLines.draw(gl, GL_LINES);
    }
}

} // namespace clothlab::render
