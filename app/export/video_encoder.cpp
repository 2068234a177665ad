#include "app/export/video_encoder.h"

#include <QProcess>

#ifdef Q_OS_UNIX
#include <unistd.h>
#endif

namespace clothlab {
namespace {

constexpr int kLook = 50;               // ms between two looks at `stop`
constexpr int kPatience = 20'000;       // ms for ffmpeg to start, and to say what it can
constexpr qsizetype kMostErrors = 4096; // bytes

const std::string kStopped = "stopped";

std::unique_ptr<QProcess> makeProcess() {
    auto process = std::make_unique<QProcess>();
#ifdef Q_OS_UNIX
    process->setChildProcessModifier([] {
        ::setpgid(0, 0); // Ctrl+C on a terminal is for us: we end it
        constexpr int less = 5;
        [[maybe_unused]] const int now = ::nice(less); // the window comes first
    });
#endif
    return process;
}

std::string couldNotStart(const QProcess& process) {
    return "ffmpeg could not be started (" + process.errorString().toStdString() + ")";
}

// The last lines of what it said, in one.
std::string lastLines(const QByteArray& errors) {
    QStringList lines = QString::fromLocal8Bit(errors).split('\n', Qt::SkipEmptyParts);
    constexpr int most = 3;
    lines = lines.mid(std::max<qsizetype>(0, lines.size() - most));
    for (QString& line : lines)
        line = line.trimmed();
    return lines.join(" | ").toStdString();
}

} // namespace

VideoEncoder::VideoEncoder(const std::atomic<bool>& stop) : m_stop(stop) {}

VideoEncoder::~VideoEncoder() {
    kill();
}

bool VideoEncoder::isRunning() const {
    return m_process && m_process->state() != QProcess::NotRunning;
}

std::optional<std::string> VideoEncoder::askForEncoder(const QString& program, VideoFormat format,
                                                       QString& encoder) {
    const auto process = makeProcess();
    process->start(program, {"-hide_banner", "-encoders"}, QIODevice::ReadOnly);
    if (!process->waitForStarted(kPatience))
        return couldNotStart(*process);
    for (int waited = 0; process->state() != QProcess::NotRunning && !process->waitForFinished(kLook);
         waited += kLook)
        if (m_stop || waited > kPatience) {
            process->kill();
            process->waitForFinished();
            return m_stop ? kStopped : "ffmpeg does not say what it can; see whether it works";
        }
    const auto chosen = chooseEncoder(format, QString::fromLocal8Bit(process->readAllStandardOutput()));
    if (!chosen)
        return "this ffmpeg has none of the encoders for it (" +
               encodersFor(format).join(", ").toStdString() +
               "); install that of the system, or choose another format";
    encoder = *chosen;
    return std::nullopt;
}

std::optional<std::string> VideoEncoder::start(const VideoSettings& settings, const QString& file) {
    kill();
    const QString program = findFfmpeg();
    if (program.isEmpty())
        return howToGetFfmpeg().toStdString();
    QString encoder;
    if (auto trouble = askForEncoder(program, settings.format, encoder))
        return trouble;
    m_errors.clear();
    m_process = makeProcess();
    m_process->setStandardOutputFile(QProcess::nullDevice());
    m_process->start(program, videoArguments(settings, encoder, file), QIODevice::ReadWrite);
    if (!m_process->waitForStarted(kPatience))
        return couldNotStart(*m_process);
    return std::nullopt;
}

std::optional<std::string> VideoEncoder::add(const QImage& image) {
    const QImage pixels = image.convertToFormat(QImage::Format_RGBX8888);
    m_process->write(reinterpret_cast<const char*>(pixels.constBits()), pixels.sizeInBytes());
    // No more than one picture waits in memory.
    while (m_process->bytesToWrite() > 0) {
        if (m_stop)
            return kStopped;
        if (!isRunning())
            break;
        m_process->waitForBytesWritten(kLook);
        takeErrors();
    }
    return isRunning() ? std::nullopt : failure();
}

std::optional<std::string> VideoEncoder::finish() {
    m_process->closeWriteChannel();
    while (isRunning() && !m_process->waitForFinished(kLook)) {
        if (m_stop)
            return kStopped;
        takeErrors();
    }
    if (m_process->exitStatus() != QProcess::NormalExit || m_process->exitCode() != 0)
        return failure();
    m_process.reset();
    return std::nullopt;
}

void VideoEncoder::kill() {
    if (isRunning()) {
        m_process->kill();
        m_process->waitForFinished();
    }
    m_process.reset();
}

void VideoEncoder::takeErrors() {
    m_errors = (m_errors + m_process->readAllStandardError()).right(kMostErrors);
}

std::optional<std::string> VideoEncoder::failure() {
    if (m_stop)
        return kStopped;
    m_process->waitForFinished(kLook);
    takeErrors();
    const std::string said = lastLines(m_errors);
    return said.empty() ? "ffmpeg ended without a word (status " + std::to_string(m_process->exitCode()) + ")"
                        : "ffmpeg failed: " + said;
}

} // namespace clothlab
