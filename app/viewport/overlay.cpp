#include "app/viewport/overlay.h"

#include "app/widgets/theme.h"

#include <QPainter>

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

void Overlay::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColors& colors = themeColors(Theme::Dark);
    if (!m_placeholderTitle.isEmpty())
        paintPlaceholder(painter);
    paintBadges(painter);
    painter.setPen(colors.dimText);
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignHCenter | Qt::AlignBottom, m_hint);
    if (!m_box.isNull()) {
        painter.setPen(QPen(colors.selected, 1, Qt::DashLine));
        painter.setBrush(QColor(colors.selected.red(), colors.selected.green(), colors.selected.blue(), 30));
        painter.drawRect(m_box.normalized());
    }
}

} // namespace clothlab
