#pragma once

#include "app/simulation/simulation.h"

#include <QLabel>

namespace clothlab {

// The numbers at the right end of the status bar.
class StatusLine : public QLabel {
    Q_OBJECT

public:
    StatusLine(Document& document, Simulation& simulation, QWidget* parent = nullptr);

private:
    void refresh();

    Document& m_document;
    Simulation& m_simulation;
};

} // namespace clothlab
