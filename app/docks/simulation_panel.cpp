#include "app/docks/simulation_panel.h"

#include "app/docks/stability_readout.h"
#include "app/widgets/foldable_group.h"

#include <QVBoxLayout>

namespace clothlab {

SimulationPanel::SimulationPanel(Document& document, QWidget* parent)
    : ParameterPanel(document, parent), m_stability(new StabilityReadout) {
    addGroup(tr("Material"), {"cloth.density", "cloth.ks", "cloth.damping", "cloth.thickness"});
    addGroup(tr("Springs that pull"),
             {"cloth.enable_structural", "cloth.enable_shearing", "cloth.enable_bending"});
    addGroup(tr("Forces"), {"simulation.gravity[0]", "simulation.gravity[1]", "simulation.gravity[2]"});
    addGroup(tr("Time"), {"simulation.frames_per_second", "simulation.steps_per_frame"})
        ->contentLayout()
        ->addWidget(m_stability);
    addGroup(tr("Sheet (starts anew)"), {"cloth.width", "cloth.height", "cloth.num_width_points",
                                         "cloth.num_height_points", "cloth.orientation", "simulation.seed"});
    static_cast<QVBoxLayout*>(layout())->addStretch();
    alignRows(QStringLiteral("100000.55 m/s²_"), m_stability->labelWidthHint());
    m_stability->setLabelWidth(labelWidth());
    SimulationPanel::showScene();
}

void SimulationPanel::showScene() {
    ParameterPanel::showScene();
    m_stability->showStability(stability(document().scene()));
}

} // namespace clothlab
