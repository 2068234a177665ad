// Draws a RenderFrame with OpenGL 3.3 core.
#pragma once

#include "app/render/problem.h"
#include "app/render/render_frame.h"

#include <QSize>
#include <QString>

#include <memory>

namespace clothlab::render {

// All GL objects belong to the context that was current in initialize(). The destructor frees none of them,
// because it may run without a context: call release() before, or let the context's end free them.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Needs a current context with OpenGL 3.3 core or newer; else false, with the reason in words in `error`
    // (which may be null), and render() does nothing. May be called again after release(), or on a new
    // context after the old one was lost.
    bool initialize(QString* error);
    bool isInitialized() const;

    // Frees everything, with the context of initialize() current. Does nothing if not initialised.
    void release();

    // Where surface shaders are read from, at the next render(). No context needed.
    void setShaderDirectory(const QString& directory);

    // Where texture_1.png to texture_4.png and the folder cubemap are, and files that are not named with a
    // whole path. No context needed.
    void setTextureDirectory(const QString& directory);

    // Reads shaders, or textures too, again at the next render(): they were edited. No context needed.
    void reloadShaders();
    void reloadFiles();

    // Draws the whole picture, background included, into the framebuffer that is bound, which must have a
    // depth buffer; `pixels` is its size. Does nothing for an empty size. Alpha is 1 everywhere. What a frame
    // can't be drawn of (a sheet whose positions don't fit its size, spheres without a radius, pinned indices
    // out of range) is left out. Afterwards program, vertex array and buffers are unbound; blending is off.
    void render(const RenderFrame& frame, QSize pixels);

    // What is wrong with the files in use; empty if nothing is. A broken shader is drawn with what was good
    // before it, a broken texture as a checker. Changes only in render().
    const Problems& problems() const;

    // The shader that was last drawn, which is another one than asked for while that is broken; empty
    // before the first. And what the user may set of it, in the order of the file.
    const QString& shaderInUse() const;
    std::vector<UniformSpec> uniforms() const;

    // How many times shaders were built so far: when it grows, uniforms() may be others.
    int builds() const;

private:
    class Passes;
    std::unique_ptr<Passes> m_passes;
};

} // namespace clothlab::render
