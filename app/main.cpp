#include "app/cli/commands.h"
#include "app/cli/exit_status.h"
#include "app/window/run_window.h"

#include <QApplication>
#include <QSurfaceFormat>

#include <cstdio>

namespace {

QStringList argumentsOf(int argc, char** argv) {
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    return arguments;
}

// Without a display Qt would end the program with a signal.
bool hasDisplay() {
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

void setSurfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(4);
    QSurfaceFormat::setDefaultFormat(format);
}

int usageError(const char* message) {
    std::fprintf(stderr, "clothlab: %s; see clothlab --help\n", message);
    return clothlab::cli::WrongUsage;
}

} // namespace

int main(int argc, char** argv) {
    if (clothlab::cli::isCommand(argumentsOf(argc, argv))) {
        const QCoreApplication application(argc, argv);
        return clothlab::cli::runCommand(QCoreApplication::arguments().mid(1));
    }
#ifdef Q_OS_LINUX
    if (!hasDisplay())
        return usageError(
            "no display to open a window on (DISPLAY is not set); clothlab simulate needs none, and "
            "QT_QPA_PLATFORM=offscreen opens an invisible window");
#endif
    setSurfaceFormat();
    const QApplication application(argc, argv);
    QApplication::setApplicationName("ClothLab");
    clothlab::WindowOptions options;
    if (const QString error = clothlab::parseWindowOptions(QApplication::arguments().mid(1), options);
        !error.isEmpty())
        return usageError(qPrintable(error));
    return clothlab::runWindow(options);
}
