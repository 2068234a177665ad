#include "app/window/export_dialog.h"

#include "app/widgets/number_field.h"
#include "app/widgets/theme.h"
#include "app/window/export_progress.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QStandardItemModel>

#include <algorithm>

namespace clothlab {

ExportDialog::ExportDialog(QWidget* parent)
    : QDialog(parent), m_kind(new QComboBox), m_path(new QLineEdit), m_choose(new QPushButton(tr("Choose…"))),
      m_first(new NumberField), m_last(new NumberField), m_every(new NumberField), m_up(new QComboBox),
      m_scale(new NumberField), m_width(new NumberField), m_height(new NumberField),
      m_framesPerSecond(new NumberField), m_summary(new QLabel), m_result(new QLabel),
      m_progress(new ExportProgress), m_export(new QPushButton(tr("Export"))) {
    setObjectName("exportDialog");
    setWindowTitle(tr("Export"));
    makeFields();
    layOut();
    connectFields();
    fillKinds();
    refresh();
}

void ExportDialog::setFacts(const ExportFacts& facts) {
    const bool kindsAsBefore = facts.whyNoPicture == m_facts.whyNoPicture;
    m_facts = facts;
    m_first->setRange(0, facts.lastFrame);
    m_last->setRange(0, facts.lastFrame);
    const auto follow = [&](NumberField* field, bool& chosen, int proposed) {
        chosen = chosen && field->value() <= facts.lastFrame;
        if (!chosen)
            field->setValue(proposed);
    };
    follow(m_first, m_firstChosen, facts.in);
    follow(m_last, m_lastChosen, facts.out);
    if (!m_pathChosen)
        m_path->setText(QDir::toNativeSeparators(facts.file + ending(request().kind)));
    if (!kindsAsBefore)
        fillKinds();
    refresh();
}

ExportRequest ExportDialog::request() const {
    ExportRequest request;
    request.kind = ExportKind(std::max(0, m_kind->currentIndex()));
    QString path = QDir::fromNativeSeparators(m_path->text());
    if (!path.isEmpty()) {
        path = QDir::cleanPath(QFileInfo(m_facts.file).absoluteDir().absoluteFilePath(path));
        if (!path.endsWith(ending(request.kind), Qt::CaseInsensitive))
            path += ending(request.kind);
    }
    request.path = path;
    request.frames = {int(m_first->value()), int(m_last->value()), m_every->value()};
    request.placement = {m_up->currentIndex() == 0 ? UpAxis::Y : UpAxis::Z, m_scale->value()};
    request.size = {int(m_width->value()), int(m_height->value())};
    if (isVideo(request.kind))
        request.size = evenSize(request.size);
    request.framesPerSecond = m_framesPerSecond->value();
    return request;
}

QString ExportDialog::summary() const {
    return m_summary->text();
}

QString ExportDialog::resultText() const {
    return m_result->text();
}

// Which formats can be used; the chosen one stays chosen.
void ExportDialog::fillKinds() {
    auto* model = qobject_cast<QStandardItemModel*>(m_kind->model());
    for (int i = 0; i < kExportKinds; ++i) {
        const auto kind = ExportKind(i);
        const QString reason =
            hasPictures(kind) && !m_facts.whyNoPicture.isEmpty() ? m_facts.whyNoPicture : whyNot(kind);
        QStandardItem* item = model->item(i);
        item->setEnabled(reason.isEmpty());
        item->setToolTip(reason.isEmpty() ? about(kind) : reason);
    }
}

void ExportDialog::chooseFile() {
    const ExportRequest now = request();
    // The question about files that are there comes once, before the export, and about all of them.
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Export to"), now.path, QStringLiteral("%1 (*%2)").arg(title(now.kind), ending(now.kind)),
        nullptr, QFileDialog::DontConfirmOverwrite);
    if (path.isEmpty())
        return;
    m_pathChosen = true;
    m_path->setText(QDir::toNativeSeparators(path));
    refresh();
}

void ExportDialog::askForExport() {
    for (NumberField* field : {m_first, m_last, m_every, m_scale, m_width, m_height, m_framesPerSecond})
        field->commit();
    refresh();
    if (m_export->isEnabled())
        emit exportAsked(request());
}

