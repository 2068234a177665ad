#pragma once

#include "app/simulation/simulation.h"

#include <QComboBox>
#include <QWidget>

namespace clothlab {

// How fast and what is played: speed, pace and repetition.
class PlaybackControls : public QWidget {
    Q_OBJECT

public:
    explicit PlaybackControls(Simulation& simulation, QWidget* parent = nullptr);

private:
    QComboBox* addChoice(const char* name, const QString& title, const QString& toolTip,
                         const QStringList& choices);
    void showSettings();
    void apply();

    Simulation& m_simulation;
    QComboBox* m_speed;
    QComboBox* m_pace;
    QComboBox* m_repeat;
};

} // namespace clothlab
