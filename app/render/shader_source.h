// The text of a shader file, with what it includes.
#pragma once

#include "app/render/problem.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>

namespace clothlab::render {

// The lines of the n-th file of a source are counted from n times this: Mesa forgets the number of the file
// in some of its messages, but never the line.
inline constexpr int kLinesPerFile = 1'000'000;

struct ShaderSource {
    QByteArray text;
    QStringList files; // paths; the n-th is what #line directives in the text call source string n
};

// Reads the file, and in the place of each line `#include "NAME"` the file NAME of the same folder, else of
// `builtIn`. Lines keep their files and numbers. What is wrong goes to `problems`; then there is no source.
std::optional<ShaderSource> readShaderSource(const QString& path, const QString& builtIn, Problems& problems);

} // namespace clothlab::render
