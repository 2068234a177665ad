// The part of the scrubber that paints it.
#include "app/docks/scrubber.h"
#include "app/widgets/theme.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace clothlab {
namespace {

QColor between(const QColor& a, const QColor& b, double share) {
    const auto part = [share](int from, int to) { return int(std::lround(from + share * (to - from))); };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

} // namespace

QColor Scrubber::colorOf(Part part) const {
    const ThemeColors& colors = themeColors();
    switch (part) {
    case Part::Recorded:
        return colors.accent;
    case Part::Spilled:
        return between(colors.accent, colors.field, 0.55);
    case Part::Stale:
        return colors.warning;
    case Part::Live:
        return colors.error;
    }
    return {};
}

QString Scrubber::nameOf(Part part) const {
    switch (part) {
    case Part::Recorded:
        return tr("recorded");
    case Part::Spilled:
        return tr("recorded, on disk");
    case Part::Stale:
        return tr("stale");
    case Part::Live:
        return tr("live");
    }
    return {};
}

QString Scrubber::legend() const {
    QString rows;
    const auto add = [&](Part part, const QString& text) {
        rows += QStringLiteral("<tr><td style='color:%1'>%2</td><td style='padding-left:6px'>%3</td></tr>")
                    .arg(colorOf(part).name(),
                         part == Part::Stale ? QStringLiteral("▨") : QStringLiteral("■"), text);
    };
    add(Part::Recorded, tr("recorded, in memory"));
    add(Part::Spilled, tr("recorded, on disk only"));
    add(Part::Stale, tr("stale: computed before what was edited since"));
    add(Part::Live, tr("live: being recorded now"));
    return tr("Click or drag to show a recorded frame; ◆ are markers, [ and ] in and out point.") +
           QStringLiteral("<table>%1</table>").arg(rows);
}

// --- what changes seldom

void Scrubber::paintPicture() {
    m_picture = QPixmap(size() * devicePixelRatioF());
    m_picture.setDevicePixelRatio(devicePixelRatioF());
    m_picture.fill(Qt::transparent);
    QPainter painter(&m_picture);
    painter.setFont(font());
    paintTicks(painter);
    paintPlot(painter);
}

// A label about every 90 pixels, at a round number of frames, with its time.
void Scrubber::paintTicks(QPainter& painter) const {
    painter.setPen(themeColors().dimText);
    const double framesPerLabel = m_span * 90.0 / std::max(1.0, track().width());
    int step = 1;
    for (const int factor : {10, 15, 30, 45, 90})
        if (step < framesPerLabel)
            step = factor;
    while (step < framesPerLabel)
        step *= 2;
    const int baseline = fontMetrics().ascent() + 1;
    double free = 0; // where the last label ends
    for (int frame = 0; frame <= m_span; frame += step) {
        const double x = positionOf(frame);
        painter.drawLine(QPointF(x, fontMetrics().height() + 1), QPointF(x, marksRow().top() - 1));
        const QString text =
            QStringLiteral("%1 · %2 s").arg(frame).arg(QString::number(timeOf(frame), 'g', 3));
        const double textWidth = painter.fontMetrics().horizontalAdvance(text);
        const double left = std::clamp(x - textWidth / 2, 0.0, std::max(0.0, width() - textWidth));
        if (left < free)
            continue;
        painter.drawText(QPointF(left, baseline), text);
        free = left + textWidth + 6;
    }
}

void Scrubber::paintPlot(QPainter& painter) const {
    const QRectF area = plotArea();
    const ThemeColors& colors = themeColors();
    painter.fillRect(area, colors.field);
    if (m_plot.frameCount() == 0)
        return;
    const auto [least, greatest] = m_plot.whole();
    const double low = std::min(0.0F, least);
    const double high = std::max(greatest, 0.0F);
    const double range = high > low ? high - low : 1;
    const auto yOf = [&](double value) {
        return area.bottom() - 1 - (value - low) / range * (area.height() - 2);
    };
    const double pixel = 1 / devicePixelRatioF();
    const double framesPerColumn = m_span / area.width() * pixel;
    const int end = m_plot.frameCount();
    const int columns = 1 + int(double(end - 1) / framesPerColumn); // up to the last frame
    const QColor fill = between(colors.field, colors.accent, 0.3);
    const QColor line = between(colors.field, colors.accent, 0.75);
    for (int column = 0; column < columns; ++column) {
        const int first = std::min(int(std::lround(column * framesPerColumn)), end - 1);
        const int last = std::clamp(int(std::lround((column + 1) * framesPerColumn)), first + 1, end);
        const auto extent = m_plot.extent(first, last);
        const double x = area.left() + column * pixel;
        const double top = yOf(double(extent.greatest));
        const double bottom = yOf(double(extent.least));
        const double zero = yOf(0);
        painter.fillRect(QRectF(QPointF(x, std::min(top, zero)), QPointF(x + pixel, std::max(bottom, zero))),
                         fill);
        painter.fillRect(QRectF(x, top - 0.5, pixel, bottom - top + 1), line);
    }
    painter.setPen(colors.dimText);
    const QRectF side(area.right() + 4, area.top(), width() - area.right() - 4, area.height());
    painter.drawText(side, Qt::AlignLeft | Qt::AlignTop, quantityText(m_plot.quantity(), high));
    if (side.height() >= 2 * fontMetrics().height())
        painter.drawText(side, Qt::AlignLeft | Qt::AlignBottom, quantityText(m_plot.quantity(), low));
}

// --- what changes with every frame

// A pixel column at a time: groups of frames go to disk in no order that a take knows.
void Scrubber::findSpilled() {
    constexpr qint64 milliseconds = 300;
    if (m_sinceSpilled.isValid() && m_sinceSpilled.elapsed() < milliseconds)
        return;
    m_sinceSpilled.start();
    const double end = positionOf(m_simulation.recording().lastFrame()) - bar().left();
    m_spilled.assign(std::size_t(std::max(0.0, bar().width())), false);
    for (std::size_t column = 0; column < m_spilled.size(); ++column) {
        const auto frame = int(double(column) / double(m_spilled.size()) * m_span);
        m_spilled[column] = double(column) < end && partOf(frame) == Part::Spilled;
    }
}

void Scrubber::paintBar(QPainter& painter) {
    findSpilled();
    const ThemeColors& colors = themeColors();
    const Recording& recording = m_simulation.recording();
    const int last = recording.lastFrame();
    const int firstStale = recording.firstStaleFrame();
    painter.setPen(colors.border);
    painter.setBrush(colors.field);
    painter.drawRoundedRect(bar(), 3, 3);
    painter.setPen(Qt::NoPen);
    const double top = bar().top() + 1;
    const double inside = bar().height() - 2;
    const auto fill = [&](double from, double to, const QBrush& brush) {
        painter.fillRect(QRectF(from, top, to - from, inside), brush);
    };
    fill(positionOf(0), positionOf(std::max(0, std::min(firstStale, last + 1) - 1)), colorOf(Part::Recorded));
    for (std::size_t begin = 0; begin < m_spilled.size(); ++begin) {
        std::size_t end = begin;
        while (end < m_spilled.size() && m_spilled[end])
            ++end;
        if (end > begin)
            fill(bar().left() + double(begin), bar().left() + double(end), colorOf(Part::Spilled));
        begin = end;
    }
    if (m_liveFrom >= 0)
        fill(positionOf(m_liveFrom), positionOf(recording.endOfRun()), colorOf(Part::Live));
    if (firstStale <= last) {
        const double from = positionOf(std::max(0, firstStale - 1));
        fill(from, positionOf(last), between(colors.field, colors.warning, 0.25));
        fill(from, positionOf(last), QBrush(colorOf(Part::Stale), Qt::BDiagPattern));
    }
}

void Scrubber::paintRange(QPainter& painter) const {
    const auto& range = m_simulation.marks().range;
    if (!range)
        return;
    const ThemeColors& colors = themeColors();
    QColor shade = colors.panel;
    shade.setAlpha(170);
    const double in = positionOf(range->in);
    const double out = range->out == kOpenEnd ? track().right() : positionOf(std::min(range->out, m_span));
    const QRectF area = plotArea();
    painter.fillRect(QRectF(area.left(), area.top(), in - area.left(), area.height()), shade);
    painter.fillRect(QRectF(out, area.top(), area.right() - out, area.height()), shade);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors.text, 1.6));
    const double top = marksRow().top() + 1;
    const double bottom = bar().top();
    const auto bracket = [&](double x, double inward) {
        painter.drawPolyline(QPolygonF{{x + inward, top}, {x, top}, {x, bottom}});
        painter.drawLine(QPointF(x, marksRow().bottom()), QPointF(x + inward, marksRow().bottom()));
    };
    if (range->in > 0)
        bracket(in, 5);
    if (range->out != kOpenEnd)
        bracket(out, -5);
}

