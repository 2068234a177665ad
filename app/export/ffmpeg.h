// What is asked of the program ffmpeg, which makes videos: where it is, what it can, with which arguments.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>

#include <optional>

namespace clothlab {

enum class VideoFormat { Mp4, WebM };

// Its whole path, of the folders in PATH; empty if it is not there.
QString findFfmpeg();

// What to do where it is not there, in words.
QString howToGetFfmpeg();

struct VideoSettings {
    VideoFormat format = VideoFormat::Mp4;
    QSize size; // pixels; both even, as the colours of video have half the pixels
    double framesPerSecond = 30;
};

// Takes an odd width or height one pixel smaller.
QSize evenSize(QSize size);

// Of the encoders in what `ffmpeg -encoders` prints, the one to use; nothing if none will do.
// MP4: H.264, or MPEG-4 Part 2 where no encoder for that is there. WebM: VP9, or VP8.
std::optional<QString> chooseEncoder(VideoFormat format, const QString& printed);
QStringList encodersFor(VideoFormat format); // from the best one on

// Frames come through standard input, four bytes a pixel: red, green, blue and one that does not count. The
// file may be there and is written over. Colours are those of BT.709, which players take for granted.
QStringList videoArguments(const VideoSettings& settings, const QString& encoder, const QString& file);

} // namespace clothlab
