// What the solver computes with: material, forces, time, and the sheet itself.
#pragma once

#include "app/docks/parameter_panel.h"

namespace clothlab {

class StabilityReadout;

class SimulationPanel : public ParameterPanel {
    Q_OBJECT

public:
    explicit SimulationPanel(Document& document, QWidget* parent = nullptr);

    StabilityReadout* stabilityReadout() const { return m_stability; }

protected:
    void showScene() override;

private:
    StabilityReadout* m_stability;
};

} // namespace clothlab
