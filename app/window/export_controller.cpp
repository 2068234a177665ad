#include "app/window/export_controller.h"

#include "app/simulation/take_replay.h"
#include "app/viewport/viewport.h"
#include "app/window/export_dialog.h"
#include "app/window/export_progress.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSet>

#include <algorithm>
#include <utility>

namespace clothlab {

ExportController::ExportController(Document& document, Simulation& simulation, Viewport& viewport,
                                   render::PictureSource pictures, QWidget& window)
    : QObject(&window), m_document(document), m_simulation(simulation), m_viewport(viewport),
      m_pictures(std::move(pictures)), m_window(window), m_status(new ExportProgress(&window)) {
    m_status->makeLow();
    m_status->setToolTip(tr("An export is under way"));
    connect(m_status, &ExportProgress::cancelAsked, this, &ExportController::cancel);
    const auto update = [this] {
        if (m_dialog && m_dialog->isVisible())
            updateFacts();
    };
    connect(&simulation, &Simulation::recordingChanged, this, update);
    connect(&document, &Document::sceneChanged, this, update);
    connect(&document, &Document::fileChanged, this, update);
}

ExportController::~ExportController() = default;

ExportDialog& ExportController::dialog() {
    if (!m_dialog) {
        m_dialog = new ExportDialog(&m_window);
        connect(m_dialog, &ExportDialog::exportAsked, this, &ExportController::begin);
        connect(m_dialog, &ExportDialog::cancelAsked, this, &ExportController::cancel);
        connect(m_dialog, &ExportDialog::shownChanged, this, &ExportController::showProgress);
    }
    return *m_dialog;
}

void ExportController::showDialog() {
    dialog();
    updateFacts();
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void ExportController::updateFacts() {
    const QFileInfo scene(m_document.path());
    ExportFacts facts;
    const Recording& recording = m_simulation.recording();
    const InOutPoints range = recording.take()->marks().range.value_or(InOutPoints{});
    facts.lastFrame = recording.lastFrame();
    facts.in = std::min(range.in, facts.lastFrame);
    facts.out = std::min(range.out, facts.lastFrame);
    facts.framesPerSecond = m_document.scene().simulation.framesPerSecond;
    facts.grid = m_simulation.sheet().grid;
    facts.file = m_document.path().isEmpty() ? QDir::homePath() + "/cloth"
                                             : scene.absolutePath() + '/' + scene.completeBaseName();
    if (!m_viewport.hasPicture())
        facts.whyNoPicture = tr("Pictures need OpenGL, which is not to be had here");
    m_dialog->setFacts(facts);
}

// Files get exact positions; what pictures get differs by less than anyone could see.
FrameSource ExportController::frameSource(ExportKind kind) const {
    const auto replay = std::make_shared<TakeReplay>(*m_simulation.recording().take());
    return {replay->frameCount(), replay->sheet(),
            [replay, exact = !hasPictures(kind)](int frame, std::string& reason) {
                return exact ? replay->exactFrame(frame, reason) : replay->roughFrame(frame, reason);
            }};
}

std::unique_ptr<FramePainter> ExportController::painter(const ExportRequest& request) {
    if (!hasPictures(request.kind))
        return nullptr;
    PictureLook look;
    look.frame = m_viewport.frameFor(request.size);
    look.frame.highlight = {}; // it has the places of one frame
    look.scene = m_document.snapshot();
    look.sheet = m_simulation.sheet();
    look.size = request.size;
    look.source = m_pictures;
    return makeFramePainter(std::move(look));
}

bool ExportController::mayReplace(const ExportRequest& request) {
    // All in one folder, which is read once: a sequence may have very many files.
    const QStringList names = QFileInfo(request.path).dir().entryList(QDir::AllEntries | QDir::Hidden);
    const QSet<QString> inFolder(names.begin(), names.end());
    QStringList there;
    for (const QString& file : filesOf(request))
        if (const QString name = file.section('/', -1); inFolder.contains(name))
            there << name;
    if (there.isEmpty())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Replace files"),
                    there.size() == 1 ? tr("%1 is already there. Replace it?").arg(there[0])
                                      : tr("%1 of the files are already there, such as %2. Replace them?")
                                            .arg(there.size())
                                            .arg(there[0]),
                    QMessageBox::Yes | QMessageBox::Cancel, &dialog());
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(there.size() == 1 ? tr("It stays as it is until the export is complete.")
                                             : tr("They stay as they are until the export is complete."));
    box.setDefaultButton(QMessageBox::Cancel);
    box.button(QMessageBox::Yes)->setText(tr("Replace"));
    return box.exec() == QMessageBox::Yes;
}

void ExportController::begin(const ExportRequest& request) {
    if (isRunning() || !mayReplace(request))
        return;
    m_job = std::make_unique<ExportJob>(frameSource(request.kind), request, painter(request));
    connect(m_job.get(), &ExportJob::progressed, this, [this](int written) {
        m_written = written;
        showProgress();
    });
    connect(m_job.get(), &ExportJob::ended, this, &ExportController::onEnded);
    m_written = 0;
    dialog().begin(m_job->total());
    m_status->begin(m_job->total());
    showProgress();
    m_job->start();
}

void ExportController::showProgress() {
    m_status->setVisible(isRunning() && !m_dialog->isVisible());
    if (m_dialog->isVisible())
        m_dialog->showProgress(m_written);
    else
        m_status->show(m_written);
}

void ExportController::cancel() {
    if (m_job)
        m_job->cancel();
}

void ExportController::onEnded(const ExportResult& result) {
    const ExportRequest& request = m_job->request();
    QString path = QDir::toNativeSeparators(request.path);
    if (isSequence(request.kind) && result.written > 0) // no file has the name without a number
        path = tr("%1 … %2").arg(
            QDir::toNativeSeparators(sequencePath(request.path, 0, result.written)),
            QFileInfo(sequencePath(request.path, result.written - 1, result.written)).fileName());
    // Later: it is the job that tells.
    std::exchange(m_job, nullptr).release()->deleteLater();
    m_status->end();
    QString text;
    if (result.end == ExportEnd::Done)
        text = result.written == 1 ? tr("Exported 1 frame to %1").arg(path)
                                   : tr("Exported %1 frames to %2").arg(result.written).arg(path);
    else if (result.end == ExportEnd::Cancelled)
        text = tr("The export was cancelled; nothing was written.");
    else
        text = tr("Nothing was exported. %1").arg(QString::fromStdString(result.reason));
    const bool good = result.end == ExportEnd::Done || result.end == ExportEnd::Cancelled;
    dialog().end(text, good);
    if (good)
        emit notice(text);
    else
        emit problem(text);
}

bool ExportController::mayClose() {
    if (!isRunning())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Export under way"),
                    tr("Cancel the export and close the window?"), QMessageBox::Yes | QMessageBox::No,
                    &m_window);
    box.setInformativeText(tr("Nothing of it stays."));
    box.setDefaultButton(QMessageBox::No);
    if (box.exec() == QMessageBox::Yes)
        cancel();
    else if (isRunning())
        return false;
    return true;
}

} // namespace clothlab
