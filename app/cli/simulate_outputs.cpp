#include "app/cli/simulate_outputs.h"

#include "app/cli/arguments.h"
#include "app/cli/output_path.h"

#include "simcore/export/take_writer.h"
#include "simcore/recording/frame_codec.h"

#include <QDir>
#include <QFileInfo>
#include <QSet>

namespace clothlab::cli {
namespace {

struct Output {
    OutputPath path;
    std::optional<ExportFormat> format; // none: a recording
};

bool isRecording(const QString& file) {
    return file.endsWith(".clothtake", Qt::CaseInsensitive);
}

QString readOutput(const QString& file, std::vector<Output>& outputs) {
    const auto format = exportFormat(file.toStdString());
    const auto path = OutputPath::parse(file);
    if (!format && !isRecording(file))
        return QStringLiteral("--output %1: files end in .obj, .ply, .csv, .pc2, .mdd, .glb or .clothtake")
            .arg(file);
    if (!path)
        return QStringLiteral("--output %1: at most one %d or %04d, and %% for a percent sign").arg(file);
    if (path->isSequence() && (!format || holdsAllFrames(*format)))
        return QStringLiteral("--output %1: such a file holds all frames; leave out %d or %04d").arg(file);
    outputs.push_back({*path, format});
    return {};
}

QString readPlacement(const QCommandLineParser& parser, Placement& placement) {
    const QString axis = parser.value("axis");
    if (parser.isSet("axis") && axis != "y" && axis != "z")
        return QStringLiteral("--axis takes y or z, which is up in the files, not '%1'").arg(axis);
    placement.up = axis == "z" ? UpAxis::Z : UpAxis::Y;
    return readNumber(parser, "scale", 1e-6, 1e6, placement.unitsPerMetre);
}

// The same for two names of a file.
QString fileOf(const QString& path) {
    return QDir::cleanPath(QFileInfo(path).absoluteFilePath());
}

FrameWriters makeWriters(const std::vector<Output>& outputs, const Placement& placement, double error) {
    QSet<QString> written;
    for (const Output& output : outputs)
        if (!output.path.isSequence())
            written.insert(fileOf(output.path.forFrame(0)));
    FrameWriters writers;
    for (const Output& output : outputs) {
        if (!output.format) {
            writers.push_back(makeTakeWriter(output.path.forFrame(0).toStdString(), error, CLOTHLAB_VERSION));
            continue;
        }
        if (output.path.isSequence()) {
            const auto pathOf = [path = output.path](int frame) {
                return path.forFrame(frame).toStdString();
            };
            writers.push_back(makeSequenceWriter(*output.format, pathOf, placement));
            continue;
        }
        const std::string path = output.path.forFrame(0).toStdString();
        const QString beside = fileOf(QString::fromStdString(meshBesidePath(path)));
        writers.push_back(makeFrameWriter(*output.format, path, {placement, !written.contains(beside)}));
        if (output.format == ExportFormat::Pc2 || output.format == ExportFormat::Mdd)
            written.insert(beside); // once is enough for two caches
    }
    return writers;
}

} // namespace

void addOutputOptions(QCommandLineParser& parser) {
    for (const char* name : {"output", "axis", "scale", "measures", "error"})
        parser.addOption({name, {}, "value"});
}

QString readOutputs(const QCommandLineParser& parser, FrameWriters& writers) {
    std::vector<Output> outputs;
    for (const QString& file : parser.values("output"))
        if (QString error = readOutput(file, outputs); !error.isEmpty())
            return error;
    Placement placement;
    if (QString error = readPlacement(parser, placement); !error.isEmpty())
        return error;
    double greatestError = kDefaultError;
    if (QString error = readNumber(parser, "error", 0, kGreatestError, greatestError); !error.isEmpty())
        return error;
    writers = makeWriters(outputs, placement, greatestError);
    const QString measures = parser.value("measures");
    if (!parser.isSet("measures"))
        return {};
    if (exportFormat(measures.toStdString()) != ExportFormat::Csv)
        return QStringLiteral("--measures takes a file that ends in .csv, not '%1'").arg(measures);
    for (const Output& output : outputs)
        if (!output.path.isSequence() && fileOf(output.path.forFrame(0)) == fileOf(measures))
            return QStringLiteral("--measures and --output both name %1; give one of them another name")
                .arg(measures);
    writers.push_back(makeMeasuresWriter(measures.toStdString()));
    return {};
}

} // namespace clothlab::cli
