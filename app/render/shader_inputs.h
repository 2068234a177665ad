// What a shader gets from files and from its user.
#pragma once

#include "app/render/render_frame.h"
#include "app/render/shader_program.h"
#include "app/render/texture_store.h"

namespace clothlab::render {

// A texture unit that the functions below leave alone.
inline constexpr int kShadowUnit = 5;

void bindTexture(Gl& gl, int unit, GLenum target, GLuint texture);

// All for the program in use, which must be `program`.

// The course's four textures, their sizes, and the cube map with what is computed from it.
void setTextures(Gl& gl, const SurfaceLook& look, const ShaderProgram& program, TextureStore& textures);

// Every uniform of the user's own: what it is set to for the shader of that name, else its default. A setting
// of another number of components is passed over.
void setUserUniforms(Gl& gl, const SurfaceLook& look, const QString& shader, const ShaderProgram& program,
                     TextureStore& textures);

} // namespace clothlab::render
