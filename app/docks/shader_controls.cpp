#include "app/docks/shader_controls.h"

#include "app/picture/scene_frame.h"
#include "app/widgets/button_row.h"
#include "app/widgets/check_box.h"
#include "app/widgets/parameter_row.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace clothlab {
namespace {

using render::UniformSetting;
using render::UniformSpec;

QString toolTipOf(const UniformSpec& spec) {
    QString text = QStringLiteral("<b>%1</b> <code>%2</code>").arg(spec.label.toHtmlEscaped(), spec.name);
    if (!spec.help.isEmpty())
        text += QStringLiteral("<br>%1").arg(spec.help.toHtmlEscaped());
    if (spec.range)
        text +=
            QStringLiteral("<br>") +
            ShaderControls::tr("From %1 to %2").arg(double((*spec.range)[0])).arg(double((*spec.range)[1]));
    return text;
}

// Without the digits that a float does not have: 0.8, not 0.800000012.
double asWritten(float value) {
    return QString::number(double(value), 'g', 7).toDouble();
}

std::pair<double, double> sliderRange(const UniformSpec& spec, double initial) {
    if (spec.range)
        return {asWritten((*spec.range)[0]), asWritten((*spec.range)[1])};
    const double reach = std::max(2 * std::abs(initial), spec.type == UniformSpec::Type::Int ? 10.0 : 1.0);
    return {initial < 0 ? -reach : 0, reach};
}

QColor toColor(const UniformSetting& setting) {
    const auto channel = [&](std::size_t i) { return std::clamp(setting.numbers[i], 0.0F, 1.0F); };
    return QColor::fromRgbF(channel(0), channel(1), channel(2));
}

UniformValue toValue(const UniformSpec& spec, const UniformSetting& setting) {
    if (spec.type == UniformSpec::Type::Sampler2D)
        return setting.file.toStdString();
    if (spec.type == UniformSpec::Type::Bool)
        return setting.numbers[0] != 0;
    if (setting.components == 1)
        return asWritten(setting.numbers[0]);
    std::vector<double> numbers;
    for (std::size_t i = 0; i < std::size_t(setting.components); ++i)
        numbers.push_back(asWritten(setting.numbers[i]));
    return numbers;
}

} // namespace

ShaderControls::ShaderControls(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_layout(new QVBoxLayout(this)) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(3);
}

