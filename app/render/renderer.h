// Draws a RenderFrame with OpenGL 3.3 core.
#pragma once

#include "app/render/render_frame.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <memory>

namespace clothlab::render {

// Names of the surface shaders in `directory` (NAME.frag, not in subfolders), sorted, with Wireframe first if
// there is one. Empty if there is no such directory.
QStringList listShaders(const QString& directory);

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

    // Reads the shader files again at the next render(): they were edited. No context needed.
    void reloadShaders();

    // Draws the whole picture, background included, into the framebuffer that is bound, which must have a
    // depth buffer; `pixels` is its size. Does nothing for an empty size. Alpha is 1 everywhere. What a frame
    // can't be drawn of (a sheet whose positions don't fit its size, spheres without a radius, pinned indices
    // out of range) is left out. Afterwards program, vertex array and buffers are unbound; depth test and
    // blending are off.
    void render(const RenderFrame& frame, QSize pixels);

    // What is wrong with the shaders in use, as `file:line: reason` where the driver names a line; empty if
    // nothing is. A broken shader is drawn with what was good before it. Changes only in render().
    const QStringList& messages() const;

private:
    class Passes;
    std::unique_ptr<Passes> m_passes;
};

} // namespace clothlab::render
