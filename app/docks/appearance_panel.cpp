#include "app/docks/appearance_panel.h"

#include "app/docks/shader_controls.h"
#include "app/widgets/button_row.h"
#include "app/widgets/foldable_group.h"
#include "simcore/inspect/inspect.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace clothlab {
namespace {

QColor toQt(const Rgb& rgb) {
    return QColor::fromRgbF(float(rgb[0]), float(rgb[1]), float(rgb[2]));
}

Rgb toRgb(const QColor& color) {
    return {color.red() / 255.0, color.green() / 255.0, color.blue() / 255.0};
}

constexpr std::array kSampleCounts{1, 2, 4, 8};

} // namespace

void setShader(Document& document, const QString& shader) {
    Scene after = document.scene();
    after.appearance.shader = shader.toStdString();
    document.edit(AppearancePanel::tr("shader %1").arg(shader), std::move(after));
}

void showShader(QComboBox& box, const QStringList& shaders, const QString& shader) {
    QStringList names = shaders;
    if (!names.contains(shader))
        names.append(shader);
    QStringList shown;
    for (int i = 0; i < box.count(); ++i)
        shown.append(box.itemText(i));
    if (shown != names) {
        box.clear();
        box.addItems(names);
    }
    box.setCurrentText(shader);
}

AppearancePanel::AppearancePanel(Document& document, Simulation& simulation, QWidget* parent)
    : ParameterPanel(document, parent), m_simulation(simulation) {
    addShaderGroup();
    addSheetGroup();
    addTextureGroup();
    addLightGroup();
    addStrainGroup();
    addViewGroup();
    static_cast<QVBoxLayout*>(layout())->addStretch();
    const QString widest = QStringLiteral("-100.555 m_");
    alignRows(widest);
    m_controls->setColumns(labelWidth(), fontMetrics().horizontalAdvance(widest));
    AppearancePanel::showScene();
}

void AppearancePanel::editAppearance(const QString& text, const std::function<void(Appearance&)>& change,
                                     int gesture) {
    Scene after = document().scene();
    change(after.appearance);
    document().edit(text, std::move(after), gesture);
}

void AppearancePanel::addShaderGroup() {
    FoldableGroup* group = addGroup(tr("Shader"), {});
    auto* row = new QHBoxLayout;
    row->setSpacing(5);
    m_shader = new QComboBox;
    m_shader->setAccessibleName(tr("Shader"));
    m_shader->setToolTip(tr("The .frag files in the folder of shaders. Wireframe draws the springs."));
    connect(m_shader, &QComboBox::textActivated, this,
            [this](const QString& shader) { setShader(document(), shader); });
    auto* edit = new QPushButton(tr("Edit"));
    edit->setObjectName("editShader");
    edit->setFocusPolicy(Qt::TabFocus);
    edit->setToolTip(tr("Open the shader's file in the panel Shader; what you save there is drawn at once."));
    connect(edit, &QPushButton::clicked, this, &AppearancePanel::editShaderAsked);
    row->addWidget(m_shader, 1);
    row->addWidget(edit);
    group->contentLayout()->addLayout(row);
    m_controls = new ShaderControls(document());
    connect(m_controls, &ShaderControls::rejected, this, &AppearancePanel::rejected);
    group->contentLayout()->addWidget(m_controls);
}

ColorRow* AppearancePanel::makeColorRow(const QString& label, const QString& toolTip,
                                        const QString& byDefault,
                                        std::optional<Rgb> (*get)(const Appearance&),
                                        void (*put)(Appearance&, const std::optional<Rgb>&)) {
    auto* row = new ColorRow(label, toolTip, byDefault);
    const QString text = tr("change %1").arg(label);
    connect(row, &ColorRow::edited, this, [this, text, put](const QColor& color, int gesture) {
        editAppearance(
            text, [&](Appearance& a) { put(a, toRgb(color)); }, gesture);
    });
    connect(row, &ColorRow::resetAsked, this, [this, text, get, put] {
        editAppearance(text, [&](Appearance& a) { put(a, get(Appearance{})); });
    });
    return row;
}

void AppearancePanel::addSheetGroup() {
    FoldableGroup* group = addGroup(tr("Sheet"), {});
    m_color = makeColorRow(
        tr("Colour"), tr("Colour of the sheet, u_color of the shaders."), {},
        [](const Appearance& a) { return std::optional(a.color); },
        [](Appearance& a, const std::optional<Rgb>& rgb) { a.color = rgb.value_or(a.color); });
    m_backColor = makeColorRow(
        tr("Back colour"), tr("Colour of the sheet's other side, u_back_color of the shaders."),
        tr("As the front"), [](const Appearance& a) { return a.backColor; },
        [](Appearance& a, const std::optional<Rgb>& rgb) { a.backColor = rgb; });
    group->contentLayout()->addWidget(m_color);
    group->contentLayout()->addWidget(m_backColor);
    add(*group, {"appearance.two_sided", "appearance.mesh_resolution"});
}

