// Someone who answers the next modal dialog, so that a test can do what opens one.
#pragma once

#include <QApplication>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <functional>

namespace clothlab {

class DialogAnswer : public QObject {
public:
    explicit DialogAnswer(std::function<void(QDialog&)> answer) : m_answer(std::move(answer)) {
        // Dialogs open in event loops of their own, which this timer runs in.
        connect(&m_timer, &QTimer::timeout, this, &DialogAnswer::look);
        m_timer.start(5);
    }

    // Clicks that button of a question.
    explicit DialogAnswer(QMessageBox::StandardButton button)
        : DialogAnswer([button](QDialog& dialog) {
              auto* box = qobject_cast<QMessageBox*>(&dialog);
              if (box && box->button(button))
                  QTest::mouseClick(box->button(button), Qt::LeftButton);
          }) {}

    bool asked() const { return !m_title.isEmpty(); }
    QString title() const { return m_title; }
    QString text() const { return m_text; } // of a question

private:
    void look() {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog || !dialog->isVisible())
            return;
        m_timer.stop();
        m_title = dialog->windowTitle().isEmpty() ? QStringLiteral("dialog") : dialog->windowTitle();
        if (const auto* box = qobject_cast<QMessageBox*>(dialog))
            m_text = box->text();
        m_answer(*dialog);
        if (!dialog->isVisible())
            return;
        // Rather a failed test than one that hangs.
        qWarning("the dialog \"%s\" did not take the answer", qPrintable(m_title));
        m_title.clear();
        dialog->reject();
    }

    std::function<void(QDialog&)> m_answer;
    QTimer m_timer;
    QString m_title, m_text;
};

// Enters a file's name into a file chooser and clicks Open or Save. Typed keys would go to the list of
// completions that opens meanwhile.
inline std::function<void(QDialog&)> chooseFile(const QString& path) {
    return [path](QDialog& dialog) {
        auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
        auto* buttons = dialog.findChild<QDialogButtonBox*>();
        if (!name || !buttons)
            return;
        name->setText(path);
        for (QAbstractButton* button : buttons->buttons())
            if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
                QTest::mouseClick(button, Qt::LeftButton);
    };
}

inline std::function<void(QDialog&)> pressEscape() {
    return [](QDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); };
}

} // namespace clothlab
