#pragma once

#include <QStringList>

namespace clothlab::cli {

// clothlab render: arguments after the command's name. Needs a QGuiApplication on a platform with OpenGL.
// Returns the exit status.
int renderCommand(const QStringList& arguments);

} // namespace clothlab::cli
