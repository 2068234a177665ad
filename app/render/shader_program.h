// A linked GL program with the uniforms this renderer knows.
#pragma once

#include "app/render/gl_functions.h"
#include "app/render/user_uniforms.h"

#include <QByteArray>
#include <QMatrix4x4>
#include <QVector2D>
#include <QVector3D>
#include <QVector4D>

#include <array>
#include <span>

namespace clothlab::render {

// Where the vertex attributes are, in every program. Strain is signed, of the spring at the point that is
// strained most; rest is where the point is when its springs have their rest lengths.
enum Attribute : GLuint { kPosition, kNormal, kTangent, kUv, kStrain, kRest };

enum class Uniform {
    Model,
    ViewProjection,
    Color,
    CameraPosition,
    LightPosition,
    LightIntensity,
    NormalScaling,
    HeightScaling,
    Texture1, // and the next three, in order
    Texture2,
    Texture3,
    Texture4,
    Texture1Size,
    Texture2Size,
    Texture3Size,
    Texture4Size,
    TextureCubemap,
    // Beyond the course's:
    CubemapLevels,
    Irradiance,
    BackColor,
    TwoSided,
    Time,
    ShadowMap,
    ShadowMatrix,
    ShadowStrength,
    StrainRange,
    StrainColors,
    ByStrain,
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

// Holds GL objects of one context. Nothing is freed by the destructor, which may run without a context.
class ShaderProgram {
public:
    // Compiles and links. On failure the program stays what it was before, and `problems` gets what the
    // driver said. On success it gets which uniforms cannot be set here.
    bool build(Gl& gl, std::span<const ShaderStage> stages, Problems& problems);
    void destroy(Gl& gl);
    bool isValid() const { return m_id != 0; }

    void use(Gl& gl) const { gl.glUseProgram(m_id); }
    bool has(Uniform uniform) const { return location(uniform) >= 0; }
    const std::vector<UserUniform>& userUniforms() const { return m_userUniforms; }

    // For the program in use. What the shader does not declare is not set.
    void set(Gl& gl, Uniform uniform, int value) const; // bools and texture units, too
    void set(Gl& gl, Uniform uniform, float value) const;
    void set(Gl& gl, Uniform uniform, const QVector2D& value) const;
    void set(Gl& gl, Uniform uniform, const QVector3D& value) const;
    void set(Gl& gl, Uniform uniform, const QVector4D& value) const;
    void set(Gl& gl, Uniform uniform, const QMatrix4x4& value) const;
    void set(Gl& gl, Uniform uniform, std::span<const QVector3D> values) const; // an array
    void set(Gl& gl, const UserUniform& uniform, const std::array<float, 4>& numbers) const;

private:
    GLint location(Uniform uniform) const { return m_locations[static_cast<std::size_t>(uniform)]; }

    GLuint m_id = 0;
    std::array<GLint, static_cast<std::size_t>(Uniform::Count)> m_locations{};
    std::vector<UserUniform> m_userUniforms;
};

} // namespace clothlab::render
