#include "app/render/shader_program.h"

#include "app/render/shader_log.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace clothlab::render {
namespace {

struct KnownUniform {
    const char* name;
    GLenum type;
};

constexpr std::array<KnownUniform, static_cast<std::size_t>(Uniform::Count)> kUniforms{
    {{"u_model", GL_FLOAT_MAT4},
     {"u_view_projection", GL_FLOAT_MAT4},
     {"u_color", GL_FLOAT_VEC4},
     {"u_cam_pos", GL_FLOAT_VEC3},
     {"u_light_pos", GL_FLOAT_VEC3},
     {"u_light_intensity", GL_FLOAT_VEC3},
     {"u_normal_scaling", GL_FLOAT},
     {"u_height_scaling", GL_FLOAT},
     {"u_texture_1", GL_SAMPLER_2D},
     {"u_texture_2", GL_SAMPLER_2D},
     {"u_texture_3", GL_SAMPLER_2D},
     {"u_texture_4", GL_SAMPLER_2D},
     {"u_texture_1_size", GL_FLOAT_VEC2},
     {"u_texture_2_size", GL_FLOAT_VEC2},
     {"u_texture_3_size", GL_FLOAT_VEC2},
     {"u_texture_4_size", GL_FLOAT_VEC2},
     {"u_texture_cubemap", GL_SAMPLER_CUBE},
     {"u_cubemap_levels", GL_FLOAT},
     {"u_irradiance", GL_FLOAT_VEC3},
     {"u_back_color", GL_FLOAT_VEC4},
     {"u_two_sided", GL_BOOL},
     {"u_time", GL_FLOAT},
     {"u_shadow_map", GL_SAMPLER_2D_SHADOW},
     {"u_shadow_matrix", GL_FLOAT_MAT4},
     {"u_shadow_strength", GL_FLOAT},
     {"u_strain_range", GL_FLOAT},
     {"u_strain_colors", GL_FLOAT_VEC3},
     {"u_by_strain", GL_BOOL},
     {"u_viewport", GL_FLOAT_VEC2},
     {"u_pixel_size", GL_FLOAT},
     {"u_depth_slope", GL_FLOAT_VEC2},
     {"u_depth_bias", GL_FLOAT},
     {"u_width", GL_FLOAT},
     {"u_max_fill", GL_FLOAT},
     {"u_radius", GL_FLOAT}}};

constexpr std::array<const char*, kRest + 1> kAttributeNames{"in_position", "in_normal", "in_tangent",
                                                             "in_uv",       "in_strain", "in_rest"};

// 0 if it is none of ours.
GLenum typeOfOurs(const QByteArray& name) {
    const auto* const known = std::find_if(kUniforms.begin(), kUniforms.end(),
                                           [&](const KnownUniform& each) { return name == each.name; });
    return known == kUniforms.end() ? 0 : known->type;
}

GLuint compileStage(Gl& gl, const ShaderStage& stage, Problems& problems) {
    const GLuint shader = gl.glCreateShader(stage.type);
    const char* text = stage.source.text.constData();
    const auto length = static_cast<GLint>(stage.source.text.size());
    gl.glShaderSource(shader, 1, &text, &length);
    gl.glCompileShader(shader);
    GLint compiled = GL_FALSE;
    gl.glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE)
        return shader;
    GLint logLength = 0;
    gl.glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &logLength);
    QByteArray log(std::max(logLength, 1), '\0');
    gl.glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    const Problems said = readShaderLog(stage.source.files, QString::fromUtf8(log.constData()));
    problems += said.isEmpty()
                    ? Problems{{stage.source.files.constFirst(), 0, QStringLiteral("does not compile")}}
                    : said;
    gl.glDeleteShader(shader);
    return 0;
}

Problem linkFailure(Gl& gl, GLuint program, std::span<const ShaderStage> stages) {
    GLint logLength = 0;
    gl.glGetProgramiv(program, GL_INFO_LOG_LENGTH, &logLength);
    QByteArray log(std::max(logLength, 1), '\0');
    gl.glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    // With the fragment shader's file, which is the one that is being written.
    QString file;
    for (const ShaderStage& stage : stages)
        file = stage.source.files.constFirst();
    return {file, 0,
            QStringLiteral("does not link with its vertex shader: %1")
                .arg(QString::fromUtf8(log.constData()).trimmed().replace(u'\n', QLatin1String("; ")))};
}

} // namespace

