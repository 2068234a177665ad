// A framebuffer with several samples a pixel, drawn to in the place of another one.
#pragma once

#include "app/render/gl_functions.h"

#include <QSize>

namespace clothlab::render {

// Holds GL objects of one context; nothing is freed by the destructor, which may run without a context.
class MultisampleTarget {
public:
    // Binds a framebuffer of that size with as many samples as the machine has, `samples` at most; with 1
    // leaves the bound one, into which end() brings the picture otherwise.
    void begin(Gl& gl, QSize size, int samples);
    void end(Gl& gl);
    void destroy(Gl& gl);

private:
    void resize(Gl& gl, QSize size, int samples);

    QSize m_size;
    int m_samples = 0;
    GLuint m_framebuffer = 0;
    GLuint m_color = 0;
    GLuint m_depth = 0;
    GLint m_outer = 0;
    bool m_active = false;
};

} // namespace clothlab::render
