#include "app/window/export_progress.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace clothlab {

ExportProgress::ExportProgress(QWidget* parent)
    : QWidget(parent), m_bar(new QProgressBar), m_cancel(new QPushButton(tr("Cancel"))) {
    m_bar->setMinimumWidth(fontMetrics().horizontalAdvance(tr("frame %1 of %2").arg(100000).arg(100000)) +
                           16);
    m_bar->setAccessibleName(tr("Progress of the export"));
    m_cancel->setFocusPolicy(Qt::TabFocus);
    m_cancel->setAutoDefault(false);
    m_cancel->setToolTip(tr("Stop the export; nothing of it stays"));
    connect(m_cancel, &QPushButton::clicked, this, &ExportProgress::cancelAsked);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_bar, 1);
    layout->addWidget(m_cancel);
    hide();
}

void ExportProgress::makeLow() {
    for (QWidget* widget : {static_cast<QWidget*>(m_bar), static_cast<QWidget*>(m_cancel)})
        widget->setStyleSheet(QStringLiteral("min-height: 0; padding: 0 8px;"));
    setMaximumHeight(fontMetrics().height());
}

void ExportProgress::begin(int frames) {
    m_bar->setRange(0, frames);
    m_cancel->setEnabled(true);
    show(0);
    setVisible(true);
}

void ExportProgress::show(int written) {
    m_bar->setValue(written);
    const bool closing = written == m_bar->maximum();
    m_bar->setFormat(closing ? tr("completing the file") : tr("frame %v of %m"));
}

void ExportProgress::end() {
    hide();
}

QString ExportProgress::text() const {
    return m_bar->text();
}

} // namespace clothlab
