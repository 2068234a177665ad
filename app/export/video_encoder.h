// The child process that makes a video of raw pictures.
#pragma once

#include "app/export/ffmpeg.h"

#include <QByteArray>
#include <QImage>

#include <atomic>
#include <memory>
#include <string>

class QProcess;

namespace clothlab {

// All in one thread, which has an event dispatcher (that of a QThread). Functions return what went wrong, in
// words, with the last lines that ffmpeg said; after trouble only kill() is of use. While they wait they look
// at `stop`, and once it is true return that they were stopped.
class VideoEncoder {
public:
    explicit VideoEncoder(const std::atomic<bool>& stop);
    ~VideoEncoder(); // kill()
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;

    // file: written over.
    std::optional<std::string> start(const VideoSettings& settings, const QString& file);
    std::optional<std::string> add(const QImage& image); // of the size of the settings
    std::optional<std::string> finish();                 // the file is complete then
    void kill();

private:
    std::optional<std::string> askForEncoder(const QString& program, VideoFormat format, QString& encoder);
    std::optional<std::string> failure();
    void takeErrors();
    bool isRunning() const;

    const std::atomic<bool>& m_stop;
    std::unique_ptr<QProcess> m_process;
    QByteArray m_errors; // the last of them
};

} // namespace clothlab
