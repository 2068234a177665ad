#include "app/render/multisample_target.h"

#include <algorithm>

namespace clothlab::render {

void MultisampleTarget::begin(Gl& gl, QSize size, int samples) {
    GLint most = 1;
    gl.glGetIntegerv(GL_MAX_SAMPLES, &most);
    samples = std::min(samples, static_cast<int>(most));
    // A framebuffer that has samples itself can't be brought a picture of another number of them.
    GLint outerSamples = 0;
    gl.glGetIntegerv(GL_SAMPLES, &outerSamples);
    m_active = false;
    if (samples <= 1 || outerSamples > 1)
        return;
    gl.glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_outer);
    if (size != m_size || samples != m_samples)
        resize(gl, size, samples);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_active = gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (!m_active)
        gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_outer));
}

void MultisampleTarget::resize(Gl& gl, QSize size, int samples) {
    destroy(gl);
    m_size = size;
    m_samples = samples;
    gl.glGenRenderbuffers(1, &m_color);
    gl.glBindRenderbuffer(GL_RENDERBUFFER, m_color);
    gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, size.width(), size.height());
    gl.glGenRenderbuffers(1, &m_depth);
    gl.glBindRenderbuffer(GL_RENDERBUFFER, m_depth);
    gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, size.width(),
                                        size.height());
    gl.glBindRenderbuffer(GL_RENDERBUFFER, 0);
    gl.glGenFramebuffers(1, &m_framebuffer);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_color);
    gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth);
}

void MultisampleTarget::end(Gl& gl) {
    if (!m_active)
        return;
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_outer));
    gl.glBlitFramebuffer(0, 0, m_size.width(), m_size.height(), 0, 0, m_size.width(), m_size.height(),
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_outer));
    m_active = false;
}

void MultisampleTarget::destroy(Gl& gl) {
    gl.glDeleteFramebuffers(1, &m_framebuffer);
    gl.glDeleteRenderbuffers(1, &m_color);
    gl.glDeleteRenderbuffers(1, &m_depth);
    const GLint outer = m_outer;
    *this = MultisampleTarget();
    m_outer = outer;
}

} // namespace clothlab::render
