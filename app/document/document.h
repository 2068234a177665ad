// The open scene: its values, file, undo stack and selection. Every change of the scene goes through edit().
#pragma once

#include "app/document/selection.h"
#include "simcore/base/diagnostic.h"
#include "simcore/scene/parameters.h"
#include "simcore/scene/scene.h"

#include <QObject>
#include <QString>
#include <QUndoStack>

#include <memory>
#include <optional>

namespace clothlab {

class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    // Names the files of its textures absolutely; its own file names them relative to itself.
    const Scene& scene() const { return *m_scene; }
    std::shared_ptr<const Scene> snapshot() const {
        return m_scene;
    } // never changes; safe to share with a thread
    Grid grid() const { return gridOf(m_scene->cloth); }

    QString path() const { return m_path; } // empty until saved
    QString folder() const;                 // of path(); empty until saved
    QString displayName() const;            // the file's name, or "Untitled"
    bool isModified() const {
        return !m_undoStack.isClean() || m_recovered || (isRecording() && m_recordingModified);
    }
    bool isRecovered() const { return m_recovered; } // from a crash, and not saved since
    bool isRecording() const;                        // its file holds what was recorded, too
    QUndoStack& undoStack() { return m_undoStack; }

    // A new sheet, hung up at two corners. Clears the undo stack, as open() does.
    void newScene();

    // Replaces the scene if the file holds a valid one; otherwise leaves everything as it was.
    // Returns errors and warnings.
    Diagnostics open(const QString& path);

    // Puts a scene in the place of this one, as open() does. path: of its file; empty until it is saved.
    void setScene(Scene scene, const QString& path);
    void setRecovered(); // it is in no file that the user knows

    // Returns what went wrong, in words; nothing if the file was written.
    std::optional<QString> save(const QString& path);
    // Grows with every change of what a file would hold.
    int revision() const { return m_revision; }
    // What was there at that revision is in a file that something else has written.
    void setSaved(const QString& path, int revision);
    // There is more in the recording than in its file.
    void setRecordingModified();

    // Puts `after` in the place of the scene as one undo step. Edits with the same text and the same
    // gesture, not 0, merge into one step. Precondition: validate(after) has no errors.
    void edit(const QString& text, Scene after, int gesture = 0);

    // edit() of one parameter. Does nothing but return why, in words, if the scene would not be valid. With
    // the number of points, pins move to where they were relative to the sheet.
    std::optional<QString> setParameter(const Parameter& parameter, double value, int gesture = 0);

    // For commands on the undo stack only: redo and undo both exchange the scene with the other.
    void exchangeScene(std::shared_ptr<const Scene>& other);

    const Selection& selection() const { return m_selection; }
    void setSelection(Selection selection); // pruned to what the sheet has

signals:
    void sceneChanged(clothlab::SceneChange change); // by an edit, undo or redo; the strongest that applies
    void sceneReplaced();                            // by New or Open
    void fileChanged();                              // path(), displayName() or isModified()
    void selectionChanged();

private:
    const Scene& sceneBefore(int gesture) const;

    std::shared_ptr<const Scene> m_scene;
    QString m_path;
    QUndoStack m_undoStack;
    bool m_recordingModified = false;
    bool m_recovered = false;
    int m_revision = 0;
    Selection m_selection;
};

} // namespace clothlab
