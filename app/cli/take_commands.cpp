#include "app/cli/take_commands.h"

#include "app/cli/arguments.h"
#include "app/cli/take_info_text.h"
#include "simcore/inspect/verify_takes.h"

#include <cstdio>

namespace clothlab::cli {
namespace {

// Reads it, and says what is wrong with it.
TakeFileReading read(const QString& path) {
    TakeFileReading reading = readTakeFile(path.toStdString());
    for (const Diagnostic& diagnostic : reading.diagnostics)
        std::fprintf(stderr, "%s\n", toText(diagnostic, path.toStdString()).c_str());
    return reading;
}

} // namespace

int infoCommand(const QStringList& arguments) {
    if (arguments.size() != 1 || arguments[0].startsWith('-'))
        return fail(WrongUsage,
                    "info takes one recording: clothlab info FILE.clothtake; see clothlab --help");
    const TakeFileReading reading = read(arguments[0]);
    if (!reading.contents)
        return InvalidInput;
    std::fputs(takeInfoText(reading).c_str(), stdout);
    return reading.diagnostics.empty() ? Done : CheckFoundWarnings;
}

int verifyCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.addPositionalArgument("recording", {});
    parser.addOption({"threads", {}, "value"});
    std::optional<int> threads;
    if (!parser.parse(QStringList{"clothlab"} + arguments))
        return fail(WrongUsage, parser.errorText() + "; see clothlab --help");
    if (parser.positionalArguments().size() != 1)
        return fail(WrongUsage,
                    "verify takes one recording: clothlab verify FILE.clothtake; see clothlab --help");
    if (const QString error = readInteger(parser, "threads", 1, 1024, threads); !error.isEmpty())
        return fail(WrongUsage, error + "; see clothlab --help");

    const QString path = parser.positionalArguments().constFirst();
    const TakeFileReading reading = read(path);
    if (!reading.contents)
        return InvalidInput;
    SolverSettings settings;
    settings.threads = threads.value_or(0);
    const std::atomic<bool> never{false};
    const Verification result = verifyTakes(*reading.contents, settings, never);
    for (const TakeDifference& difference : result.differences) {
        const TakeInfo& info = findTake(*reading.contents, difference.take)->info;
        std::fprintf(stderr, "%s: frame %d of take %u '%s': %s\n", qPrintable(path), difference.frame,
                     info.id, info.name.c_str(), difference.what.c_str());
    }
    if (!result.differences.empty())
        return RecordingDiffers;
    std::printf("%s: %lld frames, all as they are run again\n", qPrintable(path),
                static_cast<long long>(result.frames));
    return reading.diagnostics.empty() ? Done : CheckFoundWarnings;
}

} // namespace clothlab::cli
