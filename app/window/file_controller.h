// New, Open, Open Recent, Save and the question before anything is lost.
#pragma once

#include "app/document/document.h"

#include <QMenu>
#include <QObject>
#include <QSettings>

namespace clothlab {

class FileController : public QObject {
    Q_OBJECT

public:
    // Dialogs stand over `window`. Recent files are kept in `settings`.
    FileController(Document& document, QSettings& settings, QWidget& window);

    bool newScene();                // false: the user would rather keep what is open
    bool open(const QString& path); // asks first; false also if the file could not be read
    bool openUnasked(const QString& path);
    bool chooseAndOpen();
    bool save();
    bool saveAs();
    bool mayDiscard(); // asks if there are unsaved changes; saves them if the user says so

    QMenu* recentMenu() { return &m_recentMenu; }
    QStringList recentFiles() const;

signals:
    void notice(const QString& text);
    void problem(const QString& text);

private:
    bool saveTo(const QString& path);
    QString folder() const; // where file choosers begin
    void remember(const QString& path);
    void fillRecentMenu();

    Document& m_document;
    QSettings& m_settings;
    QWidget& m_window;
    QMenu m_recentMenu;
};

} // namespace clothlab
