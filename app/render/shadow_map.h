// What the main light sees first.
#pragma once

#include "app/render/gl_functions.h"

#include <QMatrix4x4>
#include <QVector3D>

#include <array>

namespace clothlab::render {

// A box that holds what casts shadows.
struct Bounds {
    QVector3D lower{1, 1, 1};
    QVector3D upper{-1, -1, -1}; // below `lower`: empty

    bool isEmpty() const { return lower.x() > upper.x(); }
    void add(const QVector3D& point);
    QVector3D centre() const { return 0.5F * (lower + upper); }
    float radius() const { return 0.5F * (upper - lower).length(); }
};

// The light's view of the box, as tight as a perspective around its sphere can be; from inside that sphere it
// is as wide as is of use. The identity where either has no size.
QMatrix4x4 lightViewProjection(const QVector3D& light, const Bounds& bounds);

// A depth texture that compares. Holds GL objects of one context; nothing is freed by the destructor.
class ShadowMap {
public:
    // Between the two, what is drawn casts shadows; end() goes back to the framebuffer and the viewport of
    // before.
    void begin(Gl& gl);
    void end(Gl& gl);
    void destroy(Gl& gl);
    GLuint texture(Gl& gl); // made, with nothing in the light's way, when first needed

private:
    void create(Gl& gl);

    GLuint m_texture = 0;
    GLuint m_framebuffer = 0;
    GLint m_outer = 0;
    std::array<GLint, 4> m_outerViewport{};
};

} // namespace clothlab::render
