// The controls of a shader's own uniforms.
#pragma once

#include "app/document/document.h"
#include "app/render/uniform_spec.h"

#include <QWidget>

#include <functional>
#include <utility>
#include <vector>

class QVBoxLayout;

namespace clothlab {

// One control a uniform: a number field with a slider for a float or an int, a box for a bool, a field for
// each component of a vector, a colour, a file for a sampler. Values are kept in the scene by the shader's
// name; those at their default are not.
class ShaderControls : public QWidget {
    Q_OBJECT

public:
    explicit ShaderControls(Document& document, QWidget* parent = nullptr);

    // Makes the controls anew if they are others.
    void setUniforms(const QString& shader, const std::vector<render::UniformSpec>& uniforms);

    void setColumns(int labelWidth, int fieldWidth); // of the panel around it
    void showScene();
    const std::vector<render::UniformSpec>& uniforms() const { return m_uniforms; }

signals:
    void rejected(const QString& message);

private:
    // Shows the value that the scene has, or the default.
    using Show = std::function<void(const render::UniformSetting&)>;

    void addControl(const render::UniformSpec& spec);
    Show addCheckBox(const render::UniformSpec& spec);
    Show addNumber(const render::UniformSpec& spec, std::size_t component);
    Show addColor(const render::UniformSpec& spec);
    Show addFile(const render::UniformSpec& spec);
    render::UniformSetting settingOf(const render::UniformSpec& spec) const;
    void set(const render::UniformSpec& spec, const render::UniformSetting& setting, int gesture);

    Document& m_document;
    QString m_shader;
    std::vector<render::UniformSpec> m_uniforms;
    std::vector<std::pair<std::size_t, Show>> m_shows; // by index of the uniform
    QVBoxLayout* m_layout;
    int m_labelWidth = 0;
    int m_fieldWidth = 0;
};

} // namespace clothlab