void ExportDialog::refresh() {
    const ExportKind kind = request().kind;
    if (!m_everyChosen)
        m_every->setValue(isVideo(kind) ? videoStep(m_facts.framesPerSecond) : 1);
    if (!m_paceChosen)
        m_framesPerSecond->setValue(m_facts.framesPerSecond / m_every->value());
    m_form->setRowVisible(m_placementRow, hasPlacement(kind));
    m_form->setRowVisible(m_sizeRow, hasPictures(kind));
    m_form->setRowVisible(m_framesPerSecond, isVideo(kind));
    m_kind->setToolTip(about(kind));
    const ExportRequest now = request();
    m_summary->setText(contents(now));
    m_export->setEnabled(!m_running && !now.path.isEmpty() && now.frames.count() > 0 &&
                         m_kind->model()->index(int(kind), 0).flags().testFlag(Qt::ItemIsEnabled));
}

QString ExportDialog::contents(const ExportRequest& request) const {
    if (request.path.isEmpty())
        return tr("Name a file.");
    const int count = request.frames.count();
    if (count == 0)
        return tr("The last frame comes before the first.");
    QStringList parts;
    if (isSequence(request.kind)) {
        const auto name = [&](int number) {
            return QFileInfo(sequencePath(request.path, number, count)).fileName();
        };
        parts << (count == 1 ? tr("1 file, %1").arg(name(0))
                             : tr("%1 files, %2 to %3").arg(count).arg(name(0), name(count - 1)));
    } else if (isVideo(request.kind)) {
        parts << pace(request);
    } else {
        parts << (count == 1 ? tr("1 frame") : tr("%1 frames").arg(count));
        if (const QStringList files = filesOf(request); files.size() > 1)
            parts << tr("%1 beside it").arg(QFileInfo(files[1]).fileName());
    }
    if (hasPictures(request.kind))
        parts << tr("%1 × %2 pixels").arg(request.size.width()).arg(request.size.height());
    if (const double bytes = estimatedBytes(request, m_facts.grid); bytes > 0)
        parts << tr("about %1").arg(QLocale::c().formattedDataSize(qint64(bytes), 1));
    return parts.join(QStringLiteral("  ·  "));
}

// "91 frames, 3.03 s in real time".
QString ExportDialog::pace(const ExportRequest& request) const {
    const int count = request.frames.count();
    const double seconds = count / request.framesPerSecond;
    const double speed = request.framesPerSecond * request.frames.step / m_facts.framesPerSecond;
    const QString length = tr("%1 frames, %2 s").arg(count).arg(QString::number(seconds, 'f', 2));
    return std::abs(speed - 1) < 1e-6
               ? tr("%1 in real time").arg(length)
               : tr("%1 at %2 × real time").arg(length, QString::number(speed, 'g', 3));
}

void ExportDialog::begin(int frames) {
    m_running = true;
    m_result->clear();
    m_result->hide();
    m_progress->begin(frames);
    refresh();
}

void ExportDialog::showProgress(int written) {
    m_progress->show(written);
}

void ExportDialog::end(const QString& text, bool good) {
    m_running = false;
    m_resultGood = good;
    m_progress->end();
    m_result->setText(text);
    m_result->show();
    colorResult();
    refresh();
    // A long text must not squeeze the fields.
    if (const int needed = layout()->totalHeightForWidth(width()); needed > height())
        resize(width(), needed);
}

void ExportDialog::colorResult() {
    QPalette palette; // the theme's, where nothing is set
    if (!m_resultGood)
        palette.setColor(QPalette::WindowText, themeColors().error);
    m_result->setPalette(palette);
}

void ExportDialog::showEvent(QShowEvent* event) {
    fillKinds(); // ffmpeg may have been installed meanwhile
    refresh();
    QDialog::showEvent(event);
    emit shownChanged(true);
}

void ExportDialog::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    emit shownChanged(false);
}

void ExportDialog::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange && m_result)
        colorResult();
    QDialog::changeEvent(event);
}

} // namespace clothlab
