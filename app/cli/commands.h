// The commands without a window.
#pragma once

#include <QStringList>

namespace clothlab::cli {

QString helpText();

// True if the arguments (without the program's name) name one of the commands below.
bool isCommand(const QStringList& arguments);

// True if that command needs a QGuiApplication, and so a display.
bool drawsPictures(const QStringList& arguments);

// Runs it and returns the exit status of the program. Needs a QCoreApplication, no display but for pictures.
int runCommand(const QStringList& arguments);

} // namespace clothlab::cli
