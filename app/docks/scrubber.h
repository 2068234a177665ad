#pragma once

#include <QWidget>

namespace clothlab {

// The strip of recorded frames: a click or drag asks for a frame. Its length grows by doubling, so that the
// cursor moves while a run is recorded.
class Scrubber : public QWidget {
    Q_OBJECT

public:
    explicit Scrubber(QWidget* parent = nullptr);

    // Frames 0 … frameCount - 1 are recorded; those from firstStale on are stale.
    void setRecording(int frameCount, int firstStale);
    void setCurrent(int frame);
    void setFramesPerSecond(int framesPerSecond);

    int span() const { return m_span; }    // frame at the right end
    int frameAt(double x) const;           // nearest, 0 … frameCount - 1
    double positionOf(double frame) const; // x

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void frameRequested(int frame);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    QRectF track() const;
    void paintTicks(QPainter& painter) const;

    int m_frameCount = 1;
    int m_firstStale = 1;
    int m_current = 0;
    int m_framesPerSecond = 90;
    int m_span = 90;
};

} // namespace clothlab