void AppearancePanel::addTextureGroup() {
    FoldableGroup* group = addGroup(tr("Textures"), {}, true);
    for (std::size_t i = 0; i < m_textures.size(); ++i) {
        const QString label = tr("Texture %1").arg(i + 1);
        auto* row = new FileRow(label, tr("PNG or JPEG, u_texture_%1 of the shaders.").arg(i + 1),
                                tr("Built in"), FileRow::Kind::Picture);
        const auto choose = [this, i, label](const QString& path) {
            editAppearance(tr("change %1").arg(label),
                           [&](Appearance& a) { a.textures[i] = path.toStdString(); });
        };
        connect(row, &FileRow::chosen, this, choose);
        connect(row, &FileRow::resetAsked, this, [choose] { choose({}); });
        group->contentLayout()->addWidget(row);
        m_textures[i] = row;
    }
    m_cubemap =
        new FileRow(tr("Cube map"),
                    tr("A folder with posx, negx, posy, negy, posz and negz, each .png or .jpg: what is all "
                       "around, u_texture_cubemap of the shaders."),
                    tr("Built in"), FileRow::Kind::Folder);
    const auto choose = [this](const QString& path) {
        editAppearance(tr("change the cube map"), [&](Appearance& a) { a.cubemap = path.toStdString(); });
    };
    connect(m_cubemap, &FileRow::chosen, this, choose);
    connect(m_cubemap, &FileRow::resetAsked, this, [choose] { choose({}); });
    group->contentLayout()->addWidget(m_cubemap);
    add(*group, {"appearance.normal_scaling", "appearance.height_scaling"});
}

void AppearancePanel::addLightGroup() {
    addGroup(tr("Light"),
             {"appearance.light_position[0]", "appearance.light_position[1]", "appearance.light_position[2]",
              "appearance.light_intensity[0]", "appearance.light_intensity[1]",
              "appearance.light_intensity[2]", "appearance.shadows"},
             true);
}

void AppearancePanel::addStrainGroup() {
    FoldableGroup* group = addGroup(tr("Strain"), {"appearance.strain_range"}, true);
    auto* fit = new QPushButton(tr("Fit to the recording"));
    fit->setObjectName("fitStrainRange");
    fit->setFocusPolicy(Qt::TabFocus);
    fit->setToolTip(tr("Set the range to the greatest strain of any spring in any recorded frame."));
    connect(fit, &QPushButton::clicked, this, &AppearancePanel::fitStrainRange);
    group->contentLayout()->addWidget(fit, 0, Qt::AlignRight);
}

void AppearancePanel::addViewGroup() {
    FoldableGroup* group = addGroup(tr("View"), {}, true);
    m_background = makeColorRow(
        tr("Background"), tr("Colour behind the scene."), tr("Dark"),
        [](const Appearance& a) { return a.background; },
        [](Appearance& a, const std::optional<Rgb>& rgb) { a.background = rgb; });
    group->contentLayout()->addWidget(m_background);
    add(*group, {"appearance.ground_grid", "appearance.axes"});

    m_samples = new QComboBox;
    m_samples->setObjectName("appearance.samples");
    m_samples->setAccessibleName(tr("Antialiasing"));
    m_samples->setToolTip(parameterToolTip(*findParameter("appearance.samples")));
    for (const int count : kSampleCounts)
        m_samples->addItem(count == 1 ? tr("No antialiasing") : tr("Antialiasing, %1 samples").arg(count),
                           count);
    connect(m_samples, &QComboBox::activated, this, [this](int index) {
        const int count = m_samples->itemData(index).toInt();
        editAppearance(tr("change antialiasing"), [&](Appearance& a) { a.samples = count; });
    });
    group->contentLayout()->addWidget(m_samples);
}

void AppearancePanel::fitStrainRange() {
    double greatest = 0;
    std::vector<float> strains;
    // All frames, or of a long recording as many as take no time, at even distances.
    constexpr int mostPoints = 3'000'000;
    const int last = m_simulation.recording().lastFrame();
    const int most = std::max(8, mostPoints / document().grid().pointCount());
    const int step = last / most + 1;
    for (int frame = last; frame >= 0; frame -= step)
        greatest = std::max(greatest, pointStrains(document().scene().cloth, m_simulation.sheet(),
                                                   m_simulation.look(frame)->state.position, strains));
    const Parameter& range = *findParameter("appearance.strain_range");
    // Rounded up to three digits, as one would write it.
    const double unit = greatest > 0 ? std::pow(10.0, std::floor(std::log10(greatest)) - 2) : 1;
    const double rounded = std::clamp(std::ceil(greatest / unit - 1e-9) * unit, 1e-6, range.maximum);
    if (const auto problem = document().setParameter(range, rounded))
        emit rejected(*problem);
}

void AppearancePanel::setShaders(const QStringList& shaders) {
    m_shaders = shaders;
    showScene();
}

void AppearancePanel::setUniforms(const QString& shader, const std::vector<render::UniformSpec>& uniforms) {
    m_controls->setUniforms(shader, uniforms);
}

void AppearancePanel::showScene() {
    ParameterPanel::showScene();
    const Appearance& appearance = document().scene().appearance;
    showShader(*m_shader, m_shaders, QString::fromStdString(appearance.shader));
    m_color->setColor(toQt(appearance.color), appearance.color == Appearance{}.color);
    const auto optional = [](const std::optional<Rgb>& rgb) {
        return rgb ? std::optional(toQt(*rgb)) : std::nullopt;
    };
    m_backColor->setColor(optional(appearance.backColor), !appearance.backColor);
    m_background->setColor(optional(appearance.background), !appearance.background);
    for (std::size_t i = 0; i < m_textures.size(); ++i)
        m_textures[i]->setFile(QString::fromStdString(appearance.textures[i]), document().folder());
    m_cubemap->setFile(QString::fromStdString(appearance.cubemap), document().folder());
    m_samples->setCurrentIndex(m_samples->findData(appearance.samples));
    m_controls->showScene();
}

} // namespace clothlab
