#include "app/export/picture_writers.h"

#include "app/export/video_encoder.h"
#include "simcore/base/whole_file.h"

#include <QBuffer>

#include <utility>

namespace clothlab {
namespace {

class PngWriter : public FrameWriter {
public:
    PngWriter(std::function<std::string(int)> pathOf, std::unique_ptr<FramePainter> painter)
        : FrameWriter({}), m_pathOf(std::move(pathOf)), m_painter(std::move(painter)) {}

private:
    Trouble open(const Sheet&, int) override { return m_painter->begin(); }
    Trouble write(const FramePointer& frame) override {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        if (!m_painter->paint(*frame).save(&buffer, "PNG"))
            return "the picture could not be made; choose a smaller size";
        return writeFileWhole(m_pathOf(added()),
                              [&](std::ostream& out) { out.write(bytes.constData(), bytes.size()); });
    }
    Trouble complete() override {
        m_painter->end();
        return std::nullopt;
    }
    void discard() override { m_painter->end(); }
    std::string place() const override { return m_pathOf(added()); }

    std::function<std::string(int)> m_pathOf;
    std::unique_ptr<FramePainter> m_painter;
};

class VideoWriter : public FrameWriter {
public:
    VideoWriter(const std::string& path, VideoFormat format, double framesPerSecond,
                std::unique_ptr<FramePainter> painter, const std::atomic<bool>& stop)
        : FrameWriter(path), m_settings{format, painter->size(), framesPerSecond},
          m_painter(std::move(painter)), m_stop(stop) {}

private:
    Trouble open(const Sheet&, int) override {
        if (m_settings.size != evenSize(m_settings.size))
            return "a video has an even width and an even height; change the size by one pixel";
        // Here, as a process belongs to a thread.
        m_encoder = std::make_unique<VideoEncoder>(m_stop);
        m_file = std::make_unique<WholeFile>();
        if (auto trouble = m_file->open(path()))
            return trouble;
        if (auto trouble = m_encoder->start(m_settings, QString::fromStdString(m_file->temporaryPath())))
            return trouble;
        return m_painter->begin();
    }
    Trouble write(const FramePointer& frame) override { return m_encoder->add(m_painter->paint(*frame)); }
    Trouble complete() override {
        m_painter->end();
        if (auto trouble = m_encoder->finish())
            return trouble;
        m_encoder.reset();
        return m_file->finish();
    }
    void discard() override {
        m_encoder.reset(); // before the file that it writes to
        m_file.reset();
        m_painter->end();
    }

    VideoSettings m_settings;
    std::unique_ptr<FramePainter> m_painter;
    const std::atomic<bool>& m_stop;
    std::unique_ptr<WholeFile> m_file;
    std::unique_ptr<VideoEncoder> m_encoder;
};

} // namespace

std::unique_ptr<FrameWriter> makePngWriter(std::function<std::string(int)> pathOf,
                                           std::unique_ptr<FramePainter> painter) {
    return std::make_unique<PngWriter>(std::move(pathOf), std::move(painter));
}

std::unique_ptr<FrameWriter> makeVideoWriter(const std::string& path, VideoFormat format,
                                             double framesPerSecond, std::unique_ptr<FramePainter> painter,
                                             const std::atomic<bool>& stop) {
    return std::make_unique<VideoWriter>(path, format, framesPerSecond, std::move(painter), stop);
}

} // namespace clothlab
