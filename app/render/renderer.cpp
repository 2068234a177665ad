#include "app/render/renderer.h"

#include "app/render/marks_pass.h"
#include "app/render/multisample_target.h"
#include "app/render/surface_pass.h"

#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>

namespace clothlab::render {
namespace {

bool canSpeak33(const QOpenGLContext& context) {
    return !context.isOpenGLES() && context.format().version() >= qMakePair(3, 3);
}

// All the state that the passes rely on: a painter may have been here before.
void setState(Gl& gl) {
    gl.glDisable(GL_SCISSOR_TEST);
    gl.glDisable(GL_STENCIL_TEST);
    gl.glDisable(GL_CULL_FACE);
    gl.glDisable(GL_BLEND);
    gl.glDisable(GL_FRAMEBUFFER_SRGB);
    gl.glEnable(GL_MULTISAMPLE);
    gl.glEnable(GL_PROGRAM_POINT_SIZE);
    gl.glEnable(GL_DEPTH_TEST);
    gl.glDepthFunc(GL_LEQUAL);
    gl.glDepthMask(GL_TRUE);
    gl.glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.glClearDepth(1);
}

void clear(Gl& gl, const QColor& background, QSize pixels) {
    gl.glViewport(0, 0, pixels.width(), pixels.height());
    gl.glClearColor(background.redF(), background.greenF(), background.blueF(), 1);
    gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // Some shaders write an alpha that means nothing; whoever composes the window must not see it.
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
}

void leaveState(Gl& gl) {
    gl.glDisable(GL_BLEND);
    gl.glDisable(GL_PROGRAM_POINT_SIZE);
    gl.glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.glUseProgram(0);
    gl.glBindVertexArray(0);
    gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

} // namespace

class Renderer::Passes {
public:
    bool initialize(QString* error);
    void release();
    void render(const RenderFrame& frame, QSize pixels);

    Gl* gl = nullptr; // owned by the context; null when not initialised
    ShaderLibrary shaders;
    TextureStore textures;
    Problems problems;
    QString shaderInUse;
    bool wireframe = false;

private:
    void gatherProblems(const RenderFrame& frame);

    SurfacePass m_surfaces;
    MarksPass m_marks;
    MultisampleTarget m_target;
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
    gl = canSpeak33(*context) ? QOpenGLVersionFunctionsFactory::get<Gl>(context) : nullptr;
    if (!gl || !gl->initializeOpenGLFunctions())
        return fail(QStringLiteral("OpenGL 3.3 core is needed; this context has %1%2.%3.")
                        .arg(context->isOpenGLES() ? QStringLiteral("ES ") : QString())
                        .arg(context->format().majorVersion())
                        .arg(context->format().minorVersion()));
    QString reason;
    if (!shaders.initialize(*gl, &reason))
        return fail(reason);
    textures.forget();
    m_surfaces.initialize(*gl);
    m_marks.initialize(*gl);
    m_target = MultisampleTarget();
    return true;
}

void Renderer::Passes::release() {
    if (!gl)
        return;
    shaders.destroy(*gl);
    textures.destroy(*gl);
    m_surfaces.destroy(*gl);
    m_marks.destroy(*gl);
    m_target.destroy(*gl);
    gl = nullptr;
}

void Renderer::Passes::render(const RenderFrame& frame, QSize pixels) {
    setState(*gl);
    textures.beginFrame(*gl);
    m_surfaces.prepare(*gl, frame, shaders);
    m_target.begin(*gl, pixels, frame.samples);
    clear(*gl, frame.background, pixels);
    m_surfaces.draw(*gl, frame, shaders, textures);
    gl->glEnable(GL_BLEND);
    m_marks.draw(*gl, frame, pixels, shaders, textures, m_surfaces.sheet());
    leaveState(*gl);
    m_target.end(*gl);
    gatherProblems(frame);
    wireframe = isWireframe(frame);
    shaderInUse = wireframe ? frame.surface.shader : shaders.surfaceInUse();
}

// Of what was drawn: a shader that was tried before is nobody's concern now.
void Renderer::Passes::gatherProblems(const RenderFrame& frame) {
    problems.clear();
    if (!isWireframe(frame))
        problems += shaders.surfaceProblems();
    if (isWireframe(frame) || frame.springs.overSurface)
        problems += shaders.springsProblems();
    problems += textures.problems();
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

void Renderer::setTextureDirectory(const QString& directory) {
    m_passes->textures.setDirectory(directory);
}

void Renderer::reloadShaders() {
    m_passes->shaders.reload();
}

void Renderer::reloadFiles() {
    reloadShaders();
    m_passes->textures.reload();
}

void Renderer::render(const RenderFrame& frame, QSize pixels) {
    if (isInitialized() && !pixels.isEmpty())
        m_passes->render(frame, pixels);
}

const Problems& Renderer::problems() const {
    return m_passes->problems;
}

const QString& Renderer::shaderInUse() const {
    return m_passes->shaderInUse;
}

int Renderer::builds() const {
    return m_passes->shaders.builds();
}

std::vector<UniformSpec> Renderer::uniforms() const {
    std::vector<UniformSpec> specs;
    const ShaderLibrary& shaders = m_passes->shaders;
    for (const UserUniform& uniform :
         m_passes->wireframe ? shaders.springUniforms() : shaders.surfaceUniforms())
        specs.push_back(uniform.spec);
    return specs;
}

} // namespace clothlab::render