void ShaderControls::setUniforms(const QString& shader, const std::vector<UniformSpec>& uniforms) {
    const bool same = uniforms == m_uniforms && shader == m_shader;
    if (same)
        return;
    m_shader = shader;
    m_uniforms = uniforms;
    m_shows.clear();
    while (QLayoutItem* item = m_layout->takeAt(0)) {
        // Later: one of them may be what tells of the change.
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    for (const UniformSpec& spec : m_uniforms)
        addControl(spec);
    setColumns(m_labelWidth, m_fieldWidth);
    showScene();
}

void ShaderControls::addControl(const UniformSpec& spec) {
    const auto index = std::size_t(&spec - m_uniforms.data());
    if (spec.type == UniformSpec::Type::Sampler2D) {
        m_shows.emplace_back(index, addFile(spec));
    } else if (spec.type == UniformSpec::Type::Bool) {
        m_shows.emplace_back(index, addCheckBox(spec));
    } else if (spec.color) {
        m_shows.emplace_back(index, addColor(spec));
        if (spec.type == UniformSpec::Type::Vec4)
            m_shows.emplace_back(index, addNumber(spec, 3));
    } else {
        for (std::size_t i = 0; i < std::size_t(spec.initial.components); ++i)
            m_shows.emplace_back(index, addNumber(spec, i));
    }
}

ShaderControls::Show ShaderControls::addCheckBox(const UniformSpec& spec) {
    auto* box = new CheckBox(spec.label);
    box->setObjectName(spec.name);
    box->setToolTip(toolTipOf(spec));
    connect(box, &QCheckBox::clicked, this, [this, spec](bool checked) {
        UniformSetting setting = spec.initial;
        setting.numbers[0] = checked ? 1 : 0;
        set(spec, setting, 0);
    });
    m_layout->addWidget(box);
    return [box](const UniformSetting& setting) { box->setChecked(setting.numbers[0] != 0); };
}

ShaderControls::Show ShaderControls::addNumber(const UniformSpec& spec, std::size_t component) {
    static const char* const letters = "xyzw";
    ParameterSpec row;
    const bool single = spec.initial.components == 1;
    row.label = single ? spec.label
                : spec.color
                    ? tr("%1, opacity").arg(spec.label)
                    : QStringLiteral("%1 %2").arg(spec.label, QString(QLatin1Char(letters[component])));
    row.toolTip = toolTipOf(spec);
    row.defaultValue = asWritten(spec.initial.numbers[component]);
    row.integer = spec.type == UniformSpec::Type::Int;
    std::tie(row.sliderMinimum, row.sliderMaximum) = sliderRange(spec, row.defaultValue);
    if (spec.range) {
        row.minimum = row.sliderMinimum;
        row.maximum = row.sliderMaximum;
    } else if (row.integer) {
        row.maximum = 1e6; // what a float holds exactly
        row.minimum = -row.maximum;
    }
    auto* widget = new ParameterRow(row);
    widget->setObjectName(single ? spec.name
                                 : spec.name + QLatin1Char('.') + QLatin1Char(letters[component]));
    connect(widget, &ParameterRow::rejected, this, &ShaderControls::rejected);
    connect(widget, &ParameterRow::edited, this, [this, spec, component](double value, int gesture) {
        UniformSetting setting = settingOf(spec);
        setting.numbers[component] = float(value);
        set(spec, setting, gesture);
    });
    m_layout->addWidget(widget);
    return [widget, component](const UniformSetting& setting) {
        widget->setValue(asWritten(setting.numbers[component]));
    };
}

ShaderControls::Show ShaderControls::addColor(const UniformSpec& spec) {
    auto* row = new ColorRow(spec.label, toolTipOf(spec), {});
    row->setObjectName(spec.name);
    connect(row, &ColorRow::edited, this, [this, spec](const QColor& color, int gesture) {
        UniformSetting setting = settingOf(spec);
        setting.numbers = {color.redF(), color.greenF(), color.blueF(), setting.numbers[3]};
        set(spec, setting, gesture);
    });
    connect(row, &ColorRow::resetAsked, this, [this, spec] { set(spec, spec.initial, 0); });
    m_layout->addWidget(row);
    return [row, spec](const UniformSetting& setting) {
        row->setColor(toColor(setting), toColor(setting).rgb() == toColor(spec.initial).rgb());
    };
}

ShaderControls::Show ShaderControls::addFile(const UniformSpec& spec) {
    auto* row = new FileRow(spec.label, toolTipOf(spec), tr("Built in"), FileRow::Kind::Picture);
    row->setObjectName(spec.name);
    connect(row, &FileRow::chosen, this, [this, spec](const QString& path) {
        UniformSetting setting;
        setting.file = path;
        set(spec, setting, 0);
    });
    connect(row, &FileRow::resetAsked, this, [this, spec] { set(spec, spec.initial, 0); });
    m_layout->addWidget(row);
    return [this, row, spec](const UniformSetting& setting) {
        row->setFile(setting.file == spec.initial.file ? QString() : setting.file, m_document.folder());
    };
}

UniformSetting ShaderControls::settingOf(const UniformSpec& spec) const {
    const auto& shaders = m_document.scene().appearance.uniforms;
    const auto shader = shaders.find(m_shader.toStdString());
    if (shader == shaders.end())
        return spec.initial;
    const auto value = shader->second.find(spec.name.toStdString());
    if (value == shader->second.end())
        return spec.initial;
    const UniformSetting setting = toSetting(value->second);
    return setting.components == spec.initial.components ? setting : spec.initial;
}

void ShaderControls::set(const UniformSpec& spec, const UniformSetting& setting, int gesture) {
    Scene after = m_document.scene();
    const std::string shader = m_shader.toStdString();
    if (setting == spec.initial)
        after.appearance.uniforms[shader].erase(spec.name.toStdString());
    else
        after.appearance.uniforms[shader][spec.name.toStdString()] = toValue(spec, setting);
    if (after.appearance.uniforms[shader].empty())
        after.appearance.uniforms.erase(shader);
    m_document.edit(tr("change %1").arg(spec.label), std::move(after), gesture);
}

void ShaderControls::setColumns(int labelWidth, int fieldWidth) {
    m_labelWidth = labelWidth;
    m_fieldWidth = fieldWidth;
    for (ParameterRow* row : findChildren<ParameterRow*>()) {
        row->setLabelWidth(labelWidth);
        row->setFieldWidth(fieldWidth);
    }
    for (ButtonRow* row : findChildren<ButtonRow*>())
        row->setLabelWidth(labelWidth);
}

void ShaderControls::showScene() {
    for (const auto& [index, show] : m_shows)
        show(settingOf(m_uniforms[index]));
}

} // namespace clothlab
