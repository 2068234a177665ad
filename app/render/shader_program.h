// A linked GL program with the uniforms this renderer knows.
#pragma once

#include "app/render/gl_functions.h"

#include <QByteArray>
#include <QMatrix4x4>
#include <QStringList>
#include <QVector2D>
#include <QVector3D>
#include <QVector4D>

#include <array>
#include <span>

namespace clothlab::render {

// Where the vertex attributes are, in every program.
enum Attribute : GLuint { kPosition, kNormal, kTangent, kUv };

enum class Uniform {
    Model,
    ViewProjection,
    Color,
    CameraPosition,
    LightPosition,
    LightIntensity,
    NormalScaling,
    HeightScaling,
    // Of the internal shaders only:
    Viewport,
    PixelSize,
    DepthSlope,
    DepthBias,
    Width,
    MaxFill,
    Radius,
    Count
};

struct ShaderStage {
    GLenum type;
    QString file; // as named in messages
    QByteArray source;
};

// Holds GL objects of one context. Nothing is freed by the destructor, which may run without a context.
class ShaderProgram {
public:
    // Compiles and links. On failure the program stays what it was before, and `messages` gets what the
    // driver said.
    bool build(Gl& gl, std::span<const ShaderStage> stages, QStringList& messages);
    void destroy(Gl& gl);
    bool isValid() const { return m_id != 0; }

    void use(Gl& gl) const { gl.glUseProgram(m_id); }

    // For the program in use. What the shader does not declare is not set.
    void set(Gl& gl, Uniform uniform, float value) const;
    void set(Gl& gl, Uniform uniform, const QVector2D& value) const;
    void set(Gl& gl, Uniform uniform, const QVector3D& value) const;
    void set(Gl& gl, Uniform uniform, const QVector4D& value) const;
    void set(Gl& gl, Uniform uniform, const QMatrix4x4& value) const;

private:
    GLint location(Uniform uniform) const { return m_locations[static_cast<std::size_t>(uniform)]; }

    GLuint m_id = 0;
    std::array<GLint, static_cast<std::size_t>(Uniform::Count)> m_locations{};
};

} // namespace clothlab::render
