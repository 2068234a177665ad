#pragma once

#include "app/docks/scrubber.h"
#include "app/picture/camera.h"
#include "app/simulation/simulation.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QWidget>

namespace clothlab {

class NumberField;

// Transport buttons, frame and time, how it is played, and the scrubber.
class TimelinePanel : public QWidget {
    Q_OBJECT

public:
    // The buttons are those of the window's actions, from left to right.
    TimelinePanel(Document& document, Simulation& simulation, const QList<QAction*>& transport,
                  QWidget* parent = nullptr);

    // Whose view pictures of frames show.
    void setCamera(std::function<Camera()> camera);

    Scrubber* scrubber() const { return m_scrubber; }
    NumberField* frameField() const { return m_frame; }
    NumberField* timeField() const { return m_time; }
    QString stateText() const { return m_state->text(); }
    PlotQuantity quantity() const { return PlotQuantity(m_quantity->currentData().toInt()); }
    void setQuantity(PlotQuantity quantity); // that is plotted behind the frames

signals:
    void rejected(const QString& message);

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeButtons(const QList<QAction*>& transport);
    QWidget* makeFields();
    QWidget* makeChoices();
    void showRecording();
    void showFrame();
    void showState();
    void goToTime(double seconds);

    Simulation& m_simulation;
    Scrubber* m_scrubber;
    NumberField* m_frame;
    NumberField* m_time;
    QLabel* m_last;
    QLabel* m_state;
    QComboBox* m_quantity;
};

} // namespace clothlab
