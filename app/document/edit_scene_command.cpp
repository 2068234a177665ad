#include "app/document/edit_scene_command.h"

#include <utility>

namespace clothlab {

EditSceneCommand::EditSceneCommand(Document& document, const QString& text, Scene after, int gesture)
    : QUndoCommand(text), m_document(document), m_other(std::make_shared<const Scene>(std::move(after))),
      m_gesture(gesture) {}

bool EditSceneCommand::mergeWith(const QUndoCommand* command) {
    const auto* later = dynamic_cast<const EditSceneCommand*>(command);
    if (!later || later->m_gesture != m_gesture || later->text() != text())
        return false;
    // The later one is done already; this one goes on holding the scene from before both.
    setObsolete(*m_other == m_document.scene());
    return true;
}

} // namespace clothlab
