#include "app/widgets/drag_label.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>

#include <cmath>

namespace clothlab {

DragLabel::DragLabel(const QString& text, QWidget* parent) : QLabel(text, parent) {
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setCursor(Qt::SizeHorCursor);
}

void DragLabel::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_pressed = true;
    m_dragging = false;
    m_lastX = event->globalPosition().x();
    m_pixels = 0;
    event->accept();
}

void DragLabel::mouseMoveEvent(QMouseEvent* event) {
    if (!m_pressed) {
        return;
    }
    const double x = event->globalPosition().x();
    if (!m_dragging) {
        if (std::abs(x - m_lastX) < QApplication::startDragDistance()) {
            return;
        }
        m_dragging = true;
        m_lastX = x; // the distance that told a drag from a click changes nothing
        emit dragStarted();
        return;
    }
    const double factor = event->modifiers() & Qt::ShiftModifier     ? 10
                          : event->modifiers() & Qt::ControlModifier ? 0.1
                                                                     : 1;
    m_pixels += (x - m_lastX) * factor;
    m_lastX = x;
    emit dragged(m_pixels);
}

void DragLabel::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        return;
    }
    m_pressed = false;
    if (m_dragging) {
        m_dragging = false;
        emit dragEnded();
    }
}

void DragLabel::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        emit doubleClicked();
    }
}

void DragLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, width());
    style()->drawItemText(&painter, rect(), int(alignment()), palette(), isEnabled(), shown,
                          foregroundRole());
}

} // namespace clothlab
