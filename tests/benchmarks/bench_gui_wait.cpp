// How long events wait for the GUI thread while a 200 × 200 sheet runs, how long Pause takes to act, and how
// long they wait while a video of that is exported, where there is a display and ffmpeg.
//
//   bench_gui_wait [seconds]
//
// A thread posts an event to the GUI thread every millisecond, whether or not the one before was handled, and
// each is timed from its posting to its handling. Without a display the window is an invisible one, with
// panels and bars but no picture of the cloth.
#include "app/viewport/viewport.h"
#include "app/window/export_controller.h"
#include "app/window/main_window.h"
#include "simcore/scene/scene_io.h"

#include <QApplication>
#include <QEventLoop>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <thread>
#include <vector>

using namespace clothlab;
using Clock = std::chrono::steady_clock;

namespace {

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

Scene sheetOf200By200() {
    Scene scene;
    scene.cloth.numWidthPoints = 200;
    scene.cloth.numHeightPoints = 200;
    scene.cloth.thickness = 0.002; // twice that is less than the grid's 5 mm
    scene.cloth.pinned = {{0, 0}, {199, 0}};
    return scene;
}

// Waits of all events, in ms, ascending; until done() says so, which is asked now and then, or the time is
// over.
std::vector<double> measureWaits(int seconds, const std::function<bool()>& done = {}) {
    std::vector<double> waits;
    std::atomic<bool> stop{false};
    QObject receiver;
    std::thread poster([&] {
        while (!stop) {
            const auto posted = Clock::now();
            QMetaObject::invokeMethod(
                &receiver, [&waits, posted] { waits.push_back(millisecondsSince(posted)); },
                Qt::QueuedConnection);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    QEventLoop loop;
    QTimer::singleShot(1000 * seconds, &loop, &QEventLoop::quit);
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (done && done())
            loop.quit();
    });
    look.start(20);
    loop.exec();
    stop = true;
    poster.join();
    QCoreApplication::processEvents();
    std::ranges::sort(waits);
    return waits;
}

void print(const char* what, const std::vector<double>& waits) {
    const auto at = [&](double share) { return waits[std::size_t(share * double(waits.size() - 1))]; };
    std::printf("%s: %zu events; longest wait %.1f ms, 99.9 %% within %.1f ms, 99 %% within %.1f ms, "
                "half within %.2f ms\n",
                what, waits.size(), waits.back(), at(0.999), at(0.99), at(0.5));
}

void measureExport(MainWindow& window, const QString& path) {
    if (!window.viewport().hasPicture() || findFfmpeg().isEmpty())
        return;
    ExportRequest request;
    request.kind = ExportKind::Mp4;
    request.path = path;
    request.frames = {0, window.simulation().recording().lastFrame(), 1};
    window.exports().showDialog();
    measureWaits(1);
    const auto begin = Clock::now();
    window.exports().begin(request);
    const double blocked = millisecondsSince(begin);
    constexpr int most = 600; // s
    const auto waits = measureWaits(most, [&] { return !window.exports().isRunning(); });
    print("exporting MP4", waits);
    std::printf("%d frames of %d x %d in %.1f s; to begin it took the GUI thread %.1f ms\n",
                request.frames.count(), request.size.width(), request.size.height(),
                millisecondsSince(begin) / 1000, blocked);
}

int measure(int seconds) {
    const QTemporaryDir folder;
    MainWindow window(std::make_unique<QSettings>(folder.filePath("settings.ini"), QSettings::IniFormat));
    window.show();
    const QString path = folder.filePath("scene.json");
    if (saveScene(sheetOf200By200(), path.toStdString()) || hasErrors(window.document().open(path)) ||
        !QTest::qWaitForWindowExposed(&window))
        return 1;
    Simulation& simulation = window.simulation();
    print("idle", measureWaits(2));

    simulation.play();
    const std::vector<double> waits = measureWaits(seconds);
    const int frames = simulation.recording().lastFrame();
    print("200 x 200 running", waits);
    std::printf("frames recorded: %d, %.0f ms each to compute\n", frames,
                simulation.shownFrame()->milliseconds);

    const bool underWay = simulation.isSimulating();
    const auto begin = Clock::now();
    simulation.pause();
    const double took = millisecondsSince(begin);
    const int recorded = simulation.recording().frameCount();
    measureWaits(2);
    std::printf("pause %s: %.3f ms; frames recorded after it: %d\n",
                underWay ? "in the middle of a frame" : "between two frames", took,
                simulation.recording().frameCount() - recorded);
    measureExport(window, folder.filePath("run.mp4"));
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM") && !qEnvironmentVariableIsSet("DISPLAY") &&
        !qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QSurfaceFormat format; // as the program asks for
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(4);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    return measure(argc > 1 ? std::max(1, std::atoi(argv[1])) : 10);
}
