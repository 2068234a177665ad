#include "app/export/ffmpeg.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

namespace clothlab {
namespace {

// Qualities at which the eye finds no fault; players take them all.
QStringList settingsOf(const QString& encoder) {
    if (encoder == "libx264")
        return {"-preset", "medium", "-crf", "18"};
    if (encoder == "libopenh264")
        return {"-b:v", "12M"};
    if (encoder == "mpeg4")
        return {"-q:v", "2"};
    if (encoder == "libvpx-vp9")
        return {"-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used", "4", "-row-mt", "1"};
    return {"-crf", "8", "-b:v", "12M", "-deadline", "good", "-cpu-used", "4"}; // libvpx
}

} // namespace

QString findFfmpeg() {
    return QStandardPaths::findExecutable("ffmpeg");
}

QString howToGetFfmpeg() {
    return QCoreApplication::translate("Export", "Video needs ffmpeg: sudo apt install ffmpeg");
}

QSize evenSize(QSize size) {
    return {size.width() & ~1, size.height() & ~1};
}

QStringList encodersFor(VideoFormat format) {
    return format == VideoFormat::Mp4 ? QStringList{"libx264", "libopenh264", "mpeg4"}
                                      : QStringList{"libvpx-vp9", "libvpx"};
}

std::optional<QString> chooseEncoder(VideoFormat format, const QString& printed) {
    for (const QString& encoder : encodersFor(format))
        if (QRegularExpression(R"(^ V\S* )" + QRegularExpression::escape(encoder) + R"(\s)",
                               QRegularExpression::MultilineOption)
                .match(printed)
                .hasMatch())
            return encoder;
    return std::nullopt;
}

QStringList videoArguments(const VideoSettings& settings, const QString& encoder, const QString& file) {
    QStringList arguments{"-hide_banner", "-loglevel", "error", "-nostdin"};
    arguments << "-f"
              << "rawvideo"
              << "-pixel_format"
              << "rgb0"
              << "-video_size"
              << QStringLiteral("%1x%2").arg(settings.size.width()).arg(settings.size.height())
              << "-framerate" << QString::number(settings.framesPerSecond, 'g', 12) << "-i"
              << "pipe:0";
    arguments << "-an"
              << "-c:v" << encoder << settingsOf(encoder);
    arguments << "-vf"
              << "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
              << "-colorspace"
              << "bt709"
              << "-color_primaries"
              << "bt709"
              << "-color_trc"
              << "bt709"
              << "-color_range"
              << "tv";
    if (settings.format == VideoFormat::Mp4)
        arguments << "-movflags"
                  << "+faststart";
    // "file:", so that no name is taken for an option or a protocol.
    arguments << "-f" << (settings.format == VideoFormat::Mp4 ? "mp4" : "webm") << "-y"
              << "file:" + QFileInfo(file).absoluteFilePath();
    return arguments;
}

} // namespace clothlab
