// A label that changes what it labels when it is dragged sideways.
#pragma once

#include <QLabel>

namespace clothlab {

// Right-aligned, ends in an ellipsis where it is too narrow. A drag begins after the system's drag distance,
// so that a double click is none.
class DragLabel : public QLabel {
    Q_OBJECT

public:
    explicit DragLabel(const QString& text, QWidget* parent = nullptr);

signals:
    void dragStarted();
    // Pixels to the right since the drag began; those made with Shift count ten times, with Ctrl a tenth.
    void dragged(double pixels);
    void dragEnded();
    void doubleClicked();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    bool m_pressed = false;
    bool m_dragging = false;
    double m_lastX = 0;
    double m_pixels = 0;
};

} // namespace clothlab
