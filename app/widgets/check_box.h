#pragma once

#include <QCheckBox>
#include <QKeyEvent>

namespace clothlab {

// A check box for a window in which Space plays: Enter ticks it.
class CheckBox : public QCheckBox {
public:
    using QCheckBox::QCheckBox;

protected:
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
            click();
        else
            QCheckBox::keyPressEvent(event);
    }
};

} // namespace clothlab
