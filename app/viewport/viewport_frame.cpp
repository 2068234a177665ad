// The part of the viewport that turns document, simulation and camera into what the renderer draws.
#include "app/picture/scene_frame.h"
#include "app/picture/to_vector_3d.h"
#include "app/render/shader_library.h"
#include "app/viewport/viewport.h"

#include <algorithm>

namespace clothlab {
const render::RenderFrame& Viewport::renderFrame() {
    if (!m_frameIsCurrent)
        buildFrame();
    m_frameIsCurrent = true;
    return m_frame;
}

render::RenderFrame Viewport::frameFor(QSize pixels) {
    render::RenderFrame frame = renderFrame();
    frame.viewProjection = m_camera.viewProjection(pixels);
    // Lines and dots as wide as in the view, for their part of its height.
    frame.devicePixelRatio = std::max(1.0F, float(pixels.height()) / float(std::max(height(), 1)));
    return frame;
}

void Viewport::buildFrame() {
    const Scene& scene = m_document.scene();
    m_frame.viewProjection = m_camera.viewProjection(size());
    m_frame.cameraPosition = m_camera.eye();
    m_frame.devicePixelRatio = float(devicePixelRatio());
    m_frame.time = float(m_simulation.currentFrame()) / float(scene.simulation.framesPerSecond);
    if (!m_lookIsCurrent) {
        fillLook(scene, m_frame);
        m_shaderTakesStrain = render::takesStrain(m_shaderDirectory, m_frame.surface.shader);
    }
    if (!m_positionsAreCurrent)
        fillSheet(scene, m_simulation.sheet(), m_simulation.shownFrame()->state.position, m_shaderTakesStrain,
                  m_frame);
    m_lookIsCurrent = m_positionsAreCurrent = true;
    buildHighlight();
    updateLegend();
}

void Viewport::updateLegend() {
    const std::vector<float>& strains = m_frame.sheet.strains;
    if (strains.empty())
        return m_overlay->setLegend(std::nullopt);
    const auto [least, greatest] = std::minmax_element(strains.begin(), strains.end());
    m_overlay->setLegend(Overlay::Legend{m_frame.strainRange, *least, *greatest});
}

void Viewport::buildHighlight() {
    const PointArray& position = m_simulation.shownFrame()->state.position;
    m_frame.highlight.points.clear();
    m_frame.highlight.segments.clear();
    for (const Selection::Item& item : m_document.selection().items) {
        if (item.kind == Selection::Kind::Point) {
            m_frame.highlight.points.push_back(toVector3D(position.at(item.number)));
        } else {
            const Spring spring = m_document.grid().spring(item.number);
            m_frame.highlight.segments.push_back(
                {toVector3D(position.at(spring.a)), toVector3D(position.at(spring.b))});
        }
    }
}

} // namespace clothlab
