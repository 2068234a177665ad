// New, Open, Open Recent, Save and the question before anything is lost.
#pragma once

#include "app/simulation/simulation.h"

#include <QMenu>
#include <QObject>
#include <QSettings>

namespace clothlab {

class FileController : public QObject {
    Q_OBJECT

public:
    // Dialogs stand over `window`. Recent files are kept in `settings`.
    FileController(Document& document, Simulation& simulation, QSettings& settings, QWidget& window);

    bool newScene();                // false: the user would rather keep what is open
    bool open(const QString& path); // asks first; false also if the file could not be read
    bool openUnasked(const QString& path);
    // What a crash has left. It has no file until it is saved.
    bool openRecovered(const QString& journal);
    bool chooseAndOpen();
    bool save();
    bool saveAs();          // of a scene alone or, by the ending of its name, with the recording
    bool saveRecordingAs(); // both
    bool saveTo(const QString& path);
    bool isSaving() const { return m_saving; } // a recording, while the window goes on
    // Asks if something is in no file, changes or a recording that is worth it; saves it if the user says so.
    bool mayDiscard();

    QMenu* recentMenu() { return &m_recentMenu; }
    QStringList recentFiles() const;

signals:
    void notice(const QString& text);
    void problem(const QString& text);
    void savingProgress(int percent);

private:
    bool openRecording(const QString& path);
    bool loadRecording(TakeFileReading reading, const QString& from, const QString& path, QString& warnings);
    bool saveRecording(const QString& path);
    bool isRecordingUnsaved() const; // of a scene that is kept without it
    bool chooseAndSave(const QString& title, const QString& filters, const QString& ending);
    QString folder() const; // where file choosers begin
    void remember(const QString& path);
    void fillRecentMenu();

    Document& m_document;
    Simulation& m_simulation;
    QSettings& m_settings;
    QWidget& m_window;
    QMenu m_recentMenu;
    bool m_saving = false;
};

} // namespace clothlab
