// A field for the text of a shader, with colours, line numbers and marked lines.
#pragma once

#include <QList>
#include <QPlainTextEdit>

namespace clothlab {

class GlslHighlighter;

class CodeEdit : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit CodeEdit(QWidget* parent = nullptr);

    void goToLine(int line);               // from 1
    void setMarkedLines(QList<int> lines); // from 1: those with an error
    const QList<int>& markedLines() const { return m_marked; }

signals:
    void saveAsked(); // by Ctrl+S while it has the focus

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    class Margin;
    int marginWidth() const;
    void placeMargin();
    void paintMargin(QPaintEvent* event);
    void markLines();

    Margin* m_margin = nullptr;
    GlslHighlighter* m_highlighter;
    QList<int> m_marked;
};

} // namespace clothlab
