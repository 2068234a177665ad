#pragma once

#include "app/render/problem.h"

#include <QTextBrowser>

namespace clothlab {

// Everything the program has said, with the time, newest last. A click on the place of a problem opens it.
class OutputPanel : public QTextBrowser {
    Q_OBJECT

public:
    explicit OutputPanel(QWidget* parent = nullptr);
    void add(const QString& message);
    void add(const render::Problem& problem);

signals:
    void openAsked(const QString& path, int line); // line 0: the file as a whole

private:
    QTextCursor newLine();
};

} // namespace clothlab
