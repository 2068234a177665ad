#include "app/widgets/number_field.h"

#include "app/widgets/expression.h"
#include "app/widgets/number_text.h"
#include "app/widgets/theme.h"

#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>

namespace clothlab {

namespace {

constexpr int kUnitGap = 4; // between text and unit, and right of the unit
constexpr int kStepDigits = 12;
constexpr int kWheelStep = 120; // one notch

} // namespace

NumberField::NumberField(QWidget* parent)
    : QLineEdit(parent), m_minimum(-std::numeric_limits<double>::infinity()),
      m_maximum(std::numeric_limits<double>::infinity()) {
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QLineEdit::textEdited, this, [this] { setRejected(false); });
    showValue();
}

void NumberField::setValue(double value) {
    if (value == m_value || (std::isnan(value) && std::isnan(m_value))) {
        return;
    }
    m_value = value;
    if (hasFocus() && isModified()) {
        return;
    }
    setRejected(false);
    showValue();
}

void NumberField::setRange(double minimum, double maximum) {
    Q_ASSERT(minimum <= maximum);
    m_minimum = minimum;
    m_maximum = maximum;
}

void NumberField::setInteger(bool integer) {
    m_integer = integer;
}

void NumberField::setUnit(const QString& unit) {
    m_unit = unit;
    updateMargins();
    update();
}

void NumberField::setSmallestStep(double step) {
    m_smallestStep = step;
}

QSize NumberField::sizeHint() const {
    const int width = fontMetrics().horizontalAdvance(QStringLiteral("-0.0000000")) +
                      fontMetrics().horizontalAdvance(m_unit) + 4 * kUnitGap;
    return {width, QLineEdit::sizeHint().height()};
}

QSize NumberField::minimumSizeHint() const {
    return {fontMetrics().horizontalAdvance(QStringLiteral("0.000")) + textMargins().right() + 4 * kUnitGap,
            QLineEdit::minimumSizeHint().height()};
}

void NumberField::commit() {
    if (isModified() && takeText()) {
        showValue();
    }
}

void NumberField::restore() {
    setRejected(false);
    showValue();
}

// What is rejected stays as typed, to be corrected.
bool NumberField::takeText() {
    const QString typed = text().trimmed();
    QString number = typed;
    if (!m_unit.isEmpty() && number.endsWith(m_unit)) {
        number.chop(m_unit.size());
    }
    const ExpressionResult result = evaluateExpression(number);
    if (!result.ok()) {
        reject(
            tr("“%1” is not a number: %2. The value stays %3.").arg(typed, result.error, shortText(m_value)));
        return false;
    }
    const bool whole = result.value == std::trunc(result.value);
    if (result.value < m_minimum || result.value > m_maximum || (m_integer && !whole)) {
        reject(rangeMessage(typed));
        return false;
    }
    setRejected(false);
    setModified(false);
    if (result.value != m_value) {
        m_value = result.value;
        emit valueEdited(m_value);
    }
    return true;
}

QString NumberField::rangeMessage(const QString& typed) const {
    const auto withUnit = [this](double value) {
        return m_unit.isEmpty() ? shortText(value) : shortText(value) + u' ' + m_unit;
    };
    const QString kind = m_integer ? tr("a whole number") : tr("a number");
    QString allowed = kind;
    if (std::isfinite(m_minimum) && std::isfinite(m_maximum)) {
        allowed = tr("%1 from %2 to %3").arg(kind, withUnit(m_minimum), withUnit(m_maximum));
    } else if (std::isfinite(m_minimum)) {
        allowed = tr("%1 of at least %2").arg(kind, withUnit(m_minimum));
    } else if (std::isfinite(m_maximum)) {
        allowed = tr("%1 of at most %2").arg(kind, withUnit(m_maximum));
    }
    return tr("“%1” can't be taken: it has to be %2. The value stays %3.")
        .arg(typed, allowed, shortText(m_value));
}

void NumberField::reject(const QString& message) {
    setRejected(true);
    emit rejected(message);
}

void NumberField::setRejected(bool rejected) {
    if (m_rejected == rejected) {
        return;
    }
    m_rejected = rejected;
    setProperty("rejected", rejected); // the style sheet draws the border
    style()->unpolish(this);
    style()->polish(this);
    update();
}

// Programmatic: leaves the text unmodified. What was selected as a whole stays so.
void NumberField::showValue() {
    const QString shown = hasFocus() ? exactText(m_value) : shortText(m_value);
    if (shown != text() || isModified()) {
        const bool all = hasFocus() && hasSelectedText() && selectedText() == text();
        const int cursor = cursorPosition();
        setText(shown);
        if (all) {
            selectAll();
        } else {
            setCursorPosition(hasFocus() ? std::min(cursor, int(shown.size())) : 0);
        }
    }
    setModified(false);
}

