// Widgets side by side, in as many lines as the width needs.
#pragma once

#include <QList>
#include <QWidget>

namespace clothlab {

// Each keeps the size it asks for; none is cut off. The row is as high as its lines.
class FlowRow : public QWidget {
    Q_OBJECT

public:
    explicit FlowRow(QWidget* parent = nullptr) : QWidget(parent) {}

    void add(QWidget* widget);

    QSize sizeHint() const override;        // in one line
    QSize minimumSizeHint() const override; // as wide as its widest

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void place();

    QList<QWidget*> m_widgets;
};

} // namespace clothlab
