#include "app/window/status_line.h"

#include "app/docks/text.h"

#include <QLocale>

namespace clothlab {

StatusLine::StatusLine(Document& document, Simulation& simulation, QWidget* parent)
    : QLabel(parent), m_document(document), m_simulation(simulation) {
    setObjectName("statusLine");
    setToolTip(
        tr("Frame and its simulated time · time it took to compute · size of the sheet · memory of the "
           "recording"));
    connect(&simulation, &Simulation::frameShown, this, &StatusLine::refresh);
    connect(&simulation, &Simulation::recordingChanged, this, &StatusLine::refresh);
    refresh();
}

void StatusLine::refresh() {
    const Frame& frame = *m_simulation.shownFrame();
    const Grid grid = m_document.grid();
    const QString took = m_simulation.currentFrame() == 0
                             ? tr("start")
                             : tr("%1 ms/frame").arg(QString::number(frame.milliseconds, 'f', 1));
    const QStringList parts{tr("frame %1").arg(m_simulation.currentFrame()),
                            QStringLiteral("%1 s").arg(frame.time, 0, 'f', 3),
                            took,
                            tr("%1 points").arg(groupedNumber(grid.pointCount())),
                            tr("%1 springs").arg(groupedNumber(grid.springCount())),
                            QLocale::c().formattedDataSize(qint64(m_simulation.bytesInMemory()), 1)};
    setText(parts.join(QStringLiteral("  ·  ")) + QStringLiteral("  "));
}

} // namespace clothlab
