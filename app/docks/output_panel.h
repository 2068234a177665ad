#pragma once

#include <QPlainTextEdit>
#include <QStringList>

namespace clothlab {

// Everything the program has said, with the time, newest last.
class OutputPanel : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit OutputPanel(QWidget* parent = nullptr);
    void add(const QString& message);
};

} // namespace clothlab
