// The commands about recordings.
#pragma once

#include <QStringList>

namespace clothlab::cli {

// clothlab verify, clothlab info: arguments after the command's name. Return the exit status.
int verifyCommand(const QStringList& arguments);
int infoCommand(const QStringList& arguments);

} // namespace clothlab::cli
