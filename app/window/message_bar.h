#pragma once

#include <QLabel>
#include <QWidget>

namespace clothlab {

// A strip above the view that says what went wrong, until it is closed or something else did.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showProblem(const QString& text);
    QString text() const { return isHidden() ? QString() : m_text->text(); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void colorText();

    QLabel* m_icon = nullptr;
    QLabel* m_text = nullptr;
};

} // namespace clothlab