bool ShaderProgram::build(Gl& gl, std::span<const ShaderStage> stages, Problems& problems) {
    std::vector<GLuint> shaders;
    bool good = true;
    for (const ShaderStage& stage : stages) {
        shaders.push_back(compileStage(gl, stage, problems));
        good = good && shaders.back() != 0;
    }
    GLuint program = 0;
    if (good) {
        program = gl.glCreateProgram();
        for (const GLuint shader : shaders)
            gl.glAttachShader(program, shader);
        for (std::size_t i = 0; i < kAttributeNames.size(); ++i)
            gl.glBindAttribLocation(program, static_cast<GLuint>(i), kAttributeNames[i]);
        gl.glLinkProgram(program);
        GLint linked = GL_FALSE;
        gl.glGetProgramiv(program, GL_LINK_STATUS, &linked);
        good = linked == GL_TRUE;
        if (!good)
            problems.append(linkFailure(gl, program, stages));
    }
    for (const GLuint shader : shaders)
        gl.glDeleteShader(shader); // a program keeps what is attached to it
    if (!good) {
        gl.glDeleteProgram(program);
        return false;
    }
    destroy(gl);
    m_id = program;
    for (std::size_t i = 0; i < kUniforms.size(); ++i)
        m_locations[i] = gl.glGetUniformLocation(program, kUniforms[i].name);
    ProgramUniforms found = findUniforms(gl, program, stages, typeOfOurs, problems);
    m_userUniforms = std::move(found.ofTheUser);
    for (const GLint location : found.ofAnotherType)
        std::replace(m_locations.begin(), m_locations.end(), location, -1);
    return true;
}

void ShaderProgram::destroy(Gl& gl) {
    gl.glDeleteProgram(m_id);
    *this = ShaderProgram();
}

void ShaderProgram::set(Gl& gl, Uniform uniform, int value) const {
    gl.glUniform1i(location(uniform), value);
}

void ShaderProgram::set(Gl& gl, Uniform uniform, float value) const {
    gl.glUniform1f(location(uniform), value);
}

void ShaderProgram::set(Gl& gl, Uniform uniform, const QVector2D& value) const {
    gl.glUniform2f(location(uniform), value.x(), value.y());
}

void ShaderProgram::set(Gl& gl, Uniform uniform, const QVector3D& value) const {
    gl.glUniform3f(location(uniform), value.x(), value.y(), value.z());
}

void ShaderProgram::set(Gl& gl, Uniform uniform, const QVector4D& value) const {
    gl.glUniform4f(location(uniform), value.x(), value.y(), value.z(), value.w());
}

void ShaderProgram::set(Gl& gl, Uniform uniform, const QMatrix4x4& value) const {
    gl.glUniformMatrix4fv(location(uniform), 1, GL_FALSE, value.constData());
}

void ShaderProgram::set(Gl& gl, Uniform uniform, std::span<const QVector3D> values) const {
    static_assert(sizeof(QVector3D) == 3 * sizeof(float));
    gl.glUniform3fv(location(uniform), static_cast<GLsizei>(values.size()),
                    reinterpret_cast<const GLfloat*>(values.data()));
}

void ShaderProgram::set(Gl& gl, const UserUniform& uniform, const std::array<float, 4>& numbers) const {
    switch (uniform.spec.type) {
    case UniformSpec::Type::Bool:
    case UniformSpec::Type::Int:
    case UniformSpec::Type::Sampler2D: // its texture unit
        gl.glUniform1i(uniform.location, static_cast<GLint>(std::lround(numbers[0])));
        break;
    case UniformSpec::Type::Float:
        gl.glUniform1f(uniform.location, numbers[0]);
        break;
    case UniformSpec::Type::Vec2:
        gl.glUniform2fv(uniform.location, 1, numbers.data());
        break;
    case UniformSpec::Type::Vec3:
        gl.glUniform3fv(uniform.location, 1, numbers.data());
        break;
    case UniformSpec::Type::Vec4:
        gl.glUniform4fv(uniform.location, 1, numbers.data());
        break;
    }
}

} // namespace clothlab::render
