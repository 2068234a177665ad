// Finds shader files, and keeps the programs made of them.
#pragma once

#include "app/render/shader_program.h"

#include <QString>
#include <QStringList>

namespace clothlab::render {

// NAME.frag is linked with NAME.vert of the same directory if there is one, else with Default.vert there,
// else with the Default.vert that is part of the program. Wireframe.frag is linked with the internal line
// shaders, which provide the same varyings. A shader that can't be read, compiled or linked says so in
// messages(), and what was last good stays: for surfaces the shader drawn before, else a plain internal one.
class ShaderLibrary {
public:
    void setDirectory(const QString& directory);

    // Reads the files again the next time they are needed.
    void reload();

    // Builds the internal programs. False, with the reason, if one does not build: then nothing can be drawn.
    bool initialize(Gl& gl, QString* error);
    void destroy(Gl& gl);

    // Always valid after initialize().
    const ShaderProgram& surface(Gl& gl, const QString& name);
    const ShaderProgram& springs(Gl& gl);
    const ShaderProgram& plainSurface() const { return m_plainSurface; }
    const ShaderProgram& lines() const { return m_lines; }
    const ShaderProgram& dots() const { return m_dots; }
    const ShaderProgram& ground() const { return m_ground; }

    // What is wrong with the shaders in use; empty if nothing is.
    const QStringList& messages() const { return m_messages; }

private:
    void gatherMessages();

    QString m_directory;

    // The name that was last tried, and the last program that came out well.
    QString m_surfaceName;
    ShaderProgram m_surface;
    QStringList m_surfaceMessages;

    bool m_springsTried = false;
    ShaderProgram m_springs;
    QStringList m_springsMessages;

    ShaderProgram m_plainSurface;
    ShaderProgram m_lines;
    ShaderProgram m_dots;
    ShaderProgram m_ground;
    QStringList m_messages;
};

} // namespace clothlab::render
