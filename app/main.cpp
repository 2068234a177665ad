#include "app/cli/commands.h"
#include "app/cli/exit_status.h"
#include "app/window/run_window.h"

#include <QApplication>
#include <QSurfaceFormat>

#include <cstdio>
#include <cstdlib>

namespace {

QStringList argumentsOf(int argc, char** argv) {
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    return arguments;
}

constexpr const char* kNoWindow = "clothlab simulate needs none, and QT_QPA_PLATFORM=offscreen opens an "
                                  "invisible window; see clothlab --help";

constexpr const char* kNoServer =
    "an X server does, also one without a screen: xvfb-run -a clothlab render …";

bool hasDisplay() {
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

void setSurfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
}

QtMessageHandler nextHandler = nullptr;
bool draws = false; // a picture, without a window

const char* whatFor() {
    return draws ? "to draw with" : "to open a window on";
}

const char* whatDoes() {
    return draws ? kNoServer : kNoWindow;
}

// When a display cannot be opened, Qt says so as a fatal message and would end the program with a signal.
void noDisplayIsWrongUsage(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if (type != QtFatalMsg)
        return nextHandler(type, context, message);
    std::fprintf(stderr, "clothlab: no display %s (%s); %s\n", whatFor(),
                 qPrintable(message.section('\n', 0, 0)), whatDoes());
    std::_Exit(clothlab::cli::WrongUsage);
}

int usageError(const char* message) {
    std::fprintf(stderr, "clothlab: %s; see clothlab --help\n", message);
    return clothlab::cli::WrongUsage;
}

} // namespace

int main(int argc, char** argv) {
    const QStringList given = argumentsOf(argc, argv);
    draws = clothlab::cli::drawsPictures(given);
    if (clothlab::cli::isCommand(given) && !draws) {
        const QCoreApplication application(argc, argv);
        return clothlab::cli::runCommand(QCoreApplication::arguments().mid(1));
    }
#ifdef Q_OS_LINUX
    if (!hasDisplay()) {
        std::fprintf(stderr, "clothlab: no display %s (DISPLAY is not set); %s\n", whatFor(), whatDoes());
        return clothlab::cli::WrongUsage;
    }
#endif
    setSurfaceFormat();
    nextHandler = qInstallMessageHandler(noDisplayIsWrongUsage);
    if (draws) {
        const QGuiApplication application(argc, argv);
        qInstallMessageHandler(nextHandler);
        return clothlab::cli::runCommand(QCoreApplication::arguments().mid(1));
    }
    const QApplication application(argc, argv);
    qInstallMessageHandler(nextHandler);
    QApplication::setApplicationName("ClothLab");
    clothlab::WindowOptions options;
    if (const QString error = clothlab::parseWindowOptions(QApplication::arguments().mid(1), options);
        !error.isEmpty())
        return usageError(qPrintable(error));
    return clothlab::runWindow(options);
}
