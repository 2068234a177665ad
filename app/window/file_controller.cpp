#include "app/window/file_controller.h"

#include "app/document/data_files.h"
#include "app/widgets/number_field.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

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

} // namespace

FileController::FileController(Document& document, QSettings& settings, QWidget& window)
    : QObject(&window), m_document(document), m_settings(settings), m_window(window),
      m_recentMenu(tr("Open &Recent")) {
    connect(&m_recentMenu, &QMenu::aboutToShow, this, &FileController::fillRecentMenu);
    fillRecentMenu();
}

bool FileController::mayDiscard() {
    // What is typed and not yet taken belongs to the scene, too.
    commitFocusedField();
    if (!m_document.isModified())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Save the changes to %1?").arg(m_document.displayName()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    box.setInformativeText(tr("They are lost otherwise."));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
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
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open a scene"), folder(),
                                                      tr("Scenes (*.json);;All files (*)"));
    return !path.isEmpty() && openUnasked(path);
}

bool FileController::save() {
    return m_document.path().isEmpty() ? saveAs() : saveTo(m_document.path());
}

bool FileController::saveAs() {
    const QString proposal = m_document.path().isEmpty() ? folder() + "/untitled.json" : m_document.path();
    QString path = QFileDialog::getSaveFileName(&m_window, tr("Save the scene"), proposal,
                                                tr("Scenes (*.json);;All files (*)"));
    if (path.isEmpty())
        return false;
    if (QFileInfo(path).suffix().isEmpty())
        path += ".json";
    return saveTo(path);
}

bool FileController::saveTo(const QString& path) {
    commitFocusedField();
    if (const auto error = m_document.save(path)) {
        emit problem(tr("The scene was not saved. %1: %2").arg(QDir::toNativeSeparators(path), *error));
        return false;
    }
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
