// The part of the viewport that turns scene, frame and selection into what the renderer draws.
#include "app/viewport/viewport.h"
#include "app/widgets/theme.h"

#include <algorithm>

namespace clothlab {
namespace {

QVector3D toQt(const Vec3& v) {
    return {float(v.x()), float(v.y()), float(v.z())};
}

void fillPositions(const PointArray& from, std::vector<float>& to) {
    to.resize(3 * from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
        to[3 * i] = float(from.x[i]);
        to[3 * i + 1] = float(from.y[i]);
        to[3 * i + 2] = float(from.z[i]);
    }
}

} // namespace

const render::RenderFrame& Viewport::renderFrame() {
    if (!m_frameIsCurrent)
        buildFrame();
    m_frameIsCurrent = true;
    return m_frame;
}

void Viewport::buildFrame() {
    const Scene& scene = m_document.scene();
    m_frame.viewProjection = m_camera.viewProjection(size());
    m_frame.cameraPosition = m_camera.eye();
    m_frame.devicePixelRatio = float(devicePixelRatio());

    const Appearance& appearance = scene.appearance;
    m_frame.shader = QString::fromStdString(appearance.shader);
    m_frame.color = {float(appearance.color[0]), float(appearance.color[1]), float(appearance.color[2]), 1};
    m_frame.springsDrawn = appearance.springsDrawn;
    m_frame.springsOverSurface = appearance.springsOverSurface;
    // The view is dark in both themes, so that the cloth is the brightest thing on the screen.
    const ThemeColors& colors = themeColors(Theme::Dark);
    m_frame.springColors = {colors.structural, colors.shearing, colors.bending};
    m_frame.background = colors.window;
    m_frame.highlightColor = colors.selected;
    m_frame.pinnedColor = colors.pinned;

    m_frame.spheres.clear();
    for (const Sphere& sphere : scene.spheres)
        m_frame.spheres.push_back({toQt(sphere.origin), float(sphere.radius)});
    m_frame.planes.clear();
    for (const Plane& plane : scene.planes)
        m_frame.planes.push_back({toQt(plane.point), toQt(plane.normal.stableNormalized())});

    if (!m_positionsAreCurrent) {
        const Grid grid = m_document.grid();
        m_frame.sheet.width = grid.width;
        m_frame.sheet.height = grid.height;
        fillPositions(m_simulation.shownFrame()->state.position, m_frame.sheet.positions);
        m_frame.sheet.pinned.clear();
        for (const GridPoint& p : scene.cloth.pinned)
            m_frame.sheet.pinned.push_back(std::uint32_t(grid.index(p)));
        m_positionsAreCurrent = true;
    }
    buildHighlight();
}

void Viewport::buildHighlight() {
    const PointArray& position = m_simulation.shownFrame()->state.position;
    m_frame.highlight.points.clear();
    m_frame.highlight.segments.clear();
    for (const Selection::Item& item : m_document.selection().items) {
        if (item.kind == Selection::Kind::Point) {
            m_frame.highlight.points.push_back(toQt(position.at(item.number)));
        } else {
            const Spring spring = m_document.grid().spring(item.number);
            m_frame.highlight.segments.push_back({toQt(position.at(spring.a)), toQt(position.at(spring.b))});
        }
    }
}

} // namespace clothlab
