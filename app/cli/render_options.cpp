#include "app/cli/render_options.h"

#include "app/cli/arguments.h"
#include "app/document/data_files.h"
#include "app/render/shader_library.h"

#include <QDir>

namespace clothlab::cli {
namespace {

QString readOutput(const QCommandLineParser& parser, RenderOptions& options) {
    options.output = parser.value("output");
    const auto endsIn = [&](const char* ending) {
        return options.output.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
    };
    if (endsIn(".mp4"))
        options.video = VideoFormat::Mp4;
    else if (endsIn(".webm"))
        options.video = VideoFormat::WebM;
    else if (!endsIn(".png"))
        return "--output takes the name of a .png, .mp4 or .webm file";
    const auto path = OutputPath::parse(options.output);
    if (!path)
        return QStringLiteral("--output %1: at most one %d or %04d, and %% for a percent sign")
            .arg(options.output);
    if (options.video && path->isSequence())
        return QStringLiteral("--output %1: a video holds all frames; leave out %d or %04d")
            .arg(options.output);
    options.path = *path;
    return {};
}

QString readFrames(const QCommandLineParser& parser, RenderOptions& options) {
    if (options.isOnePicture()) {
        for (const char* name : {"frames", "fps"})
            if (parser.isSet(name))
                return QStringLiteral("--%1 is for many frames: name the output frame_%04d.png or clip.mp4, "
                                      "or choose one with --frame")
                    .arg(name);
    } else if (parser.isSet("frame")) {
        return "--frame is for one picture; a sequence or a video takes --frames";
    }
    std::optional<int> frame = options.frame;
    std::optional<int> frames = options.frames;
    for (const QString& error : {readInteger(parser, "frame", 0, 100'000'000, frame),
                                 readInteger(parser, "frames", 0, 100'000'000, frames),
                                 readInteger(parser, "fps", 1, 1000, options.framesPerSecond)})
        if (!error.isEmpty())
            return error;
    options.frame = *frame;
    options.frames = *frames;
    return {};
}

QString readShader(const QCommandLineParser& parser, RenderOptions& options) {
    options.source = {dataDirectory("shaders"), dataDirectory("textures")};
    if (parser.isSet("shader-dir"))
        options.source.shaderDirectory = parser.value("shader-dir");
    const QString& directory = options.source.shaderDirectory;
    if (directory.isEmpty() || !QDir(directory).exists())
        return QStringLiteral("--shader-dir: there is no folder '%1'").arg(directory);
    options.shader = parser.value("shader");
    const QStringList shaders = render::listShaders(directory);
    if (parser.isSet("shader") && options.shader != kAllShaders && !shaders.contains(options.shader))
        return QStringLiteral("--shader: there is no '%1' in %2; there are %3, and all")
            .arg(options.shader, directory, shaders.join(", "));
    if (options.shader == kAllShaders && !options.isOnePicture())
        return "--shader all makes one picture; choose one shader for a sequence or a video";
    return {};
}

QString readPictureSize(const QCommandLineParser& parser, RenderOptions& options) {
    if (!parser.isSet("size"))
        return {};
    const std::optional<QSize> size = readSize(parser.value("size"));
    if (!size)
        return QStringLiteral("--size takes WIDTHxHEIGHT in pixels, not '%1'").arg(parser.value("size"));
    if (options.video && *size != evenSize(*size))
        return QStringLiteral("--size: a video has an even width and an even height, unlike '%1'")
            .arg(parser.value("size"));
    options.size = *size;
    return {};
}

} // namespace

QString parseRender(const QStringList& arguments, RenderOptions& options) {
    QCommandLineParser parser;
    parser.addPositionalArgument("scene", {});
    for (const char* name : {"frame", "frames", "fps", "shader", "size", "output", "shader-dir", "threads"})
        parser.addOption({name, {}, "value"});
    parser.addOption(QCommandLineOption("fit"));
    if (!parser.parse(QStringList{"clothlab"} + arguments))
        return parser.errorText();
    if (parser.positionalArguments().size() != 1)
        return "render takes one scene: clothlab render SCENE --output FILE.png [OPTIONS]";
    options.scene = parser.positionalArguments().constFirst();
    options.fit = parser.isSet("fit");
    if (QString error = readOutput(parser, options); !error.isEmpty())
        return error;
    if (QString error = readFrames(parser, options); !error.isEmpty())
        return error;
    if (QString error = readInteger(parser, "threads", 1, 1024, options.threads); !error.isEmpty())
        return error;
    if (QString error = readPictureSize(parser, options); !error.isEmpty())
        return error;
    return readShader(parser, options);
}

} // namespace clothlab::cli
