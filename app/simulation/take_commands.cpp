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

void Simulation::setMarks(const QString& text, TakeMarks marks, int gesture) {
    if (marks != this->marks())
        m_document.undoStack().push(
            new MarksCommand(*this, text, m_recording.take(), std::move(marks), gesture));
}

void Simulation::setMarker(int frame, const QString& name) {
    const std::string text = name.simplified().toStdString();
    if (text.empty() || frame < 0 || frame > m_recording.lastFrame())
        return;
    TakeMarks changed = marks();
    const bool isNew = !findMarker(changed, frame);
    clothlab::setMarker(changed, {frame, text});
    setMarks(isNew ? tr("add a marker") : tr("rename a marker"), std::move(changed));
}

void Simulation::removeMarker(int frame) {
    TakeMarks changed = marks();
    clothlab::removeMarker(changed, frame);
    setMarks(tr("remove a marker"), std::move(changed));
}

void Simulation::setInPoint(int frame, int gesture) {
    TakeMarks changed = marks();
    InOutPoints range = changed.range.value_or(InOutPoints{});
    range.in = frame;
    if (range.out < frame)
        range.out = kOpenEnd;
    changed.range = range == InOutPoints{} ? std::nullopt : std::optional(range);
    setMarks(tr("set the in point"), std::move(changed), gesture);
}

void Simulation::setOutPoint(int frame, int gesture) {
    TakeMarks changed = marks();
    InOutPoints range = changed.range.value_or(InOutPoints{});
    range.out = frame;
    if (range.in > frame)
        range.in = 0;
    changed.range = range;
    setMarks(tr("set the out point"), std::move(changed), gesture);
}

void Simulation::clearRange() {
    TakeMarks changed = marks();
    changed.range.reset();
    setMarks(tr("clear the in and out points"), std::move(changed));
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
    m_hasUnsavedNames = true;
    tellTake(*take);
    emit takesChanged();
}

void Simulation::exchangeMarks(const TakePointer& take, TakeMarks& other) {
    TakeMarks now = take->marks();
    take->setMarks(std::exchange(other, std::move(now)));
    m_hasUnsavedNames = true;
    tellMeta();
    emit marksChanged();
    if (m_playing && take == m_recording.take())
        advance(); // it may end elsewhere
}

bool MarksCommand::mergeWith(const QUndoCommand* command) {
    const auto* later = dynamic_cast<const MarksCommand*>(command);
    if (!later || later->m_gesture != m_gesture || later->m_take != m_take || later->text() != text())
        return false;
    // The later one is done already; this one goes on holding the marks from before both.
    setObsolete(m_other == m_take->marks());
    return true;
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
    tellMeta(); // its marks
    emit takesChanged();
}

} // namespace clothlab
