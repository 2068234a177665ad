#include "app/docks/parameter_panel.h"

#include "app/docks/text.h"
#include "app/widgets/button_row.h"
#include "app/widgets/check_box.h"
#include "app/widgets/foldable_group.h"
#include "app/widgets/number_field.h"
#include "app/widgets/parameter_row.h"

#include <QCoreApplication>
#include <QVBoxLayout>

#include <algorithm>

namespace clothlab {
namespace {

QString translated(std::string_view text) {
    return QCoreApplication::translate("Parameter", std::string(text).c_str());
}

ParameterSpec specOf(const Parameter& parameter) {
    ParameterSpec spec;
    spec.label = translated(parameter.label);
    spec.unit = toQString(parameter.unit);
    spec.toolTip = parameterToolTip(parameter);
    spec.minimum = parameter.minimum / parameter.panelDivisor;
    spec.maximum = parameter.maximum / parameter.panelDivisor;
    spec.leastButZero = parameter.leastButZero / parameter.panelDivisor;
    spec.sliderMinimum = parameter.sliderMinimum / parameter.panelDivisor;
    spec.sliderMaximum = parameter.sliderMaximum / parameter.panelDivisor;
    spec.defaultValue = parameter.defaultValue() / parameter.panelDivisor;
    spec.integer = parameter.kind == Parameter::Kind::Integer;
    spec.logarithmic = parameter.logarithmic;
    return spec;
}

} // namespace

QString parameterToolTip(const Parameter& parameter) {
    const auto inPanel = [&](double value) { return significant(value / parameter.panelDivisor); };
    QString text = QStringLiteral("<b>%1</b> <code>%2</code><br>%3")
                       .arg(translated(parameter.label).toHtmlEscaped(), toQString(parameter.id),
                            translated(parameter.help).toHtmlEscaped());
    if (parameter.kind != Parameter::Kind::Boolean)
        text += "<br>" + QCoreApplication::translate("Parameter", "From %1 to %2 %3, default %4")
                             .arg(inPanel(parameter.minimum), inPanel(parameter.maximum),
                                  toQString(parameter.unit), inPanel(parameter.defaultValue()));
    return text;
}

ParameterPanel::ParameterPanel(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 8);
    layout->setSpacing(2);
    connect(&document, &Document::sceneChanged, this, [this] { showScene(); });
    connect(&document, &Document::sceneReplaced, this, [this] { showScene(); });
}

FoldableGroup* ParameterPanel::addGroup(const QString& title, std::initializer_list<const char*> ids,
                                        bool folded) {
    auto* group = new FoldableGroup(title);
    add(*group, ids);
    group->setFolded(folded);
    layout()->addWidget(group);
    return group;
}

void ParameterPanel::add(FoldableGroup& group, std::initializer_list<const char*> ids) {
    for (const char* id : ids) {
        const Parameter& parameter = *findParameter(id);
        group.contentLayout()->addWidget(parameter.kind == Parameter::Kind::Boolean ? makeCheckBox(parameter)
                                                                                    : makeRow(parameter));
    }
}

QWidget* ParameterPanel::makeRow(const Parameter& parameter) {
    auto* row = new ParameterRow(specOf(parameter));
    row->setObjectName(toQString(parameter.id));
    connect(row, &ParameterRow::edited, this, [this, &parameter](double value, int gesture) {
        setParameter(parameter, value * parameter.panelDivisor, gesture);
    });
    connect(row, &ParameterRow::rejected, this, &ParameterPanel::rejected);
    m_rows.insert(toQString(parameter.id), row);
    return row;
}

QWidget* ParameterPanel::makeCheckBox(const Parameter& parameter) {
    auto* box = new CheckBox(translated(parameter.label));
    box->setObjectName(toQString(parameter.id));
    box->setToolTip(parameterToolTip(parameter));
    connect(box, &QCheckBox::clicked, this,
            [this, &parameter](bool checked) { setParameter(parameter, checked ? 1 : 0, 0); });
    m_checkBoxes.insert(toQString(parameter.id), box);
    return box;
}

void ParameterPanel::setParameter(const Parameter& parameter, double value, int gesture) {
    const double inRange = std::clamp(value, parameter.minimum, parameter.maximum);
    if (const auto problem = m_document.setParameter(parameter, inRange, gesture)) {
        emit rejected(*problem);
        showScene();
    }
}

void ParameterPanel::alignRows(const QString& widest, int leastLabelWidth) {
    m_labelWidth = leastLabelWidth;
    const auto buttonRows = findChildren<ButtonRow*>();
    for (const ParameterRow* row : std::as_const(m_rows))
        m_labelWidth = std::max(m_labelWidth, row->labelWidthHint());
    for (const ButtonRow* row : buttonRows)
        m_labelWidth = std::max(m_labelWidth, row->labelWidthHint());
    for (ParameterRow* row : std::as_const(m_rows)) {
        row->setLabelWidth(m_labelWidth);
        row->setFieldWidth(fontMetrics().horizontalAdvance(widest));
    }
    for (ButtonRow* row : buttonRows)
        row->setLabelWidth(m_labelWidth);
}

void ParameterPanel::showScene() {
    for (const Parameter& parameter : parameters()) {
        const double value = parameter.get(m_document.scene());
        if (ParameterRow* row = m_rows.value(toQString(parameter.id)))
            row->setValue(value / parameter.panelDivisor);
        if (QCheckBox* box = m_checkBoxes.value(toQString(parameter.id)))
            box->setChecked(value != 0);
    }
}

} // namespace clothlab
