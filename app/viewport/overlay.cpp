#include "app/viewport/overlay.h"

#include "app/render/strain_colors.h"
#include "app/widgets/theme.h"

#include <QPainter>

#include <cmath>
#include <utility>

namespace clothlab {

Overlay::Overlay(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
}

void Overlay::setBadges(std::vector<Badge> badges) {
    if (badges == m_badges)
        return;
    m_badges = std::move(badges);
    update();
}

void Overlay::setHint(const QString& hint) {
    if (hint == m_hint)
        return;
    m_hint = hint;
    update();
}

void Overlay::setLegend(const std::optional<Legend>& legend) {
    if (legend == m_legend)
        return;
    m_legend = legend;
    update();
}

void Overlay::setSelectionBox(const QRect& box) {
    m_box = box;
    update();
}

void Overlay::setPlaceholder(const QString& title, const QString& reason) {
    m_placeholderTitle = title;
    m_placeholderReason = reason;
    update();
}

void Overlay::paintBadges(QPainter& painter) const {
    const QFontMetrics metrics = painter.fontMetrics();
    const int padding = metrics.height() / 2;
    int top = padding;
    for (const Badge& badge : m_badges) {
        const int widest = width() - 4 * padding;
        QRect text = metrics.boundingRect(QRect(0, 0, widest, height()), Qt::AlignCenter | Qt::TextWordWrap,
                                          badge.text);
        text.moveCenter({width() / 2, 0});
        text.moveTop(top + padding / 2);
        const QRect box = text.adjusted(-padding, -padding / 2, padding, padding / 2);
        painter.setPen(badge.color);
        painter.setBrush(QColor(0x18, 0x19, 0x1B, 225));
        painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        painter.drawText(text, Qt::AlignCenter | Qt::TextWordWrap, badge.text);
        top = box.bottom() + padding / 2;
    }
}

namespace {

// "+2.5 %", with a true minus.
QString signedPercent(double strain) {
    const QString number = QString::number(std::abs(100 * strain), 'g', 3);
    const QChar sign = strain < 0 ? QChar(0x2212) : u'+';
    return (number == QLatin1String("0") ? number : sign + number) + QStringLiteral(" %");
}

} // namespace

void Overlay::paintLegend(QPainter& painter) const {
    const ThemeColors& colors = themeColors(Theme::Dark);
    const int line = painter.fontMetrics().height();
    const int barWidth = line;
    const int barHeight = 10 * line;
    const int textWidth =
        painter.fontMetrics().horizontalAdvance(QStringLiteral("%1100.25 %").arg(QChar(0x2212)));
    const QRect box(width() - (barWidth + textWidth + 3 * line), line, barWidth + textWidth + 2 * line,
                    barHeight + 6 * line);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x18, 0x19, 0x1B, 200));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(colors.text);
    painter.drawText(box.adjusted(line / 2, line / 2, 0, 0), Qt::AlignLeft | Qt::AlignTop, tr("Strain"));

    const QRect bar(box.left() + line / 2, box.top() + 2 * line + line / 2, barWidth, barHeight);
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    const auto& stops = render::kStrainColors;
    for (std::size_t i = 0; i < stops.size(); ++i)
        gradient.setColorAt(double(i) / double(stops.size() - 1),
                            QColor::fromRgbF(stops[i].x(), stops[i].y(), stops[i].z()));
    painter.fillRect(bar, gradient);
    constexpr int ticks = 4;
    for (int i = 0; i <= ticks; ++i) {
        const int y = bar.top() + i * bar.height() / ticks;
        painter.drawLine(bar.right() + 1, y, bar.right() + 4, y);
        painter.drawText(QRect(bar.right() + 7, y - line / 2, textWidth + line, line),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         signedPercent(m_legend->range * (1 - 2.0 * i / ticks)));
    }
    painter.setPen(colors.dimText);
    const QRect below(bar.left(), bar.bottom() + line, box.width() - line, 2 * line + line / 2);
    painter.drawText(
        below, Qt::AlignLeft | Qt::AlignTop,
        tr("here %1\nto %2").arg(signedPercent(m_legend->least), signedPercent(m_legend->greatest)));
}

void Overlay::paintPlaceholder(QPainter& painter) const {
    const ThemeColors& colors = themeColors(Theme::Dark);
    painter.fillRect(rect(), colors.window);
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.3);
    painter.setFont(large);
    painter.setPen(colors.text);
    const QRect upper(0, 0, width(), height() / 2);
    painter.drawText(upper.adjusted(16, 0, -16, -4), Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap,
                     m_placeholderTitle);
    painter.setFont(font());
    painter.setPen(colors.dimText);
    const QRect lower(0, height() / 2, width(), height() / 2);
    painter.drawText(lower.adjusted(16, 4, -16, 0), Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                     m_placeholderReason);
}

// On a dark ground, as the sheet may be behind it.
void Overlay::paintHint(QPainter& painter) const {
    if (m_hint.isEmpty())
        return;
    constexpr int margin = 8;
    const QRect room = rect().adjusted(2 * margin, margin, -2 * margin, -margin);
    const QRect text = painter.fontMetrics().boundingRect(
        room, Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap, m_hint);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x18, 0x19, 0x1B, 150));
    painter.drawRoundedRect(text.adjusted(-margin, -2, margin, 2), 4, 4);
    painter.setPen(themeColors(Theme::Dark).dimText);
    painter.drawText(text, Qt::AlignCenter | Qt::TextWordWrap, m_hint);
}

void Overlay::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_placeholderTitle.isEmpty())
        paintPlaceholder(painter);
    paintBadges(painter);
    if (m_legend)
        paintLegend(painter);
    paintHint(painter);
    if (!m_box.isNull()) {
        const ThemeColors& colors = themeColors(Theme::Dark);
        painter.setPen(QPen(colors.selected, 1, Qt::DashLine));
        painter.setBrush(QColor(colors.selected.red(), colors.selected.green(), colors.selected.blue(), 30));
        painter.drawRect(m_box.normalized());
    }
}

} // namespace clothlab
