#include "app/render/shader_inputs.h"

#include <array>

namespace clothlab::render {
namespace {

// Of the texture directory.
const std::array<QString, kTextureCount> kTextureFiles{
    QStringLiteral("texture_1.png"), QStringLiteral("texture_2.png"), QStringLiteral("texture_3.png"),
    QStringLiteral("texture_4.png")};
const QString kCubemapFolder = QStringLiteral("cubemap");

// Texture units. OpenGL 3.3 has at least 16 of them.
constexpr int kCubemapUnit = 4;
constexpr int kFirstUserUnit = 6;
static_assert(kFirstUserUnit + kMostUserSamplers <= 16);

Uniform nth(Uniform first, std::size_t index) {
    return static_cast<Uniform>(static_cast<std::size_t>(first) + index);
}

} // namespace

void bindTexture(Gl& gl, int unit, GLenum target, GLuint texture) {
    gl.glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.glBindTexture(target, texture);
    gl.glActiveTexture(GL_TEXTURE0);
}

void setTextures(Gl& gl, const SurfaceLook& look, const ShaderProgram& program, TextureStore& textures) {
    for (std::size_t i = 0; i < kTextureCount; ++i) {
        if (!program.has(nth(Uniform::Texture1, i)) && !program.has(nth(Uniform::Texture1Size, i)))
            continue;
        const QString& chosen = look.textures[i];
        const Texture& texture = textures.texture(gl, chosen.isEmpty() ? kTextureFiles[i] : chosen, false);
        const int unit = static_cast<int>(i);
        bindTexture(gl, unit, GL_TEXTURE_2D, texture.id);
        program.set(gl, nth(Uniform::Texture1, i), unit);
        program.set(
            gl, nth(Uniform::Texture1Size, i),
            QVector2D(static_cast<float>(texture.size.width()), static_cast<float>(texture.size.height())));
    }
    if (program.has(Uniform::TextureCubemap) || program.has(Uniform::Irradiance)) {
        const QString& chosen = look.cubemap;
        const Cubemap& cubemap = textures.cubemap(gl, chosen.isEmpty() ? kCubemapFolder : chosen);
        gl.glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        bindTexture(gl, kCubemapUnit, GL_TEXTURE_CUBE_MAP, cubemap.id);
        program.set(gl, Uniform::TextureCubemap, kCubemapUnit);
        program.set(gl, Uniform::CubemapLevels, static_cast<float>(cubemap.levels));
        program.set(gl, Uniform::Irradiance, cubemap.irradiance);
    }
}

void setUserUniforms(Gl& gl, const SurfaceLook& look, const QString& shader, const ShaderProgram& program,
                     TextureStore& textures) {
    static const UniformSettings none;
    const auto found = look.uniforms.find(shader);
    const UniformSettings& settings = found != look.uniforms.end() ? found->second : none;
    int unit = kFirstUserUnit;
    for (const UserUniform& uniform : program.userUniforms()) {
        const auto set = settings.find(uniform.spec.name);
        const bool fits = set != settings.end() && set->second.components == uniform.spec.initial.components;
        const UniformSetting& setting = fits ? set->second : uniform.spec.initial;
        if (uniform.spec.type != UniformSpec::Type::Sampler2D) {
            program.set(gl, uniform, setting.numbers);
            continue;
        }
        const QString file = setting.file.isEmpty() ? kTextureFiles[0] : setting.file;
        bindTexture(gl, unit, GL_TEXTURE_2D, textures.texture(gl, file, uniform.spec.srgb).id);
        program.set(gl, uniform, {static_cast<float>(unit)});
        ++unit;
    }
}

} // namespace clothlab::render
