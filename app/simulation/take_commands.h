// What is done to takes, as steps of the document's undo stack.
#pragma once

#include "app/simulation/simulation.h"

#include <QUndoCommand>

namespace clothlab {

// Holds what is not open now, with its scene: redo and undo both exchange it with what is.
class OpenTakeCommand : public QUndoCommand {
public:
    OpenTakeCommand(Simulation& simulation, const QString& text, Recording::View view)
        : QUndoCommand(text), m_simulation(simulation), m_other(std::move(view)) {}

    void redo() override { m_simulation.exchangeView(m_other); }
    void undo() override { m_simulation.exchangeView(m_other); }

private:
    Simulation& m_simulation;
    Recording::View m_other;
};

class RenameTakeCommand : public QUndoCommand {
public:
    RenameTakeCommand(Simulation& simulation, const QString& text, TakePointer take, std::string name)
        : QUndoCommand(text), m_simulation(simulation), m_take(std::move(take)), m_other(std::move(name)) {}

    void redo() override { m_simulation.exchangeName(m_take, m_other); }
    void undo() override { m_simulation.exchangeName(m_take, m_other); }

private:
    Simulation& m_simulation;
    TakePointer m_take;
    std::string m_other;
};

class DeleteTakeCommand : public QUndoCommand {
public:
    DeleteTakeCommand(Simulation& simulation, const QString& text, TakePointer take)
        : QUndoCommand(text), m_simulation(simulation), m_take(std::move(take)) {}

    void redo() override { m_removed = m_simulation.removeTake(m_take); }
    void undo() override {
        if (m_removed)
            m_simulation.insertTake(m_take);
    }

private:
    Simulation& m_simulation;
    TakePointer m_take;
    bool m_removed = false;
};

class MarksCommand : public QUndoCommand {
public:
    MarksCommand(Simulation& simulation, const QString& text, TakePointer take, TakeMarks marks, int gesture)
        : QUndoCommand(text), m_simulation(simulation), m_take(std::move(take)), m_other(std::move(marks)),
          m_gesture(gesture) {}

    void redo() override { m_simulation.exchangeMarks(m_take, m_other); }
    void undo() override { m_simulation.exchangeMarks(m_take, m_other); }
    int id() const override { return m_gesture == 0 ? -1 : 2; } // EditSceneCommand has 1
    bool mergeWith(const QUndoCommand* command) override;

private:
    Simulation& m_simulation;
    TakePointer m_take;
    TakeMarks m_other;
    int m_gesture;
};

} // namespace clothlab
