#include "app/window/run_window.h"

#include "app/cli/arguments.h"
#include "app/window/file_controller.h"
#include "app/window/main_window.h"
#include "app/window/message_bar.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QScreen>
#include <QStandardPaths>
#include <QStyle>
#include <QTemporaryDir>
#include <QTimer>

#include <cstdio>

namespace clothlab {

QString parseWindowOptions(const QStringList& arguments, WindowOptions& options) {
    QCommandLineParser parser;
    parser.addPositionalArgument("scene", {});
    for (const char* name : {"screenshot", "frames", "theme", "size", "shader-dir"})
        parser.addOption({name, {}, "value"});
    if (!parser.parse(QStringList{"clothlab"} + arguments))
        return parser.errorText();
    if (parser.positionalArguments().size() > 1)
        return QStringLiteral("one scene at a time, not %1").arg(parser.positionalArguments().join(' '));
    options.scene = parser.positionalArguments().value(0);
    options.screenshot = parser.value("screenshot");
    if (parser.isSet("screenshot") && options.screenshot.isEmpty())
        return "--screenshot takes the name of a PNG file";
    if (parser.isSet("frames")) {
        bool ok = false;
        options.frames = parser.value("frames").toInt(&ok);
        if (!ok || options.frames < 0)
            return QStringLiteral("--frames takes a whole number from 0, not '%1'")
                .arg(parser.value("frames"));
    }
    options.theme = parser.value("theme");
    if (parser.isSet("theme") && options.theme != "dark" && options.theme != "light")
        return QStringLiteral("--theme takes dark or light, not '%1'").arg(options.theme);
    if (parser.isSet("size")) {
        options.size = cli::readSize(parser.value("size"));
        if (!options.size)
            return QStringLiteral("--size takes WIDTHxHEIGHT in pixels, not '%1'").arg(parser.value("size"));
    }
    options.shaderDirectory = parser.value("shader-dir");
    // An empty name would be the folder that the program was started in.
    if (parser.isSet("shader-dir") &&
        (options.shaderDirectory.isEmpty() || !QDir(options.shaderDirectory).exists()))
        return QStringLiteral("--shader-dir: there is no folder '%1'").arg(options.shaderDirectory);
    return {};
}

namespace {

// Plays frames, saves a picture and quits.
class ScreenshotRun : public QObject {
public:
    ScreenshotRun(MainWindow& window, const WindowOptions& options) : m_window(window), m_options(options) {
        connect(&window.simulation(), &Simulation::frameShown, this, &ScreenshotRun::next);
        connect(&window.simulation(), &Simulation::blowUpChanged, this, [this] { finish(); });
        QMetaObject::invokeMethod(
            this, [this] { next(); }, Qt::QueuedConnection);
    }

private:
    void next() {
        Simulation& simulation = m_window.simulation();
        if (simulation.currentFrame() < m_options.frames)
            simulation.simulateFrame();
        if (!simulation.isSimulating()) // all are there, or the recording is full
            finish();
    }

    void finish() {
        disconnect(&m_window.simulation(), nullptr, this, nullptr);
        // The timeline shows what is packed, and then the window has to be painted.
        m_window.simulation().whenPacked([this] { QTimer::singleShot(200, this, &ScreenshotRun::save); });
    }

    void save() {
        if (const auto error = m_window.savePicture(m_options.screenshot))
            exit(cli::OutputNotWritten, *error);
        else if (const QString blowUp = m_window.simulation().blowUp(); !blowUp.isEmpty())
            exit(cli::SimulationBlewUp, blowUp);
        else
            QApplication::exit(cli::Done);
    }

    static void exit(cli::ExitStatus status, const QString& words) {
        std::fprintf(stderr, "clothlab: %s\n", qPrintable(words));
        QApplication::exit(status);
    }

    MainWindow& m_window;
    const WindowOptions& m_options;
};

// With the frame that the system puts around it.
void fitToScreen(QWidget& window) {
    const int title = window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
    window.resize(window.size().boundedTo(window.screen()->availableSize() - QSize(title / 2, 2 * title)));
}

} // namespace

int runWindow(const WindowOptions& options) {
    const bool pictureOnly = !options.screenshot.isEmpty();
    // A picture shows the layout as it comes, and leaves the user's own alone.
    const auto temporary = pictureOnly ? std::make_unique<QTemporaryDir>() : nullptr;
    auto settings =
        pictureOnly
            ? std::make_unique<QSettings>(temporary->filePath("settings.ini"), QSettings::IniFormat)
            : std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope, "ClothLab", "ClothLab");
    const QString recovery =
        pictureOnly
            ? QString()
            : QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/ClothLab/recovery";
    MainWindow window(std::move(settings), options.shaderDirectory, recovery);
    if (!options.theme.isEmpty())
        window.setTheme(options.theme == "light" ? Theme::Light : Theme::Dark);
    if (!pictureOnly)
        fitToScreen(window);
    window.show();
    if (options.size)
        window.resize(*options.size);
    if (!options.scene.isEmpty() && !window.files().openUnasked(options.scene) && pictureOnly) {
        std::fprintf(stderr, "clothlab: %s\n", qPrintable(window.messageBar().text()));
        return cli::InvalidInput;
    }
    std::unique_ptr<ScreenshotRun> run;
    if (pictureOnly)
        run = std::make_unique<ScreenshotRun>(window, options);
    return QApplication::exec();
}

} // namespace clothlab
