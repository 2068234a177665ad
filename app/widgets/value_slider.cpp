#include "app/widgets/value_slider.h"

#include "app/widgets/number_text.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace clothlab {

namespace {

constexpr int kPositions = 1000;
constexpr int kLogarithmicDigits = 3;

} // namespace

ValueSlider::ValueSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    setRange(0, kPositions);
    // A click takes the focus from a field, so that what was typed there counts first.
    setFocusPolicy(Qt::ClickFocus);
}

void ValueSlider::setScale(double minimum, double maximum, bool logarithmic, bool integer) {
    Q_ASSERT(minimum < maximum && (!logarithmic || minimum > 0));
    m_minimum = minimum;
    m_maximum = maximum;
    m_logarithmic = logarithmic && minimum > 0;
    m_integer = integer;
}

void ValueSlider::showValue(double value) {
    if (!isSliderDown()) {
        QSlider::setValue(positionOf(value));
    }
}

double ValueSlider::valueAt(int position) const {
    if (position <= 0) {
        return m_minimum;
    }
    if (position >= kPositions) {
        return m_maximum;
    }
    const double fraction = double(position) / kPositions;
    if (m_logarithmic) {
        const double value = m_minimum * std::pow(m_maximum / m_minimum, fraction);
        return m_integer ? std::round(value) : roundedToDigits(value, kLogarithmicDigits);
    }
    const double range = m_maximum - m_minimum;
    const double value = m_minimum + fraction * range;
    if (m_integer) {
        return std::round(value);
    }
    const double quantum = std::pow(10.0, std::floor(std::log10(range / kPositions) + 1e-9));
    return roundedToDigits(std::round(value / quantum) * quantum, 12);
}

int ValueSlider::positionOf(double value) const {
    // Also true of nan, which has no place.
    if (!(value > m_minimum)) {
        return 0;
    }
    const double fraction = m_logarithmic ? std::log(value / m_minimum) / std::log(m_maximum / m_minimum)
                                          : (value - m_minimum) / (m_maximum - m_minimum);
    return int(std::lround(std::min(fraction, 1.0) * kPositions));
}

QRect ValueSlider::handleRect() const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    return style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
}

void ValueSlider::moveTo(int position) {
    const int bounded = std::clamp(position, 0, kPositions);
    if (bounded != value()) {
        QSlider::setValue(bounded);
        emit dragged(valueAt(bounded));
    }
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_pressX = event->position().toPoint().x();
    const QRect handle = handleRect();
    setSliderDown(true);
    emit dragStarted();
    if (m_pressX < handle.left() || m_pressX > handle.right()) {
        const int length = handle.width();
        moveTo(QStyle::sliderValueFromPosition(0, kPositions, m_pressX - length / 2, width() - length));
    }
    m_pressPosition = value();
    event->accept();
}

// Counted from where the handle was taken: a handle that is held still keeps its value, which may lie
// between two pixels.
void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
    const int length = width() - handleRect().width();
    if (isSliderDown() && length > 0) {
        const double moved = (event->position().x() - m_pressX) / length;
        moveTo(m_pressPosition + int(std::lround(moved * kPositions)));
    }
    event->accept();
}

void ValueSlider::mouseReleaseEvent(QMouseEvent* event) {
    if (isSliderDown() && event->button() == Qt::LeftButton) {
        setSliderDown(false);
        emit dragEnded();
    }
    event->accept();
}

void ValueSlider::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
    event->ignore();
}

} // namespace clothlab
