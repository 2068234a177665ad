#pragma once

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QWidget>

namespace clothlab {

// A strip above the view that says what went wrong, until it is closed or something else did; or that offers
// something, with buttons.
class MessageBar : public QWidget {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showProblem(const QString& text);
    void closeProblem(); // not an offer
    // A click on one of the buttons does what it says and closes the strip. Takes ownership of the actions.
    void offer(const QString& text, const QList<QAction*>& answers);
    QString text() const { return isHidden() ? QString() : m_text->text(); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void colorText();
    void showText(const QString& text, const QList<QAction*>& answers);

    QLabel* m_icon = nullptr;
    QLabel* m_text = nullptr;
    QHBoxLayout* m_answers = nullptr;
    bool m_offers = false;
};

} // namespace clothlab
