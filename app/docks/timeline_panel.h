#pragma once

#include "app/docks/scrubber.h"
#include "app/simulation/simulation.h"

#include <QAction>
#include <QLabel>
#include <QWidget>

namespace clothlab {

class NumberField;

// Transport buttons, the number of the frame, and the scrubber.
class TimelinePanel : public QWidget {
    Q_OBJECT

public:
    // The buttons are those of the window's actions, from left to right.
    TimelinePanel(Document& document, Simulation& simulation, const QList<QAction*>& transport,
                  QWidget* parent = nullptr);

    Scrubber* scrubber() const { return m_scrubber; }
    NumberField* frameField() const { return m_frame; }
    QString stateText() const { return m_state->text(); }

signals:
    void rejected(const QString& message);

private:
    void showRecording();
    void showFrame();
    void showState();

    Document& m_document;
    Simulation& m_simulation;
    Scrubber* m_scrubber;
    NumberField* m_frame;
    QLabel* m_last;
    QLabel* m_time;
    QLabel* m_state;
};

} // namespace clothlab
