#include "tests/support/video.h"

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>

namespace clothlab::test {
namespace {

QByteArray outputOf(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    constexpr int milliseconds = 60'000;
    if (!process.waitForFinished(milliseconds) || process.exitCode() != 0)
        qWarning("%s: %s", qPrintable(program), process.readAllStandardError().constData());
    return process.readAllStandardOutput();
}

} // namespace

bool hasFfmpeg() {
    return !QStandardPaths::findExecutable("ffmpeg").isEmpty() &&
           !QStandardPaths::findExecutable("ffprobe").isEmpty();
}

Video probe(const QString& path) {
    const QByteArray text = outputOf("ffprobe", {"-v", "error", "-count_frames", "-show_streams",
                                                 "-show_format", "-print_format", "json", path});
    const auto json = nlohmann::json::parse(text.toStdString(), nullptr, false);
    if (!json.is_object() || json.value("streams", nlohmann::json::array()).size() != 1)
        return {};
    const auto& stream = json["streams"][0];
    const auto word = [&](const char* key) {
        return QString::fromStdString(stream.value(key, std::string()));
    };
    Video video;
    video.codec = word("codec_name");
    video.pixelFormat = word("pix_fmt");
    video.size = {stream.value("width", 0), stream.value("height", 0)};
    video.frames = word("nb_read_frames").toInt();
    const QString rate = word("r_frame_rate");
    video.framesPerSecond = rate.section('/', 0, 0).toDouble() / rate.section('/', 1).toDouble();
    video.seconds = QString::fromStdString(json["format"].value("duration", std::string())).toDouble();
    return video;
}

QByteArray middlePixels(const QString& path, QSize size) {
    const QString crop = QStringLiteral("crop=2:2:%1:%2").arg(size.width() / 2).arg(size.height() / 2);
    const QByteArray all =
        outputOf("ffmpeg", {"-v", "error", "-i", path, "-vf", crop + ",format=rgb24", "-f", "rawvideo", "-"});
    QByteArray pixels;
    constexpr int bytes = 2 * 2 * 3; // a frame
    for (qsizetype at = 0; at + bytes <= all.size(); at += bytes)
        pixels += all.mid(at, 3);
    return pixels;
}

FakeFfmpeg::FakeFfmpeg(const QString& folder, const QByteArray& script) : m_path(qgetenv("PATH")) {
    QDir(folder).mkpath(".");
    const QString program = folder + "/ffmpeg";
    QFile::remove(program);
    QFile file(program);
    if (!script.isEmpty()) {
        if (!file.open(QIODevice::WriteOnly) || file.write("#!/bin/sh\nPATH=/usr/bin:/bin\n" + script) < 0)
            qFatal("%s could not be written", qPrintable(program));
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }
    qputenv("PATH", folder.toLocal8Bit());
}

FakeFfmpeg::~FakeFfmpeg() {
    qputenv("PATH", m_path);
}

} // namespace clothlab::test