// A tenth of the magnitude's power of ten: 0.01 at 0.5, 100 at 5000. Just below a power of ten the step is
// finer than at it; going down from 1 takes that finer one, so that Up undoes Down.
double NumberField::stepSize(bool towardsZero) const {
    const double magnitude = std::abs(m_value) * (towardsZero ? 1 - 1e-9 : 1 + 1e-9);
    double step = m_smallestStep > 0 ? m_smallestStep : (m_value == 0 ? 0.01 : 0);
    if (magnitude > 0 && std::isfinite(magnitude)) {
        step = std::max(step, std::pow(10.0, std::floor(std::log10(magnitude)) - 1));
    }
    return m_integer ? std::max(1.0, std::round(step)) : step;
}

void NumberField::stepBy(int count, Qt::KeyboardModifiers modifiers) {
    if (count == 0 || isReadOnly() || (isModified() && !takeText())) {
        return;
    }
    double step = stepSize(m_value * count < 0);
    if (modifiers & Qt::ShiftModifier) {
        step *= 10;
    }
    if (modifiers & Qt::ControlModifier) {
        step = m_integer ? std::max(1.0, std::round(step / 10)) : step / 10;
    }
    double stepped = roundedToDigits(m_value + count * step, kStepDigits);
    if (std::abs(stepped) < step * 1e-6) {
        stepped = 0; // what is left of 0.3 - 0.1 - 0.1 - 0.1
    }
    stepped = std::clamp(stepped, m_minimum, m_maximum);
    // A value already out of range (from a file) must not jump away from the direction asked for.
    const bool moves = count > 0 ? stepped > m_value : stepped < m_value;
    setRejected(false);
    if (moves) {
        m_value = stepped;
        showValue();
        m_stepping = true;
        emit valueEdited(m_value);
        m_stepping = false;
    } else {
        showValue();
    }
}

bool NumberField::event(QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride) {
        return QLineEdit::event(event);
    }
    auto* key = static_cast<QKeyEvent*>(event);
    // With nothing typed, undo is the document's; a space is always the window's.
    const bool foreign = (key->matches(QKeySequence::Undo) && !(isModified() && isUndoAvailable())) ||
                         (key->matches(QKeySequence::Redo) && !(isModified() && isRedoAvailable())) ||
                         key->key() == Qt::Key_Space;
    if (foreign) {
        key->ignore();
        return true;
    }
    switch (key->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Escape:
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        key->accept();
        return true;
    default:
        return QLineEdit::event(event);
    }
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Space:
        event->ignore();
        return;
    case Qt::Key_Up:
    case Qt::Key_Down:
        stepBy(event->key() == Qt::Key_Up ? 1 : -1, event->modifiers());
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (isModified() && !takeText()) {
            selectAll();
            return;
        }
        showValue();
        clearFocus(); // so that the keys of the window work again
        return;
    case Qt::Key_Escape:
        if (isModified()) {
            restore();
            selectAll();
        } else {
            clearFocus();
        }
        return;
    default:
        QLineEdit::keyPressEvent(event);
    }
}

void NumberField::wheelEvent(QWheelEvent* event) {
    if (!hasFocus() || isReadOnly()) {
        event->ignore(); // the panel scrolls
        return;
    }
    // Some systems turn the wheel sideways when a modifier is held.
    const QPoint angle = event->angleDelta();
    m_wheelAngle += angle.y() != 0 ? angle.y() : angle.x();
    const int steps = m_wheelAngle / kWheelStep;
    m_wheelAngle -= steps * kWheelStep;
    stepBy(steps, event->modifiers());
    event->accept();
}

void NumberField::focusInEvent(QFocusEvent* event) {
    m_wheelAngle = 0;
    setRejected(false);
    // The context menu gives focus back to a text being typed.
    if (!isModified()) {
        showValue();
    }
    QLineEdit::focusInEvent(event);
    m_selectOnRelease = event->reason() == Qt::MouseFocusReason;
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() == Qt::PopupFocusReason) {
        return;
    }
    // What Enter rejected is not told a second time.
    if (isModified() && !m_rejected) {
        takeText();
    }
    setModified(true); // whatever is there, even a text that was rejected, gives way to the value
    showValue();
}

void NumberField::mouseReleaseEvent(QMouseEvent* event) {
    QLineEdit::mouseReleaseEvent(event);
    if (m_selectOnRelease && event->button() == Qt::LeftButton && !hasSelectedText()) {
        selectAll();
    }
    m_selectOnRelease = false;
}

void NumberField::updateMargins() {
    const int width = fontMetrics().horizontalAdvance(m_unit);
    setTextMargins(0, 0, m_unit.isEmpty() ? 0 : width + kUnitGap, 0);
}

void NumberField::changeEvent(QEvent* event) {
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        updateMargins();
    }
}

void NumberField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (m_unit.isEmpty()) {
        return;
    }
    QPainter painter(this);
    painter.setPen(isEnabled() ? themeColors().dimText : themeColors().disabledText);
    painter.drawText(rect().adjusted(0, 0, -kUnitGap - 2, 0), Qt::AlignRight | Qt::AlignVCenter, m_unit);
}

void commitFocusedField() {
    if (auto* field = qobject_cast<NumberField*>(QApplication::focusWidget()))
        field->commit();
}

} // namespace clothlab
