#include "app/docks/output_panel.h"

#include "app/widgets/theme.h"

#include <QFileInfo>
#include <QScrollBar>
#include <QTextCursor>
#include <QTime>
#include <QUrl>

namespace clothlab {

OutputPanel::OutputPanel(QWidget* parent) : QTextBrowser(parent) {
    constexpr int mostLines = 10000;
    setReadOnly(true);
    setUndoRedoEnabled(false);
    document()->setMaximumBlockCount(mostLines);
    setPlaceholderText(tr("Messages appear here."));
    setAccessibleName(tr("Messages"));
    setTabChangesFocus(true);
    setOpenLinks(false);
    connect(this, &QTextBrowser::anchorClicked, this,
            [this](const QUrl& url) { emit openAsked(url.toLocalFile(), url.fragment().toInt()); });
}

// After the last line, with the time; a click elsewhere must not move where new text goes.
QTextCursor OutputPanel::newLine() {
    QTextCursor cursor(document());
    cursor.movePosition(QTextCursor::End);
    if (!document()->isEmpty())
        cursor.insertBlock();
    cursor.setCharFormat({});
    cursor.insertText(QTime::currentTime().toString("HH:mm:ss") + "  ");
    return cursor;
}

void OutputPanel::add(const QString& message) {
    newLine().insertText(message);
    verticalScrollBar()->setValue(verticalScrollBar()->maximum());
}

void OutputPanel::add(const render::Problem& problem) {
    QTextCursor cursor = newLine();
    QUrl url = QUrl::fromLocalFile(problem.path);
    url.setFragment(QString::number(problem.line));
    QTextCharFormat link;
    link.setAnchor(true);
    link.setAnchorHref(url.toString());
    link.setForeground(themeColors().link);
    link.setFontUnderline(true);
    link.setToolTip(tr("Open %1").arg(problem.path));
    const QString file = QFileInfo(problem.path).fileName();
    cursor.insertText(problem.line > 0 ? QStringLiteral("%1:%2").arg(file).arg(problem.line) : file, link);
    cursor.insertText(QStringLiteral(": ") + problem.text, {});
    verticalScrollBar()->setValue(verticalScrollBar()->maximum());
}

} // namespace clothlab
