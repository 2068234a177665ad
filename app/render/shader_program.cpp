#include "app/render/shader_program.h"

#include "app/render/shader_log.h"

#include <vector>

namespace clothlab::render {
namespace {

constexpr std::array<const char*, static_cast<std::size_t>(Uniform::Count)> kUniformNames{
    "u_model",           "u_view_projection", "u_color",          "u_cam_pos",  "u_light_pos",
    "u_light_intensity", "u_normal_scaling",  "u_height_scaling", "u_viewport", "u_pixel_size",
    "u_depth_slope",     "u_depth_bias",      "u_width",          "u_max_fill", "u_radius",
};

GLuint compileStage(Gl& gl, const ShaderStage& stage, QStringList& messages) {
    const GLuint shader = gl.glCreateShader(stage.type);
    const char* text = stage.source.constData();
    const auto length = static_cast<GLint>(stage.source.size());
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
    const QStringList readable = readableShaderLog(stage.file, QString::fromUtf8(log.constData()));
    messages +=
        readable.isEmpty() ? QStringList(stage.file + QStringLiteral(": does not compile")) : readable;
    gl.glDeleteShader(shader);
    return 0;
}

QString linkFailure(Gl& gl, GLuint program, std::span<const ShaderStage> stages) {
    GLint logLength = 0;
    gl.glGetProgramiv(program, GL_INFO_LOG_LENGTH, &logLength);
    QByteArray log(std::max(logLength, 1), '\0');
    gl.glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    QStringList files;
    for (const ShaderStage& stage : stages)
        files.append(stage.file);
    return QStringLiteral("%1: do not link: %2")
        .arg(files.join(QStringLiteral(" + ")), QString::fromUtf8(log.constData()).trimmed());
}

} // namespace

bool ShaderProgram::build(Gl& gl, std::span<const ShaderStage> stages, QStringList& messages) {
    std::vector<GLuint> shaders;
    bool good = true;
    for (const ShaderStage& stage : stages) {
        shaders.push_back(compileStage(gl, stage, messages));
        good = good && shaders.back() != 0;
    }
    GLuint program = 0;
    if (good) {
        program = gl.glCreateProgram();
        for (const GLuint shader : shaders)
            gl.glAttachShader(program, shader);
        gl.glBindAttribLocation(program, kPosition, "in_position");
        gl.glBindAttribLocation(program, kNormal, "in_normal");
        gl.glBindAttribLocation(program, kTangent, "in_tangent");
        gl.glBindAttribLocation(program, kUv, "in_uv");
        gl.glLinkProgram(program);
        GLint linked = GL_FALSE;
        gl.glGetProgramiv(program, GL_LINK_STATUS, &linked);
        good = linked == GL_TRUE;
        if (!good)
            messages.append(linkFailure(gl, program, stages));
    }
    for (const GLuint shader : shaders)
        gl.glDeleteShader(shader); // a program keeps what is attached to it
    if (!good) {
        gl.glDeleteProgram(program);
        return false;
    }
    destroy(gl);
    m_id = program;
    for (std::size_t i = 0; i < kUniformNames.size(); ++i)
        m_locations[i] = gl.glGetUniformLocation(program, kUniformNames[i]);
    return true;
}

void ShaderProgram::destroy(Gl& gl) {
    gl.glDeleteProgram(m_id);
    m_id = 0;
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

} // namespace clothlab::render
