#include "app/docks/output_panel.h"

#include <QTime>

namespace clothlab {

OutputPanel::OutputPanel(QWidget* parent) : QPlainTextEdit(parent) {
    constexpr int mostLines = 10000;
    setReadOnly(true);
    setMaximumBlockCount(mostLines);
    setPlaceholderText(tr("Messages appear here."));
    setAccessibleName(tr("Messages"));
    setTabChangesFocus(true);
}

void OutputPanel::add(const QString& message) {
    appendPlainText(QTime::currentTime().toString("HH:mm:ss") + "  " + message);
}

} // namespace clothlab
