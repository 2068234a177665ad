#include "app/widgets/parameter_row.h"

#include "app/widgets/drag_label.h"
#include "app/widgets/number_field.h"
#include "app/widgets/number_text.h"
#include "app/widgets/theme.h"
#include "app/widgets/value_slider.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace clothlab {

namespace {

constexpr int kLabelWidth = 110;
constexpr int kFieldWidth = 92;
constexpr double kDragPixels = 300; // of label drag for the whole slider range
constexpr int kDragDigits = 4;      // of a value dragged on a logarithmic scale

// The power of ten at or below: 0.0033 gives 0.001.
double powerOfTenBelow(double value) {
    return std::pow(10.0, std::floor(std::log10(value) + 1e-9));
}

} // namespace

// A place of fixed size, so that fields stay in line whether values are changed or not.
class ParameterRow::Dot : public QWidget {
public:
    explicit Dot(QWidget* parent) : QWidget(parent) { setFixedSize(8, 8); }

    void setShown(bool shown) {
        m_shown = shown;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        if (!m_shown) {
            return;
        }
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(isEnabled() ? themeColors().accent : themeColors().disabledText);
        painter.drawEllipse(QRectF(1.5, 1.5, 5, 5));
    }

private:
    bool m_shown = false;
};

ParameterRow::ParameterRow(const ParameterSpec& spec, QWidget* parent)
    : QWidget(parent), m_spec(spec), m_label(new DragLabel(spec.label, this)), m_field(new NumberField(this)),
      m_dot(new Dot(this)) {
    Q_ASSERT(spec.sliderMinimum < spec.sliderMaximum && (!spec.logarithmic || spec.sliderMinimum > 0));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    layout->addWidget(m_label);
    if (spec.slider) {
        buildSlider();
        layout->addWidget(m_slider, 1);
    } else {
        layout->addStretch(1); // fields stay in one column
    }
    layout->addWidget(m_field);
    layout->addWidget(m_dot);

    m_field->setRange(spec.minimum, spec.maximum);
    m_field->setInteger(spec.integer);
    m_field->setUnit(spec.unit);
    m_field->setSmallestStep(
        spec.logarithmic ? 0 : powerOfTenBelow((spec.sliderMaximum - spec.sliderMinimum) / 1000));
    m_field->setAccessibleName(spec.label);
    m_label->setBuddy(m_field);
    setLabelWidth(kLabelWidth);
    setFieldWidth(kFieldWidth);
    connectLabel();
    connectField();
    m_field->setValue(spec.defaultValue);
    refresh();
    updateToolTips();
}

void ParameterRow::buildSlider() {
    m_slider = new ValueSlider(this);
    m_slider->setScale(m_spec.sliderMinimum, m_spec.sliderMaximum, m_spec.logarithmic, m_spec.integer);
    m_slider->setMinimumWidth(40);
    m_slider->setAccessibleName(tr("%1, slider").arg(m_spec.label));
    connect(m_slider, &ValueSlider::dragStarted, this, &ParameterRow::startDrag);
    connect(m_slider, &ValueSlider::dragged, this, [this](double value) {
        // The slider may be wider than what is allowed.
        change(passedOver(std::clamp(value, m_spec.minimum, m_spec.maximum)), m_dragGesture);
    });
    connect(m_slider, &ValueSlider::dragEnded, this, &ParameterRow::refresh);
}

void ParameterRow::connectLabel() {
    connect(m_label, &DragLabel::dragStarted, this, &ParameterRow::startDrag);
    connect(m_label, &DragLabel::dragged, this,
            [this](double pixels) { change(passedOver(valueAfterDrag(pixels)), m_dragGesture); });
    connect(m_label, &DragLabel::doubleClicked, this, [this] {
        settleField();
        change(m_spec.defaultValue, 0);
    });
}

