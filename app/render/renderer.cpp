#include "app/render/renderer.h"

#include "app/render/axes_gizmo.h"
#include "app/render/gpu_mesh.h"
#include "app/render/shader_library.h"
#include "app/render/shapes.h"
#include "app/render/view_metrics.h"

#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>

#include <algorithm>

namespace clothlab::render {
namespace {

// Calmer than the sheet, which is drawn in the frame's own colour.
const QVector4D kColliderColor{0.46F, 0.48F, 0.51F, 1};
const QVector4D kPlaneColor{0.36F, 0.37F, 0.39F, 1};
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

bool canSpeak33(const QOpenGLContext& context) {
    return !context.isOpenGLES() && context.format().version() >= qMakePair(3, 3);
}

} // namespace

class Renderer::Passes {
public:
    bool initialize(QString* error);
    void release();
    void render(const RenderFrame& frame, QSize pixels);

    Gl* gl = nullptr; // owned by the context; null when not initialised
    ShaderLibrary shaders;

private:
    void clear(const RenderFrame& frame);
    void drawSurfaces(const RenderFrame& frame);
    void drawColliders(const ShaderProgram& program, const RenderFrame& frame);
    void drawGround(const RenderFrame& frame);
    void drawSprings(const RenderFrame& frame);
    void drawHighlight(const RenderFrame& frame);
    void drawPinned(const RenderFrame& frame);
    void drawAxes(const RenderFrame& frame);
    void setView(const ShaderProgram& program, const QMatrix4x4& viewProjection, QSize pixels);
    template <typename Draw>
    void drawOnTop(const ShaderProgram& program, const QVector4D& color, Draw draw);

