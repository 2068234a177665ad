// A slider over a range of real numbers.
#pragma once

#include <QSlider>

namespace clothlab {

// Horizontal, linear or logarithmic. A click on the groove takes the handle there at once. It moves by the
// mouse only: wheel and keys belong to the panel and the window. Values come out rounded to what a hand can
// aim at (a thousandth of a linear range, three digits on a logarithmic one); the ends come out exactly.
class ValueSlider : public QSlider {
    Q_OBJECT

public:
    explicit ValueSlider(QWidget* parent = nullptr);

    // minimum < maximum; a logarithmic scale needs minimum > 0, or is linear.
    void setScale(double minimum, double maximum, bool logarithmic, bool integer);

    // Puts the handle there, at an end for what is beyond it. Emits nothing; ignored during a drag.
    void showValue(double value);

    double valueAt(int position) const;
    int positionOf(double value) const;

signals:
    void dragStarted();
    void dragged(double value);
    void dragEnded();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRect handleRect() const;
    void moveTo(int position);

    double m_minimum = 0;
    double m_maximum = 1;
    bool m_logarithmic = false;
    bool m_integer = false;
    int m_pressX = 0; // where the handle was taken, and its position then
    int m_pressPosition = 0;
};

} // namespace clothlab
