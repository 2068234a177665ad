#pragma once

#include <QWidget>

class QProgressBar;
class QPushButton;

namespace clothlab {

// How far an export is, with a button that cancels it. Hidden while none is under way.
class ExportProgress : public QWidget {
    Q_OBJECT

public:
    explicit ExportProgress(QWidget* parent = nullptr);

    // As high as a line of text: in a status bar that is to stay as high as it is.
    void makeLow();

    void begin(int frames);
    void show(int written);
    void end();
    QPushButton* cancelButton() const { return m_cancel; }
    QString text() const;

signals:
    void cancelAsked();

private:
    QProgressBar* m_bar;
    QPushButton* m_cancel;
};

} // namespace clothlab
