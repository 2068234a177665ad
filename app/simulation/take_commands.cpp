#include "app/simulation/take_commands.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace clothlab {

void Simulation::openTake(TakeId id) {
    const TakePointer take = m_recording.findTake(id);
    if (take && take != m_recording.take())
        m_document.undoStack().push(new OpenTakeCommand(
            *this, tr("open %1").arg(QString::fromStdString(take->name())), m_recording.viewOf(take)));
}

void Simulation::renameTake(TakeId id, const QString& name) {
    const TakePointer take = m_recording.findTake(id);
    const std::string text = name.simplified().toStdString();
    if (take && !text.empty() && text != take->name())
        m_document.undoStack().push(new RenameTakeCommand(
            *this, tr("rename %1").arg(QString::fromStdString(take->name())), take, text));
}

// Of the open one: opens the one it branched off or, without one, its neighbour in the list.
void Simulation::deleteTake(TakeId id) {
    const TakePointer take = m_recording.findTake(id);
    const auto& takes = m_recording.takes();
    if (!take || takes.size() < 2)
        return;
    const QString text = tr("delete %1").arg(QString::fromStdString(take->name()));
    QUndoStack& stack = m_document.undoStack();
    stack.beginMacro(text);
    if (take == m_recording.take()) {
        TakePointer next = m_recording.listedParent(*take);
        if (!next)
            next = takes.front() == take ? takes[1] : *std::prev(std::ranges::find(takes, take));
        openTake(next->id());
    }
    stack.push(new DeleteTakeCommand(*this, text, take));
    stack.endMacro();
}

void Simulation::exchangeView(Recording::View& other) {
    Recording::View now = m_recording.view();
    m_opening = &other;
    std::shared_ptr<const Scene> scene = other.scene;
    m_document.exchangeScene(scene); // onSceneChanged() does the rest, before other listeners
    m_opening = nullptr;
    other = std::move(now);
}

void Simulation::exchangeName(const TakePointer& take, std::string& other) {
    std::string now = take->name();
    take->setName(std::exchange(other, std::move(now)));
    tellTake(*take);
    emit takesChanged();
}

bool Simulation::removeTake(const TakePointer& take) {
    const bool removed = m_recording.remove(take);
    tellTake(*take);
    emit takesChanged();
    return removed;
}

void Simulation::insertTake(const TakePointer& take) {
    m_recording.insert(take);
    tellTake(*take);
    emit takesChanged();
}

} // namespace clothlab