    QSize m_pixels;
    SheetBuffers m_sheet;
    StaticMesh m_sphere;
    StaticMesh m_plane;
    PositionBuffer m_highlightPoints;
    PositionBuffer m_highlightLines;
    PositionBuffer m_axesLines;
    std::array<GizmoAxis, 3> m_axes;
};

bool Renderer::Passes::initialize(QString* error) {
    const auto fail = [this, error](const QString& reason) {
        if (error)
            *error = reason;
        gl = nullptr;
        return false;
    };
    QOpenGLContext* context = QOpenGLContext::currentContext();
    if (!context)
        return fail(QStringLiteral("There is no current OpenGL context."));
    if (canSpeak33(*context))
        gl = QOpenGLVersionFunctionsFactory::get<Gl>(context);
    else
        gl = nullptr;
    if (!gl || !gl->initializeOpenGLFunctions())
        return fail(QStringLiteral("OpenGL 3.3 core is needed; this context has %1%2.%3.")
                        .arg(context->isOpenGLES() ? QStringLiteral("ES ") : QString())
                        .arg(context->format().majorVersion())
                        .arg(context->format().minorVersion()));
    QString reason;
    if (!shaders.initialize(*gl, &reason))
        return fail(reason);
    // Objects of an earlier context that was lost are gone with it.
    m_sheet = SheetBuffers();
    m_sphere = StaticMesh();
    m_plane = StaticMesh();
    m_highlightPoints = PositionBuffer();
    m_highlightLines = PositionBuffer();
    m_axesLines = PositionBuffer();
    m_sheet.initialize(*gl);
    m_sphere.upload(*gl, makeUnitSphere(96, 48));
    m_plane.upload(*gl, makePlaneSquare());
    for (PositionBuffer* buffer : {&m_highlightPoints, &m_highlightLines, &m_axesLines})
        buffer->initialize(*gl);
    return true;
}

void Renderer::Passes::release() {
    if (!gl)
        return;
    shaders.destroy(*gl);
    m_sheet.destroy(*gl);
    m_sphere.destroy(*gl);
    m_plane.destroy(*gl);
    for (PositionBuffer* buffer : {&m_highlightPoints, &m_highlightLines, &m_axesLines})
        buffer->destroy(*gl);
    gl = nullptr;
}

void Renderer::Passes::render(const RenderFrame& frame, QSize pixels) {
    m_pixels = pixels;
    clear(frame);
    m_sheet.update(*gl, frame.sheet);
    drawSurfaces(frame);
    gl->glEnable(GL_BLEND);
    drawGround(frame);
    drawSprings(frame);
    drawHighlight(frame);
    drawPinned(frame);
    drawAxes(frame);

    gl->glDisable(GL_BLEND);
    gl->glDisable(GL_PROGRAM_POINT_SIZE);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->glUseProgram(0);
    gl->glBindVertexArray(0);
    gl->glBindBuffer(GL_ARRAY_BUFFER, 0);
}

// Sets all the state that the passes rely on: a painter may have been here before.
void Renderer::Passes::clear(const RenderFrame& frame) {
    gl->glViewport(0, 0, m_pixels.width(), m_pixels.height());
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glDisable(GL_STENCIL_TEST);
    gl->glDisable(GL_CULL_FACE);
    gl->glDisable(GL_BLEND);
    gl->glEnable(GL_MULTISAMPLE);
    gl->glEnable(GL_PROGRAM_POINT_SIZE);
    gl->glEnable(GL_DEPTH_TEST);
    gl->glDepthFunc(GL_LEQUAL);
    gl->glDepthMask(GL_TRUE);
    gl->glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl->glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const QVector4D background = toVector(frame.background);
    gl->glClearColor(background.x(), background.y(), background.z(), 1);
    gl->glClearDepth(1);
    gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // Some shaders write an alpha that means nothing; whoever composes the window must not see it.
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
}

void Renderer::Passes::drawSurfaces(const RenderFrame& frame) {
    const bool wireframe = frame.shader == QLatin1String("Wireframe");
    const ShaderProgram& program = wireframe ? shaders.plainSurface() : shaders.surface(*gl, frame.shader);
    program.use(*gl);
    program.set(*gl, Uniform::ViewProjection, frame.viewProjection);
    program.set(*gl, Uniform::CameraPosition, frame.cameraPosition);
    program.set(*gl, Uniform::LightPosition, frame.lightPosition);
    program.set(*gl, Uniform::LightIntensity, frame.lightIntensity);
    program.set(*gl, Uniform::NormalScaling, 2.0F);
    program.set(*gl, Uniform::HeightScaling, 0.1F);
    drawColliders(program, frame);
    if (wireframe)
        return;
    program.set(*gl, Uniform::Model, QMatrix4x4());
    program.set(*gl, Uniform::Color, frame.color);
    m_sheet.drawSurface(*gl);
}

void Renderer::Passes::drawColliders(const ShaderProgram& program, const RenderFrame& frame) {
    program.set(*gl, Uniform::Color, kPlaneColor);
    for (const PlaneShape& plane : frame.planes) {
        if (plane.normal.isNull())
            continue;
        program.set(*gl, Uniform::Model, planeModel(plane));
        m_plane.draw(*gl);
    }
    program.set(*gl, Uniform::Color, kColliderColor);
    for (const SphereShape& sphere : frame.spheres) {
        if (!(sphere.radius > 0))
            continue;
        program.set(*gl, Uniform::Model, sphereModel(sphere));
        m_sphere.draw(*gl);
    }
}

void Renderer::Passes::drawGround(const RenderFrame& frame) {
    if (!frame.groundGrid || !(frame.gridOpacity > 0))
        return;
    const ShaderProgram& program = shaders.ground();
    program.use(*gl);
    program.set(*gl, Uniform::ViewProjection, frame.viewProjection);
    program.set(*gl, Uniform::CameraPosition, frame.cameraPosition);
    program.set(*gl, Uniform::Radius, 4 * frame.cameraPosition.length() + 2);
    program.set(*gl, Uniform::Width, frame.devicePixelRatio);
    program.set(*gl, Uniform::Color, faded(kGridColor, frame.gridOpacity));
    gl->glDepthMask(GL_FALSE);
    // A plane at y = 0 is where the grid is, too.
    gl->glEnable(GL_POLYGON_OFFSET_FILL);
    gl->glPolygonOffset(-1, -4);
    m_highlightPoints.bind(*gl); // any vertex array: the square is made of vertex numbers
    gl->glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl->glDisable(GL_POLYGON_OFFSET_FILL);
    gl->glDepthMask(GL_TRUE);
}

void Renderer::Passes::setView(const ShaderProgram& program, const QMatrix4x4& viewProjection, QSize pixels) {
    program.set(*gl, Uniform::ViewProjection, viewProjection);
    program.set(*gl, Uniform::Viewport,
                QVector2D(static_cast<float>(pixels.width()), static_cast<float>(pixels.height())));
    program.set(*gl, Uniform::PixelSize, pixelSize(viewProjection, pixels));
    program.set(*gl, Uniform::DepthSlope, depthSlope(viewProjection));
}

// The thin ones last, so that their smooth edges blend with what lies under them.
void Renderer::Passes::drawSprings(const RenderFrame& frame) {
    if (frame.shader != QLatin1String("Wireframe") && !frame.springsOverSurface)
        return;
    const ShaderProgram& program = shaders.springs(*gl);
    program.use(*gl);
    setView(program, frame.viewProjection, m_pixels);
    program.set(*gl, Uniform::Model, QMatrix4x4());
    program.set(*gl, Uniform::CameraPosition, frame.cameraPosition);
    program.set(*gl, Uniform::LightPosition, frame.lightPosition);
    program.set(*gl, Uniform::LightIntensity, frame.lightIntensity);
    for (const SpringType type : {SpringType::Bending, SpringType::Shearing, SpringType::Structural}) {
        const auto i = static_cast<std::size_t>(type);
        if (!frame.springsDrawn[i])
            continue;
        program.set(*gl, Uniform::Color, toVector(frame.springColors[i]));
        program.set(*gl, Uniform::Width, kSpringWidth[i] * frame.devicePixelRatio);
        program.set(*gl, Uniform::MaxFill, kSpringMaxFill[i]);
        program.set(*gl, Uniform::DepthBias, kSpringNearer[i] * frame.devicePixelRatio);
        m_sheet.drawSprings(*gl, type);
    }
}

// Draws what is in front, then faintly what is behind something: two sets of pixels that don't overlap.
template <typename Draw>
void Renderer::Passes::drawOnTop(const ShaderProgram& program, const QVector4D& color, Draw draw) {
    gl->glDepthMask(GL_FALSE);
    program.set(*gl, Uniform::Color, color);
    draw();
    gl->glDepthFunc(GL_GREATER);
    program.set(*gl, Uniform::Color, faded(color, kGhostAlpha));
    draw();
    gl->glDepthFunc(GL_LEQUAL);
    gl->glDepthMask(GL_TRUE);
}

void Renderer::Passes::drawHighlight(const RenderFrame& frame) {
    const QVector4D color = toVector(frame.highlightColor);
    if (const auto& segments = frame.highlight.segments; !segments.empty()) {
        const ShaderProgram& program = shaders.lines();
        program.use(*gl);
        setView(program, frame.viewProjection, m_pixels);
        program.set(*gl, Uniform::Width, kHighlightWidth * frame.devicePixelRatio);
        program.set(*gl, Uniform::MaxFill, 0.0F);
        program.set(*gl, Uniform::DepthBias, kOnTop * frame.devicePixelRatio);
        m_highlightLines.upload(*gl, std::span(segments.front().data(), 2 * segments.size()));
        drawOnTop(program, color, [this] { m_highlightLines.draw(*gl, GL_LINES); });
    }
    if (const auto& points = frame.highlight.points; !points.empty()) {
        const ShaderProgram& program = shaders.dots();
        program.use(*gl);
        setView(program, frame.viewProjection, m_pixels);
        program.set(*gl, Uniform::Radius, kDotRadius * frame.devicePixelRatio);
        program.set(*gl, Uniform::DepthBias, kOnTop * frame.devicePixelRatio);
        m_highlightPoints.upload(*gl, std::span(points));
        drawOnTop(program, color, [this] { m_highlightPoints.draw(*gl, GL_POINTS); });
    }
}

void Renderer::Passes::drawPinned(const RenderFrame& frame) {
    if (!m_sheet.hasPinned())
        return;
    const ShaderProgram& program = shaders.dots();
    program.use(*gl);
    setView(program, frame.viewProjection, m_pixels);
    program.set(*gl, Uniform::Radius, kPinnedRadius * frame.devicePixelRatio);
    program.set(*gl, Uniform::DepthBias, kOnTop * frame.devicePixelRatio);
    drawOnTop(program, toVector(frame.pinnedColor), [this] { m_sheet.drawPinned(*gl); });
}

void Renderer::Passes::drawAxes(const RenderFrame& frame) {
    gl->glDisable(GL_DEPTH_TEST);
    if (!frame.axes)
        return;
    const float radius = kGizmoRadius * frame.devicePixelRatio;
    QMatrix4x4 corner; // pixels from the gizmo's middle to clip space
    const auto width = static_cast<float>(m_pixels.width());
    const auto height = static_cast<float>(m_pixels.height());
    const float middle = 1.35F * radius;
    corner.ortho(-middle, width - middle, -middle, height - middle, -1, 1);

    const ShaderProgram& program = shaders.lines();
    program.use(*gl);
    setView(program, corner, m_pixels);
    program.set(*gl, Uniform::Width, 2 * frame.devicePixelRatio);
    program.set(*gl, Uniform::MaxFill, 0.0F);
    program.set(*gl, Uniform::DepthBias, 0.0F);
    makeAxesGizmo(frame.viewProjection, frame.devicePixelRatio, m_axes);
    for (const GizmoAxis& axis : m_axes) {
        program.set(*gl, Uniform::Color, axis.color);
        m_axesLines.upload(*gl, std::span(axis.lines));
        m_axesLines.draw(*gl, GL_LINES);
    }
}

Renderer::Renderer() : m_passes(std::make_unique<Passes>()) {}

Renderer::~Renderer() = default;

bool Renderer::initialize(QString* error) {
    return m_passes->initialize(error);
}

bool Renderer::isInitialized() const {
    return m_passes->gl != nullptr;
}

void Renderer::release() {
    m_passes->release();
}

void Renderer::setShaderDirectory(const QString& directory) {
    m_passes->shaders.setDirectory(directory);
}

void Renderer::reloadShaders() {
    m_passes->shaders.reload();
}

void Renderer::render(const RenderFrame& frame, QSize pixels) {
    if (isInitialized() && !pixels.isEmpty())
        m_passes->render(frame, pixels);
}

const QStringList& Renderer::messages() const {
    return m_passes->shaders.messages();
}

} // namespace clothlab::render
