#pragma once

#include <QStringList>

namespace clothlab::cli {

// clothlab simulate: arguments after the command's name. Returns the exit status.
int simulateCommand(const QStringList& arguments);

} // namespace clothlab::cli
