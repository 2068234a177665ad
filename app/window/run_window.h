// How the window is started from the command line.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace clothlab {

struct WindowOptions {
    QString scene;      // empty: a new one
    QString screenshot; // empty: none
    int frames = 90;    // to play before the screenshot
    QString theme;      // "dark", "light" or empty: as chosen last
    std::optional<QSize> size;
    QString shaderDirectory; // empty: that which comes with the program
};

// What is wrong with the arguments (without the program's name), in words; empty if nothing is.
QString parseWindowOptions(const QStringList& arguments, WindowOptions& options);

// Opens the window and runs the event loop. Needs a QApplication. Returns the exit status.
int runWindow(const WindowOptions& options);

} // namespace clothlab
