#include "app/widgets/flow_row.h"

#include <QEvent>

#include <algorithm>

namespace clothlab {
namespace {

constexpr int kGap = 12; // between neighbours
constexpr int kLineGap = 2;

} // namespace

void FlowRow::add(QWidget* widget) {
    widget->setParent(this);
    m_widgets << widget;
    place();
}

QSize FlowRow::sizeHint() const {
    QSize size(-kGap, 0);
    for (const QWidget* widget : m_widgets)
        size = {size.width() + kGap + widget->sizeHint().width(),
                std::max(size.height(), widget->sizeHint().height())};
    return size;
}

QSize FlowRow::minimumSizeHint() const {
    QSize size;
    for (const QWidget* widget : m_widgets)
        size = size.expandedTo(widget->sizeHint());
    return size;
}

bool FlowRow::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) // one of them wants another size
        place();
    return QWidget::event(event);
}

void FlowRow::resizeEvent(QResizeEvent* event) {
    place();
    QWidget::resizeEvent(event);
}

void FlowRow::place() {
    const int lineHeight = minimumSizeHint().height();
    QPoint at;
    for (QWidget* widget : m_widgets) {
        const int width = widget->sizeHint().width();
        if (at.x() > 0 && at.x() + width > this->width())
            at = {0, at.y() + lineHeight + kLineGap};
        widget->setGeometry(at.x(), at.y(), width, lineHeight);
        at.rx() += width + kGap;
    }
    setFixedHeight(at.y() + lineHeight);
}

} // namespace clothlab
