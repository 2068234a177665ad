#include "app/docks/scrubber.h"

#include "app/widgets/theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace clothlab {
namespace {

constexpr int kShortest = 90;
constexpr double kMargin = 8;

} // namespace

Scrubber::Scrubber(QWidget* parent) : QWidget(parent) {
    setObjectName("scrubber");
    setAccessibleName(tr("Timeline"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Click or drag to show a recorded frame."));
}

QSize Scrubber::sizeHint() const {
    return {400, fontMetrics().height() + 22};
}

QSize Scrubber::minimumSizeHint() const {
    return {120, sizeHint().height()};
}

void Scrubber::setRecording(int frameCount, int firstStale) {
    m_frameCount = frameCount;
    m_firstStale = firstStale;
    m_span = kShortest;
    while (m_span < frameCount - 1)
        m_span *= 2;
    update();
}

void Scrubber::setCurrent(int frame) {
    m_current = frame;
    update();
}

void Scrubber::setFramesPerSecond(int framesPerSecond) {
    m_framesPerSecond = framesPerSecond;
    update();
}

QRectF Scrubber::track() const {
    return {kMargin, double(height()) - 18, width() - 2 * kMargin, 12};
}

double Scrubber::positionOf(double frame) const {
    return track().left() + track().width() * frame / m_span;
}

int Scrubber::frameAt(double x) const {
    const double ratio = (x - track().left()) / std::max(1.0, track().width());
    return std::clamp(int(std::lround(ratio * m_span)), 0, m_frameCount - 1);
}

// A label about every 80 pixels, at a round number of frames, with its time.
void Scrubber::paintTicks(QPainter& painter) const {
    const double framesPerLabel = m_span * 80.0 / std::max(1.0, track().width());
    int step = 1;
    for (const int factor : {10, 15, 30, 45, 90})
        if (step < framesPerLabel)
            step = factor;
    while (step < framesPerLabel)
        step *= 2;
    for (int frame = 0; frame <= m_span; frame += step) {
        const double x = positionOf(frame);
        painter.drawLine(QPointF(x, track().top() - 4), QPointF(x, track().top() - 1));
        const QString text = QStringLiteral("%1 · %2 s")
                                 .arg(frame)
                                 .arg(QString::number(double(frame) / m_framesPerSecond, 'g', 3));
        const double textWidth = painter.fontMetrics().horizontalAdvance(text);
        const double left = std::clamp(x - textWidth / 2, 0.0, std::max(0.0, width() - textWidth));
        painter.drawText(QPointF(left, track().top() - 6), text);
    }
}

void Scrubber::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColors& colors = themeColors();
    painter.setPen(colors.dimText);
    paintTicks(painter);

    painter.setPen(colors.border);
    painter.setBrush(colors.field);
    painter.drawRoundedRect(track(), 3, 3);
    painter.setPen(Qt::NoPen);
    const auto part = [&](double from, double to) {
        return QRectF(QPointF(positionOf(from), track().top() + 1),
                      QPointF(positionOf(to), track().bottom() - 1));
    };
    painter.setBrush(colors.accent);
    painter.drawRect(part(0, std::max(0, std::min(m_firstStale, m_frameCount) - 1)));
    if (m_firstStale < m_frameCount) {
        painter.setBrush(QBrush(colors.warning, Qt::BDiagPattern));
        painter.drawRect(part(std::max(0, m_firstStale - 1), m_frameCount - 1));
    }

    const double x = positionOf(m_current);
    painter.setBrush(colors.text);
    painter.drawRoundedRect(QRectF(x - 2, track().top() - 3, 4, track().height() + 6), 2, 2);
}

void Scrubber::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        emit frameRequested(frameAt(event->position().x()));
}

void Scrubber::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons().testFlag(Qt::LeftButton))
        emit frameRequested(frameAt(event->position().x()));
}

} // namespace clothlab
