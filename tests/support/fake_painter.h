// Pictures of frames without OpenGL.
#pragma once

#include "app/export/frame_painter.h"

#include <QThread>

namespace clothlab::test {

// Each picture has one colour, redder from frame to frame. What was called is in `log`, which must outlive
// it.
class FakePainter : public FramePainter {
public:
    struct Log {
        int begun = 0, painted = 0, ended = 0;
        QThread* thread = nullptr; // that painted
    };

    FakePainter(QSize size, Log& log) : m_size(size), m_log(log) {}

    std::optional<std::string> begin() override {
        ++m_log.begun;
        return std::nullopt;
    }
    QImage paint(const Frame&) override {
        m_log.thread = QThread::currentThread();
        QImage image(m_size, QImage::Format_RGB32);
        image.fill(colorOf(m_log.painted++));
        return image;
    }
    void end() override { ++m_log.ended; }
    QSize size() const override { return m_size; }

    static QColor colorOf(int frame) { return {40 + 20 * frame, 60, 90}; }

private:
    QSize m_size;
    Log& m_log;
};

} // namespace clothlab::test