void Scrubber::paintMarkers(QPainter& painter) const {
    const ThemeColors& colors = themeColors();
    const std::vector<Marker>& markers = m_simulation.marks().markers;
    const double middle = marksRow().center().y();
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const double x = positionOf(markers[i].frame);
        const bool selected = m_selected == markers[i].frame;
        QColor stem = colors.selected;
        stem.setAlpha(120);
        painter.setPen(QPen(stem, 1));
        painter.drawLine(QPointF(x, middle), QPointF(x, bar().top()));
        painter.setPen(selected ? QPen(colors.text, 1.4) : QPen(Qt::NoPen));
        painter.setBrush(colors.selected);
        const double size = selected ? 5.5 : 4.5;
        painter.drawPolygon(
            QPolygonF{{x - size, middle}, {x, middle - size}, {x + size, middle}, {x, middle + size}});
        // Its name, as far as there is room.
        const double next = i + 1 < markers.size() ? positionOf(markers[i + 1].frame) - 6 : double(width());
        const double room = next - x - 9;
        const QString name = QString::fromStdString(markers[i].name);
        painter.setPen(colors.text);
        if (room > 30)
            painter.drawText(QRectF(x + 8, marksRow().top(), room, marksRow().height()),
                             Qt::AlignLeft | Qt::AlignVCenter,
                             fontMetrics().elidedText(name, Qt::ElideRight, int(room)));
    }
}

void Scrubber::paintEvent(QPaintEvent* /*event*/) {
    if (m_picture.isNull() || m_picture.devicePixelRatio() != devicePixelRatioF())
        paintPicture();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBar(painter);
    paintRange(painter);
    paintMarkers(painter);

    const double x = positionOf(m_simulation.currentFrame());
    painter.setPen(Qt::NoPen);
    painter.setBrush(themeColors().text);
    painter.drawRect(QRectF(x - 0.5, plotArea().top(), 1, plotArea().height()));
    painter.drawRoundedRect(QRectF(x - 2, bar().top() - 3, 4, bar().height() + 6), 2, 2);
}

void Scrubber::resizeEvent(QResizeEvent* event) {
    forgetPicture();
    QWidget::resizeEvent(event);
}

void Scrubber::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange ||
        event->type() == QEvent::FontChange)
        forgetPicture();
    QWidget::changeEvent(event);
}

} // namespace clothlab