void ParameterRow::connectField() {
    m_field->installEventFilter(this);
    connect(m_field, &NumberField::rejected, this, &ParameterRow::rejected);
    connect(m_field, &NumberField::valueEdited, this, [this](double value) {
        if (!m_field->isStepping()) {
            m_stepGesture = 0;
        } else if (m_stepGesture == 0) {
            m_stepGesture = newGesture();
        }
        if (m_field->isStepping() && value > 0 && value < m_spec.leastButZero) {
            value = m_shown == 0 ? m_spec.leastButZero : 0;
            m_field->setValue(value);
        }
        refresh();
        emit edited(value, m_stepGesture);
    });
}

bool ParameterRow::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_field && event->type() == QEvent::FocusOut) {
        m_stepGesture = 0;
    }
    return QWidget::eventFilter(watched, event);
}

double ParameterRow::value() const {
    return m_field->value();
}

void ParameterRow::setValue(double value) {
    if (value != m_field->value()) {
        m_stepGesture = 0; // undone or changed elsewhere: what follows is another run
    }
    m_field->setValue(value);
    refresh();
}

// What was typed counts first, as an edit of its own; what can't be taken gives way to the drag.
void ParameterRow::settleField() {
    m_field->commit();
    m_field->restore();
    m_stepGesture = 0;
}

void ParameterRow::startDrag() {
    settleField();
    m_dragGesture = newGesture();
    m_dragStart = m_field->value();
}

double ParameterRow::valueAfterDrag(double pixels) const {
    double value = 0;
    if (m_spec.logarithmic) {
        const double start = m_dragStart > 0 ? m_dragStart : m_spec.sliderMinimum;
        const double ratio = m_spec.sliderMaximum / m_spec.sliderMinimum;
        value = roundedToDigits(start * std::pow(ratio, pixels / kDragPixels), kDragDigits);
    } else {
        // A pixel is a round step, so that values stay round: 0.001, not 0.00333.
        const double perPixel = powerOfTenBelow((m_spec.sliderMaximum - m_spec.sliderMinimum) / 100);
        value = m_dragStart + perPixel * pixels;
        value = std::abs(value) < perPixel * 1e-6 ? 0 : roundedToDigits(value, 12);
    }
    if (m_spec.integer) {
        value = std::round(value);
    }
    return std::clamp(value, m_spec.minimum, m_spec.maximum);
}

double ParameterRow::passedOver(double value) const {
    if (value <= 0 || value >= m_spec.leastButZero) {
        return value;
    }
    return 2 * value < m_spec.leastButZero ? 0 : m_spec.leastButZero;
}

void ParameterRow::change(double value, int gesture) {
    if (value == m_field->value()) {
        return;
    }
    m_field->setValue(value);
    refresh();
    emit edited(value, gesture);
}

void ParameterRow::refresh() {
    const double current = m_field->value();
    m_shown = current;
    if (m_slider != nullptr) {
        m_slider->showValue(current);
    }
    const bool changed = current != m_spec.defaultValue;
    m_dot->setShown(changed);
    m_dot->setToolTip(changed ? tr("The default is %1. Double-click the label to restore it.")
                                    .arg(shortText(m_spec.defaultValue) +
                                         (m_spec.unit.isEmpty() ? QString() : u' ' + m_spec.unit))
                              : QString());
}

void ParameterRow::setLabelWidth(int width) {
    m_label->setFixedWidth(width);
}

void ParameterRow::setFieldWidth(int width) {
    m_field->setFixedWidth(width);
}

int ParameterRow::labelWidthHint() const {
    return m_label->fontMetrics().horizontalAdvance(m_spec.label) + 1;
}

void ParameterRow::setDisabledReason(const QString& reason) {
    m_disabledReason = reason;
    setEnabled(reason.isEmpty());
    updateToolTips();
}

void ParameterRow::updateToolTips() {
    QString text = m_spec.toolTip;
    if (!m_disabledReason.isEmpty()) {
        text = text.isEmpty() ? m_disabledReason : m_disabledReason + QStringLiteral("\n\n") + text;
    }
    setToolTip(text);
    m_label->setToolTip(text);
    m_field->setToolTip(text);
    if (m_slider != nullptr) {
        m_slider->setToolTip(text);
    }
    m_field->setAccessibleDescription(text);
}

int ParameterRow::newGesture() {
    static int last = 0;
    return ++last;
}

} // namespace clothlab
