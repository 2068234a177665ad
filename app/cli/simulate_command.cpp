#include "app/cli/simulate_command.h"

#include "app/cli/arguments.h"
#include "app/cli/run_control.h"
#include "app/cli/run_report.h"
#include "app/cli/simulate_outputs.h"
#include "simcore/base/whole_file.h"
#include "simcore/inspect/blow_up_text.h"
#include "simcore/inspect/stability.h"
#include "simcore/scene/parameters.h"
#include "simcore/scene/scene_io.h"

#include <QElapsedTimer>

#include <cstdio>
#include <vector>

namespace clothlab::cli {
namespace {

struct Options {
    QString scene;
    int frames = 90;
    std::optional<int> framesPerSecond, stepsPerFrame, threads;
    FrameWriters writers;
    QString report;
};

// What is wrong with the arguments; empty if nothing is.
QString parse(const QStringList& arguments, Options& options) {
    QCommandLineParser parser;
    parser.addPositionalArgument("scene", {});
    for (const char* name : {"frames", "fps", "steps", "threads", "report"})
        parser.addOption({name, {}, "value"});
    addOutputOptions(parser);
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
          readInteger(parser, "threads", 1, 1024, options.threads), readOutputs(parser, options.writers)})
        if (!error.isEmpty())
            return error;
    options.frames = *frames;
    options.report = parser.value("report");
    if (parser.isSet("report") && options.report.isEmpty())
        return "--report takes a file, or - for the terminal";
    return {};
}

// Calls it with every writer. Returns the first trouble, in words; empty if there is none.
template <typename Call>
QString forEachWriter(const FrameWriters& writers, Call call) {
    QString first;
    for (const auto& writer : writers)
        if (const auto trouble = call(*writer); trouble && first.isEmpty())
            first = QString::fromStdString(*trouble);
    return first;
}

struct Run {
    RunSummary summary;
    FramePointer last;
    QString outputError;
};

// Frame after frame, until the last, a blow-up, an interruption or a file that cannot be written.
void simulateFrames(VerletSolver& solver, const Options& options, const std::atomic<bool>& stop, Run& run) {
    const double frameTime = 1.0 / solver.scene().simulation.framesPerSecond;
    ClothState state = run.last->state;
    for (int number = 0;; ++number) {
        showProgress(number, options.frames);
        run.outputError =
            forEachWriter(options.writers, [&](FrameWriter& writer) { return writer.add(run.last); });
        if (number == options.frames || !run.outputError.isEmpty())
            return;
        QElapsedTimer timer;
        timer.start();
        const FrameResult result = runFrame(solver, state, stop);
        const double seconds = double(timer.nsecsElapsed()) * 1e-9;
        run.summary.seconds += seconds;
        if (!result.finished) {
            if (result.blowUp)
                run.summary.blowUp = RunBlowUp{*result.blowUp, number + 1, result.blowUpStep};
            run.summary.interrupted = !result.blowUp;
            return;
        }
        run.summary.frames = number + 1;
        run.summary.strainLimitCorrections += result.strainLimitCorrections;
        run.last = std::make_shared<const Frame>(Frame{state, run.last->scene, (number + 1) * frameTime,
                                                       result.strainLimitCorrections, 1000 * seconds});
    }
}

// However the frames end, what can be written of them is: a file for all frames holds the good ones.
Run simulate(VerletSolver& solver, const Options& options, const std::atomic<bool>& stop) {
    Run run;
    run.summary.threads = solver.threads();
    run.last = std::make_shared<const Frame>(
        Frame{solver.start(), std::make_shared<const Scene>(solver.scene()), 0, 0, 0});
    run.outputError = forEachWriter(options.writers, [&](FrameWriter& writer) {
        return writer.begin(solver.sheet(), options.frames + 1);
    });
    if (!run.outputError.isEmpty())
        return run;
    simulateFrames(solver, options, stop, run);
    const QString error = forEachWriter(options.writers, [](FrameWriter& writer) { return writer.finish(); });
    if (run.outputError.isEmpty())
        run.outputError = error;
    return run;
}

QString writeReport(const QString& path, const std::string& text) {
    if (path == "-") {
        std::fputs(text.c_str(), stdout);
        return std::fflush(stdout) == 0 ? QString() : QStringLiteral("the report could not be written");
    }
    const auto error = writeFileWhole(path.toStdString(), [&](std::ostream& out) { out << text; });
    return error ? path + ": " + QString::fromStdString(*error) : QString();
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

    const std::atomic<bool>& stop = stopOnInterrupt();
    SolverSettings solverSettings;
    solverSettings.threads = options.threads.value_or(0);
    VerletSolver solver(*reading.scene, solverSettings);
    const Run run = simulate(solver, options, stop);

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
