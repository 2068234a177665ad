#include "app/cli/simulate_command.h"

#include "app/cli/arguments.h"
#include "app/cli/output_path.h"
#include "app/cli/run_report.h"
#include "simcore/base/file.h"
#include "simcore/export/export.h"
#include "simcore/inspect/blow_up_text.h"
#include "simcore/inspect/stability.h"
#include "simcore/scene/parameters.h"
#include "simcore/scene/scene_io.h"

#include <QElapsedTimer>

#include <csignal>
#include <cstdio>
#include <unistd.h>
#include <vector>

namespace clothlab::cli {
namespace {

std::atomic<bool> stopRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "written by a signal handler");

struct Output {
    OutputPath path;
    ExportFormat format;
};

struct Options {
    QString scene;
    int frames = 90;
    std::optional<int> framesPerSecond, stepsPerFrame, threads;
    std::vector<Output> outputs;
    QString report;
};

QString readOutputs(const QStringList& names, std::vector<Output>& outputs) {
    for (const QString& file : names) {
        const auto format = exportFormat(file.toStdString());
        const auto path = OutputPath::parse(file);
        if (!format)
            return QStringLiteral("--output %1: files end in .obj or .csv").arg(file);
        if (!path)
            return QStringLiteral("--output %1: at most one %d or %04d, and %% for a percent sign").arg(file);
        outputs.push_back({*path, *format});
    }
    return {};
}

// What is wrong with the arguments; empty if nothing is.
QString parse(const QStringList& arguments, Options& options) {
    QCommandLineParser parser;
    parser.addPositionalArgument("scene", {});
    for (const char* name : {"frames", "fps", "steps", "threads", "output", "report"})
        parser.addOption({name, {}, "value"});
    if (!parser.parse(QStringList{"clothlab"} + arguments))
        return parser.errorText();
    if (parser.positionalArguments().size() != 1)
        return "simulate takes one scene: clothlab simulate SCENE [OPTIONS]";
    options.scene = parser.positionalArguments().constFirst();

    const auto range = [](const char* id) { return *findParameter(id); };
    const Parameter fps = range("simulation.frames_per_second");
    const Parameter steps = range("simulation.steps_per_frame");
    std::optional<int> frames = options.frames;
    for (const QString& error :
         {readInteger(parser, "frames", 0, 100'000'000, frames),
          readInteger(parser, "fps", int(fps.minimum), int(fps.maximum), options.framesPerSecond),
          readInteger(parser, "steps", int(steps.minimum), int(steps.maximum), options.stepsPerFrame),
          readInteger(parser, "threads", 1, 1024, options.threads),
          readOutputs(parser.values("output"), options.outputs)})
        if (!error.isEmpty())
            return error;
    options.frames = *frames;
    options.report = parser.value("report");
    if (parser.isSet("report") && options.report.isEmpty())
        return "--report takes a file, or - for the terminal";
    return {};
}

void showProgress(int frame, int frames) {
    static const bool onTerminal = isatty(STDERR_FILENO) != 0;
    if (!onTerminal)
        return;
    constexpr int width = 40;
    const int done = frames > 0 ? int(std::int64_t(frame) * width / frames) : width;
    std::fprintf(stderr, "\r[%.*s%.*s] frame %d / %d%s", done, "########################################",
                 width - done, "                                        ", frame, frames,
                 frame == frames ? "\n" : "");
}

// What went wrong; empty if nothing did.
QString writeOutputs(const std::vector<Output>& outputs, const Frame& frame, int number, bool last) {
    for (const Output& output : outputs) {
        if (!output.path.isSequence() && !last)
            continue;
        const QString path = output.path.forFrame(number);
        if (const auto error = exportFrame(frame, output.format, path.toStdString()))
            return QString::fromStdString(*error);
    }
    return {};
}

struct Run {
    RunSummary summary;
    FramePointer last;
    QString outputError;
};

Run simulate(VerletSolver& solver, const Options& options) {
    const auto scene = std::make_shared<const Scene>(solver.scene());
    const double frameTime = 1.0 / scene->simulation.framesPerSecond;
    Run run;
    run.summary.threads = solver.threads();
    ClothState state = solver.start();
    run.last = std::make_shared<const Frame>(Frame{state, scene, 0, 0, 0});
    for (int number = 0;; ++number) {
        showProgress(number, options.frames);
        const bool atEnd = number == options.frames;
        FrameResult result;
        if (!atEnd) {
            QElapsedTimer timer;
            timer.start();
            result = runFrame(solver, state, stopRequested);
            run.summary.seconds += double(timer.nsecsElapsed()) * 1e-9;
        }
        run.outputError = writeOutputs(options.outputs, *run.last, number, !result.finished);
        if (!result.finished || !run.outputError.isEmpty()) {
            if (result.blowUp)
                run.summary.blowUp = RunBlowUp{*result.blowUp, number + 1, result.blowUpStep};
            run.summary.interrupted = !atEnd && !result.blowUp && !result.finished;
            return run;
        }
        run.summary.frames = number + 1;
        run.summary.strainLimitCorrections += result.strainLimitCorrections;
        run.last = std::make_shared<const Frame>(
            Frame{state, scene, (number + 1) * frameTime, result.strainLimitCorrections, 0});
    }
}

QString writeReport(const QString& path, const std::string& text) {
    if (path == "-") {
        std::fputs(text.c_str(), stdout);
        return std::fflush(stdout) == 0 ? QString() : QStringLiteral("the report could not be written");
    }
    const auto error = writeFileWhole(path.toStdString(), [&](std::ostream& out) { out << text; });
    return error ? QString::fromStdString(*error) : QString();
}

} // namespace

int simulateCommand(const QStringList& arguments) {
    Options options;
    if (const QString error = parse(arguments, options); !error.isEmpty())
        return fail(WrongUsage, error + "; see clothlab --help");
    SceneReading reading = loadScene(options.scene.toStdString());
    if (reading.scene) {
        SimulationSettings& settings = reading.scene->simulation;
        settings.framesPerSecond = options.framesPerSecond.value_or(settings.framesPerSecond);
        settings.stepsPerFrame = options.stepsPerFrame.value_or(settings.stepsPerFrame);
        warnOfStep(*reading.scene, reading.diagnostics); // of the step that will be taken
    }
    for (const Diagnostic& diagnostic : reading.diagnostics)
        std::fprintf(stderr, "%s\n", toText(diagnostic, options.scene.toStdString()).c_str());
    if (!reading.scene)
        return InvalidInput;

    stopRequested = false;
    std::signal(SIGINT, [](int) { stopRequested = true; });
    std::signal(SIGTERM, [](int) { stopRequested = true; });
    SolverSettings solverSettings;
    solverSettings.threads = options.threads.value_or(0);
    VerletSolver solver(*reading.scene, solverSettings);
    const Run run = simulate(solver, options);

    if (!options.report.isEmpty())
        if (const QString error =
                writeReport(options.report, reportText(run.summary, solver.sheet(), *run.last));
            !error.isEmpty())
            return fail(OutputNotWritten, error);
    if (!run.outputError.isEmpty())
        return fail(OutputNotWritten, run.outputError);
    if (const auto& blowUp = run.summary.blowUp)
        return fail(SimulationBlewUp, QString::fromStdString(describeBlowUp(blowUp->blowUp, blowUp->step,
                                                                            blowUp->frame, solver.scene())));
    if (run.summary.interrupted)
        return fail(Interrupted, QStringLiteral("interrupted after %1 frames").arg(run.summary.frames));
    return Done;
}

} // namespace clothlab::cli
