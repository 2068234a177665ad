#include "app/export/frame_painter.h"

#include "app/picture/scene_frame.h"
#include "app/render/shader_library.h"

#include <utility>

namespace clothlab {
namespace {

class ScenePainter : public FramePainter {
public:
    explicit ScenePainter(PictureLook look)
        : m_look(std::move(look)), m_shaderTakesStrain(render::takesStrain(m_look.source.shaderDirectory,
                                                                           m_look.frame.surface.shader)) {}

    std::optional<std::string> begin() override {
        QString reason;
        if (!m_renderer.open(m_look.size, m_look.source, reason))
            return reason.toStdString();
        return std::nullopt;
    }

    QImage paint(const Frame& frame) override {
        m_look.frame.time = float(frame.time);
        fillSheet(*m_look.scene, m_look.sheet, frame.state.position, m_shaderTakesStrain, m_look.frame);
        QImage image = m_renderer.draw(m_look.frame);
        if (m_renderer.problems() != m_problems) {
            m_problems = m_renderer.problems();
            if (m_look.onProblems)
                m_look.onProblems(m_problems);
        }
        return image;
    }

    void end() override { m_renderer.close(); }
    QSize size() const override { return m_look.size; }

private:
    PictureLook m_look;
    bool m_shaderTakesStrain;
    render::OffscreenRenderer m_renderer;
    render::Problems m_problems;
};

} // namespace

std::unique_ptr<FramePainter> makeFramePainter(PictureLook look) {
    return std::make_unique<ScenePainter>(std::move(look));
}

} // namespace clothlab
