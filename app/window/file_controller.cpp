#include "app/window/file_controller.h"

#include "app/document/data_files.h"
#include "app/document/scene_files.h"
#include "app/widgets/number_field.h"
#include "simcore/recording/recording_contents.h"

#include <QApplication>
#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <future>

namespace clothlab {
namespace {

constexpr int kMostRecentFiles = 10;
const QString kRecentKey = QStringLiteral("recentFiles");

QString textOf(const Diagnostics& diagnostics, const QString& path, Severity severity) {
    QStringList lines;
    for (const Diagnostic& diagnostic : diagnostics)
        if (diagnostic.severity == severity)
            lines << QString::fromStdString(toText(diagnostic, QDir::toNativeSeparators(path).toStdString()));
    constexpr int most = 8;
    if (lines.size() > most) {
        const auto more = lines.size() - most;
        lines = lines.mid(0, most) << FileController::tr("… and %1 more").arg(more);
    }
    return lines.join('\n');
}

const QString kRecordingEnding = QStringLiteral(".clothtake");

bool isRecordingName(const QString& path) {
    return path.endsWith(kRecordingEnding, Qt::CaseInsensitive);
}

} // namespace

FileController::FileController(Document& document, Simulation& simulation, QSettings& settings,
                               QWidget& window)
    : QObject(&window), m_document(document), m_simulation(simulation), m_settings(settings),
      m_window(window), m_recentMenu(tr("Open &Recent")) {
    connect(&m_recentMenu, &QMenu::aboutToShow, this, &FileController::fillRecentMenu);
    fillRecentMenu();
}

bool FileController::mayDiscard() {
    if (m_saving) {
        emit notice(tr("The recording is being saved; wait until it is."));
        return false;
    }
    // What is typed and not yet taken belongs to the scene, too.
    commitFocusedField();
    const bool changes = m_document.isModified();
    const bool recording = isRecordingUnsaved();
    if (!changes && !recording)
        return true;
    const QString question = changes ? tr("Save the changes to %1?") : tr("Save the recording of %1?");
    QMessageBox box(QMessageBox::Question, changes ? tr("Unsaved changes") : tr("Unsaved recording"),
                    question.arg(m_document.displayName()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    box.setInformativeText(recording ? tr("The recording is in no file yet, and is lost otherwise.")
                                     : tr("They are lost otherwise."));
    box.setDefaultButton(QMessageBox::Save);
    const QAbstractButton* sceneOnly = nullptr;
    if (recording) {
        box.button(QMessageBox::Save)->setText(tr("Save with &Recording…"));
        if (changes)
            sceneOnly = box.addButton(tr("Save &Scene Only"), QMessageBox::AcceptRole);
    }
    const int answer = box.exec();
    if (sceneOnly != nullptr && box.clickedButton() == sceneOnly)
        return save();
    if (answer == QMessageBox::Save)
        return recording ? saveRecordingAs() : save();
    return answer == QMessageBox::Discard;
}

bool FileController::isRecordingUnsaved() const {
    return !m_document.isRecording() && !m_document.isRecovered() && m_simulation.isWorthSaving();
}

bool FileController::newScene() {
    if (!mayDiscard())
        return false;
    m_document.newScene();
    emit notice(tr("New scene"));
    return true;
}

bool FileController::open(const QString& path) {
    return mayDiscard() && openUnasked(path);
}

bool FileController::openUnasked(const QString& path) {
    if (isRecordingName(path))
        return openRecording(path);
    const Diagnostics diagnostics = m_document.open(path);
    if (hasErrors(diagnostics)) {
        emit problem(tr("The scene was not opened. %1").arg(textOf(diagnostics, path, Severity::Error)));
        return false;
    }
    remember(m_document.path());
    const QString warnings = textOf(diagnostics, path, Severity::Warning);
    emit notice(warnings.isEmpty()
                    ? tr("Opened %1").arg(m_document.displayName())
                    : tr("Opened %1 with warnings:\n%2").arg(m_document.displayName(), warnings));
    return true;
}

bool FileController::chooseAndOpen() {
    if (!mayDiscard())
        return false;
    const QString path =
        QFileDialog::getOpenFileName(&m_window, tr("Open a scene or a recording"), folder(),
                                     tr("Scenes and recordings (*.json *.clothtake);;All files (*)"));
    return !path.isEmpty() && openUnasked(path);
}

bool FileController::save() {
    return m_document.path().isEmpty() ? saveAs() : saveTo(m_document.path());
}

bool FileController::saveAs() {
    if (m_document.isRecovered())
        return saveRecordingAs();
    return chooseAndSave(tr("Save the scene"),
                         tr("Scenes (*.json);;Scenes with their recording (*.clothtake);;All files (*)"),
                         QStringLiteral(".json"));
}

bool FileController::saveRecordingAs() {
    return chooseAndSave(tr("Save the scene with its recording"), tr("Recordings (*.clothtake)"),
                         kRecordingEnding);
}

bool FileController::chooseAndSave(const QString& title, const QString& filters, const QString& ending) {
    QString proposal = m_document.path().isEmpty() ? folder() + "/untitled" + ending : m_document.path();
    if (isRecordingName(ending) && !isRecordingName(proposal))
        proposal = QFileInfo(proposal).absolutePath() + '/' + QFileInfo(proposal).completeBaseName() + ending;
    QString chosen;
    QString path = QFileDialog::getSaveFileName(&m_window, title, proposal, filters, &chosen);
    if (path.isEmpty())
        return false;
    if (QFileInfo(path).suffix().isEmpty() || (isRecordingName(ending) && !isRecordingName(path)))
        path += chosen.contains(kRecordingEnding) ? kRecordingEnding : ending;
    return saveTo(path);
}

bool FileController::saveTo(const QString& path) {
    commitFocusedField();
    if (isRecordingName(path))
        return saveRecording(path);
    if (const auto error = m_document.save(path)) {
        emit problem(tr("The scene was not saved. %1: %2").arg(QDir::toNativeSeparators(path), *error));
        return false;
    }
    remember(m_document.path());
    emit notice(tr("Saved %1").arg(m_document.displayName()));
    return true;
}

// from: the file that was read. path: of the document from now on.
bool FileController::loadRecording(TakeFileReading reading, const QString& from, const QString& path,
                                   QString& warnings) {
    if (!reading.contents || reading.contents->takes.empty()) {
        const QString why = textOf(reading.diagnostics, from, Severity::Error);
        emit problem(tr("The recording was not opened. %1")
                         .arg(why.isEmpty() ? tr("%1: there is no frame in it.").arg(from) : why));
        return false;
    }
    const QString folder = QFileInfo(from).absolutePath();
    for (auto& [id, scene] : reading.contents->scenes)
        scene = std::make_shared<const Scene>(withAbsoluteFiles(*scene, folder));
    const LoadedTakes loaded = takesOf(*reading.contents);
    m_document.setScene(*loaded.scene, path);
    m_simulation.load(loaded, std::move(*reading.contents));
    warnings = textOf(reading.diagnostics, from, Severity::Warning);
    return true;
}

bool FileController::openRecording(const QString& path) {
    QString warnings;
    if (!loadRecording(readTakeFile(path.toStdString()), path, QFileInfo(path).absoluteFilePath(), warnings))
        return false;
    remember(m_document.path());
    emit notice(tr("Opened %1").arg(m_document.displayName()));
    if (!warnings.isEmpty())
        emit problem(warnings);
    return true;
}

bool FileController::openRecovered(const QString& journal) {
    QString warnings; // that it ends without an end is what it is here for
    TakeFileReading reading = readTakeFile(journal.toStdString());
    if (reading.contents) { // where the run was when it ended
        const auto listed = [](const RecordedTake& take) { return !take.info.hidden; };
        const auto& takes = reading.contents->takes;
        if (const auto last = std::find_if(takes.rbegin(), takes.rend(), listed); last != takes.rend()) {
            reading.contents->meta.activeTake = last->info.id;
            reading.contents->meta.shownFrame = last->end() - 1;
        }
    }
    if (!mayDiscard() || !loadRecording(std::move(reading), journal, {}, warnings))
        return false;
    m_document.setRecovered();
    emit notice(tr("Recovered. Save it to keep it."));
    return true;
}

// On a thread of its own, while the window goes on; it returns when that is done.
bool FileController::saveRecording(const QString& path) {
    if (m_saving) {
        emit notice(tr("The recording is being saved; wait until it is."));
        return false;
    }
    m_saving = true;
    struct Saving {
        QEventLoop loop;
        int revision = 0;
        std::future<std::optional<std::string>> result;
    };
    const auto saving = std::make_shared<Saving>();
    m_simulation.gatherContents([this, saving, path](TakeFileContents contents) {
        saving->revision = m_document.revision();
        const QString folder = QFileInfo(path).absolutePath();
        for (auto& [id, scene] : contents.scenes)
            scene = std::make_shared<const Scene>(withRelativeFiles(*scene, folder));
        saving->result = std::async(std::launch::async, [this, saving, path, contents = std::move(contents)] {
            auto error = writeTakeFile(path.toStdString(), contents, [this](double share) {
                emit savingProgress(int(100 * share));
                return true;
            });
            QMetaObject::invokeMethod(&saving->loop, &QEventLoop::quit, Qt::QueuedConnection);
            return error;
        });
    });
    saving->loop.exec();
    m_saving = false;
    if (!saving->result.valid()) // the program ends
        return false;
    if (const auto error = saving->result.get()) {
        emit problem(tr("The recording was not saved. %1: %2")
                         .arg(QDir::toNativeSeparators(path), QString::fromStdString(*error)));
        return false;
    }
    m_document.setSaved(path, saving->revision);
    m_simulation.setSaved();
    remember(m_document.path());
    emit notice(tr("Saved %1").arg(m_document.displayName()));
    return true;
}

QString FileController::folder() const {
    if (!m_document.path().isEmpty())
        return QFileInfo(m_document.path()).absolutePath();
    const QStringList recent = recentFiles();
    if (!recent.isEmpty())
        return QFileInfo(recent.constFirst()).absolutePath();
    const QString scenes = dataDirectory("scenes");
    return scenes.isEmpty() ? QDir::homePath() : scenes;
}

QStringList FileController::recentFiles() const {
    return m_settings.value(kRecentKey).toStringList();
}

void FileController::remember(const QString& path) {
    QStringList recent = recentFiles();
    recent.removeAll(path);
    recent.prepend(path);
    m_settings.setValue(kRecentKey, recent.mid(0, kMostRecentFiles));
    fillRecentMenu();
}

void FileController::fillRecentMenu() {
    m_recentMenu.clear();
    for (const QString& path : recentFiles()) {
        QAction* action = m_recentMenu.addAction(QFileInfo(path).fileName());
        action->setToolTip(path);
        action->setEnabled(QFileInfo::exists(path));
        if (!action->isEnabled())
            action->setToolTip(tr("%1 is not there any more").arg(path));
        connect(action, &QAction::triggered, this, [this, path] { open(path); });
    }
    m_recentMenu.setToolTipsVisible(true);
    if (m_recentMenu.isEmpty())
        m_recentMenu.addAction(tr("Nothing opened yet"))->setEnabled(false);
}

} // namespace clothlab
