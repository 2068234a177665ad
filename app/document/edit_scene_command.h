#pragma once

#include "app/document/document.h"

#include <QUndoCommand>

namespace clothlab {

// Holds the scene that is not shown now: redo and undo both exchange it with the document's.
class EditSceneCommand : public QUndoCommand {
public:
    EditSceneCommand(Document& document, const QString& text, Scene after, int gesture);

    void redo() override { m_document.exchangeScene(m_other); }
    void undo() override { m_document.exchangeScene(m_other); }
    int id() const override { return m_gesture == 0 ? -1 : 1; }
    bool mergeWith(const QUndoCommand* command) override;

    int gesture() const { return m_gesture; }
    const Scene& otherScene() const { return *m_other; } // the one before, while the command is done

private:
    Document& m_document;
    std::shared_ptr<const Scene> m_other;
    int m_gesture;
};

} // namespace clothlab
