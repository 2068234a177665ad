// A field for one number.
#pragma once

#include <QLineEdit>

namespace clothlab {

// Shows a number and its unit; takes what is typed exactly as typed, or what an expression gives, on Enter
// and on losing focus. Up, Down and the wheel (only with focus) step by what fits the magnitude: Shift ten
// times that, Ctrl a tenth. Escape restores, and with nothing to restore leaves the field. Without focus the
// text is short (6 significant digits), with focus it is exact. Space is left to the window's shortcuts;
// expressions need none.
//
// What can't be taken (not understood, out of range, not whole in an integer field) leaves the value alone,
// gives the field a red border until it is touched again, and is told by rejected().
class NumberField : public QLineEdit {
    Q_OBJECT

public:
    explicit NumberField(QWidget* parent = nullptr);

    double value() const { return m_value; }

    // Shows the document's value, even one out of range. Emits nothing. While the user is typing only the
    // value changes, not the text; Escape then shows it.
    void setValue(double value);

    // Both ends are allowed; infinite means no end. Does not change the value. minimum <= maximum.
    void setRange(double minimum, double maximum);
    double minimum() const { return m_minimum; }
    double maximum() const { return m_maximum; }

    void setInteger(bool integer);
    bool isInteger() const { return m_integer; }

    // Shown dim at the right edge; may also be typed after the number.
    void setUnit(const QString& unit);
    QString unit() const { return m_unit; }

    // No step is smaller than this, so that steps reach zero and go past it. 0 for a parameter that
    // lives on a logarithmic scale: then steps only follow the magnitude. Default 0. Ctrl goes below it.
    void setSmallestStep(double step);

    // True while valueEdited() tells of a step (key or wheel), false while it tells of a typed value.
    bool isStepping() const { return m_stepping; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public slots:
    // Takes what is typed, as Enter does; for a window that saves while a field has focus.
    void commit();

    // Drops what is typed and not taken, as Escape does.
    void restore();

signals:
    // By the user only, and only if the value is another one.
    void valueEdited(double value);
    void rejected(const QString& message);

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    bool takeText(); // false if rejected
    void stepBy(int count, Qt::KeyboardModifiers modifiers);
    double stepSize(bool towardsZero) const;
    QString rangeMessage(const QString& typed) const;
    void reject(const QString& message);
    void setRejected(bool rejected);
    void showValue();
    void updateMargins();

    double m_value = 0;
    double m_minimum;
    double m_maximum;
    double m_smallestStep = 0;
    bool m_integer = false;
    bool m_stepping = false;
    bool m_rejected = false;
    bool m_selectOnRelease = false; // the click that brought focus selects all
    int m_wheelAngle = 0;           // eighths of a degree not yet turned into a step
    QString m_unit;
};

// Takes what is typed in the field that has the focus, if one has: before a command that is carried out
// without taking the focus away.
void commitFocusedField();

} // namespace clothlab
