// Whether the step is short enough for the springs, under the number of steps per frame that decides it.
#pragma once

#include "simcore/inspect/stability.h"

#include <QWidget>

class QLabel;

namespace clothlab {

// Two rows: "dt·ω  0.32 of 2.00" and "Stable from  5 steps per frame". When the step is not stable the first
// says "unstable", with a sign and in the colour of warnings.
class StabilityReadout : public QWidget {
    Q_OBJECT

public:
    explicit StabilityReadout(QWidget* parent = nullptr);

    void showStability(const Stability& stability);
    QString dtOmegaText() const; // "2.31 of 2.00 – unstable"
    QString stepsText() const;   // "35 steps per frame"

    // As of a ParameterRow, so that they stand in one column.
    void setLabelWidth(int width);
    int labelWidthHint() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void color();

    QLabel* m_dtOmegaLabel;
    QLabel* m_sign; // shown when it is unstable
    QLabel* m_dtOmega;
    QLabel* m_stepsLabel;
    QLabel* m_steps;
    bool m_stable = true;
};

} // namespace clothlab
