#include "app/render/shadow_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace clothlab::render {
namespace {

constexpr GLsizei kSide = 2048; // texels
constexpr float kWidest = 130;  // degrees

} // namespace

void Bounds::add(const QVector3D& point) {
    const bool first = isEmpty();
    for (int axis = 0; axis < 3; ++axis) {
        lower[axis] = first ? point[axis] : std::min(lower[axis], point[axis]);
        upper[axis] = first ? point[axis] : std::max(upper[axis], point[axis]);
    }
}

QMatrix4x4 lightViewProjection(const QVector3D& light, const Bounds& bounds) {
    QMatrix4x4 view;
    const QVector3D towards = bounds.centre() - light;
    const float distance = towards.length();
    const float radius = 1.01F * bounds.radius();
    if (bounds.isEmpty() || !(radius > 0) || !(distance > 1e-4F) || !std::isfinite(distance + radius))
        return view;
    const float half = distance > radius ? std::asin(radius / distance) : std::numbers::pi_v<float> / 2;
    const float degrees = std::min(2 * half * 180 / std::numbers::pi_v<float>, kWidest);
    const float nearest = std::max(distance - radius, 0.02F * radius);
    view.perspective(degrees, 1, nearest, distance + radius);
    const bool steep = std::abs(towards.y()) > 0.99F * distance;
    view.lookAt(light, bounds.centre(), steep ? QVector3D(0, 0, 1) : QVector3D(0, 1, 0));
    return view;
}

void ShadowMap::create(Gl& gl) {
    gl.glGenTextures(1, &m_texture);
    gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSide, kSide, 0, GL_DEPTH_COMPONENT,
                    GL_UNSIGNED_INT, nullptr);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    // Beyond the map nothing is in the light's way.
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    const std::array<GLfloat, 4> farthest{1, 1, 1, 1};
    gl.glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest.data());

    gl.glGenFramebuffers(1, &m_framebuffer);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_texture, 0);
    gl.glDrawBuffer(GL_NONE);
    gl.glReadBuffer(GL_NONE);
}

void ShadowMap::begin(Gl& gl) {
    gl.glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_outer);
    gl.glGetIntegerv(GL_VIEWPORT, m_outerViewport.data());
    if (m_texture == 0)
        create(gl);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    gl.glViewport(0, 0, kSide, kSide);
    gl.glClear(GL_DEPTH_BUFFER_BIT);
    // Depths a little farther than they are, or surfaces would shade themselves.
    gl.glEnable(GL_POLYGON_OFFSET_FILL);
    gl.glPolygonOffset(2, 4);
}

void ShadowMap::end(Gl& gl) {
    gl.glDisable(GL_POLYGON_OFFSET_FILL);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(m_outer));
    gl.glViewport(m_outerViewport[0], m_outerViewport[1], m_outerViewport[2], m_outerViewport[3]);
}

GLuint ShadowMap::texture(Gl& gl) {
    if (m_texture == 0) {
        begin(gl);
        end(gl);
    }
    return m_texture;
}

void ShadowMap::destroy(Gl& gl) {
    gl.glDeleteFramebuffers(1, &m_framebuffer);
    gl.glDeleteTextures(1, &m_texture);
    *this = ShadowMap();
}

} // namespace clothlab::render
