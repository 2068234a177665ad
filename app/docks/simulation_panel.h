// What the solver computes with: material, forces, time, and the sheet itself. Made from the parameter table.
#pragma once

#include "app/document/document.h"

#include <QCheckBox>
#include <QHash>
#include <QWidget>

namespace clothlab {

class FoldableGroup;
class ParameterRow;
class StabilityReadout;

class SimulationPanel : public QWidget {
    Q_OBJECT

public:
    explicit SimulationPanel(Document& document, QWidget* parent = nullptr);

    // By Parameter::id; null if the panel shows it otherwise.
    ParameterRow* row(const QString& id) const { return m_rows.value(id); }
    QCheckBox* checkBox(const QString& id) const { return m_checkBoxes.value(id); }
    StabilityReadout* stabilityReadout() const { return m_stability; }

signals:
    void rejected(const QString& message); // a typed value that cannot be taken, in words

private:
    FoldableGroup* addGroup(const QString& title, std::initializer_list<const char*> ids,
                            bool folded = false);
    QWidget* makeRow(const Parameter& parameter);
    QWidget* makeCheckBox(const Parameter& parameter);
    void set(const Parameter& parameter, double value, int gesture);
    void alignLabels();
    void showScene();

    Document& m_document;
    QHash<QString, ParameterRow*> m_rows;
    QHash<QString, QCheckBox*> m_checkBoxes;
    StabilityReadout* m_stability;
};

// Name in the file, unit, range, default, and what it does to cloth.
QString parameterToolTip(const Parameter& parameter);

} // namespace clothlab
