// How the scene looks: shader, sheet, textures, light, view.
#pragma once

#include "app/docks/parameter_panel.h"
#include "app/render/uniform_spec.h"
#include "app/simulation/simulation.h"

#include <QComboBox>

#include <array>
#include <functional>
#include <optional>

namespace clothlab {

class ColorRow;
class FileRow;
class ShaderControls;

class AppearancePanel : public ParameterPanel {
    Q_OBJECT

public:
    AppearancePanel(Document& document, Simulation& simulation, QWidget* parent = nullptr);

    // The shaders that there are. One that the scene names is listed in any case.
    void setShaders(const QStringList& shaders);
    // What can be set of the shader that is drawn.
    void setUniforms(const QString& shader, const std::vector<render::UniformSpec>& uniforms);

    QComboBox* shaderBox() const { return m_shader; }
    ColorRow* colorRow() const { return m_color; }
    ColorRow* backColorRow() const { return m_backColor; }
    ColorRow* backgroundRow() const { return m_background; }
    FileRow* textureRow(std::size_t index) const { return m_textures.at(index); } // 0 … 3
    FileRow* cubemapRow() const { return m_cubemap; }
    QComboBox* samplesBox() const { return m_samples; }
    ShaderControls* shaderControls() const { return m_controls; }

signals:
    void editShaderAsked(); // the file of the shader that is chosen

protected:
    void showScene() override;

private:
    void addShaderGroup();
    void addSheetGroup();
    void addTextureGroup();
    void addLightGroup();
    void addStrainGroup();
    void addViewGroup();
    ColorRow* makeColorRow(const QString& label, const QString& toolTip, const QString& byDefault,
                           std::optional<Rgb> (*get)(const Appearance&),
                           void (*put)(Appearance&, const std::optional<Rgb>&));
    void fitStrainRange();
    void editAppearance(const QString& text, const std::function<void(Appearance&)>& change, int gesture = 0);

    Simulation& m_simulation;
    QStringList m_shaders;
    QComboBox* m_shader = nullptr;
    ShaderControls* m_controls = nullptr;
    ColorRow* m_color = nullptr;
    ColorRow* m_backColor = nullptr;
    ColorRow* m_background = nullptr;
    std::array<FileRow*, kTextures> m_textures{};
    FileRow* m_cubemap = nullptr;
    QComboBox* m_samples = nullptr;
};

// One undo step: draw with another shader.
void setShader(Document& document, const QString& shader);

// Lists `shaders`, and shows `shader`, also if it is not among them.
void showShader(QComboBox& box, const QStringList& shaders, const QString& shader);

} // namespace clothlab
