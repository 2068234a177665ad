#include "app/picture/scene_frame.h"

#include "app/picture/to_vector_3d.h"
#include "app/widgets/theme.h"
#include "simcore/inspect/inspect.h"

#include <algorithm>
#include <cmath>

namespace clothlab {
namespace {

void fillSurface(const Scene& scene, render::SurfaceLook& surface) {
    const Appearance& appearance = scene.appearance;
    surface.shader = QString::fromStdString(appearance.shader);
    surface.color = QVector4D(toVector3D(appearance.color), 1);
    surface.backColor.reset();
    if (appearance.backColor)
        surface.backColor = QVector4D(toVector3D(*appearance.backColor), 1);
    surface.twoSided = appearance.twoSided;
    surface.meshResolution = appearance.meshResolution;
    surface.normalScaling = float(appearance.normalScaling);
    surface.heightScaling = float(appearance.heightScaling);
    for (std::size_t i = 0; i < appearance.textures.size(); ++i)
        surface.textures[i] = QString::fromStdString(appearance.textures[i]);
    surface.cubemap = QString::fromStdString(appearance.cubemap);
    surface.uniforms.clear();
    for (const auto& [shader, values] : appearance.uniforms) {
        render::UniformSettings& settings = surface.uniforms[QString::fromStdString(shader)];
        for (const auto& [name, value] : values)
            settings.emplace(QString::fromStdString(name), toSetting(value));
    }
}

void fillPositions(const PointArray& from, std::vector<float>& to) {
    to.resize(3 * from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
        to[3 * i] = float(from.x[i]);
        to[3 * i + 1] = float(from.y[i]);
        to[3 * i + 2] = float(from.z[i]);
    }
}

// The same object as before where the places are the same, so that nothing is uploaded again.
void fillRest(const PointArray& start, std::shared_ptr<const std::vector<float>>& rest) {
    bool same = rest && rest->size() == 3 * start.size();
    for (std::size_t i = 0; same && i < start.size(); ++i)
        same = (*rest)[3 * i] == float(start.x[i]) && (*rest)[3 * i + 1] == float(start.y[i]) &&
               (*rest)[3 * i + 2] == float(start.z[i]);
    if (same)
        return;
    auto positions = std::make_shared<std::vector<float>>();
    fillPositions(start, *positions);
    rest = std::move(positions);
}

bool springsShowStrain(const Appearance& appearance) {
    const bool drawn = appearance.shader == "Wireframe" || appearance.springsOverSurface;
    return drawn && appearance.springColoring == SpringColoring::ByStrain;
}

void fillStrains(const Scene& scene, const Sheet& sheet, const PointArray& position,
                 render::RenderFrame& frame) {
    const double greatest = pointStrains(scene.cloth, sheet, position, frame.sheet.strains);
    fillRest(sheet.start, frame.sheet.restPositions);
    constexpr double least = 1e-6; // a sheet at rest has no strain to scale by
    if (scene.appearance.strainRange == 0)
        frame.strainRange = float(std::max(greatest, least));
}

} // namespace

render::UniformSetting toSetting(const UniformValue& value) {
    render::UniformSetting setting;
    if (const auto* file = std::get_if<std::string>(&value)) {
        setting.file = QString::fromStdString(*file);
    } else if (const auto* list = std::get_if<std::vector<double>>(&value)) {
        setting.components = int(std::min(list->size(), setting.numbers.size()));
        for (std::size_t i = 0; i < std::size_t(setting.components); ++i)
            setting.numbers[i] = float((*list)[i]);
    } else {
        setting.components = 1;
        const auto* flag = std::get_if<bool>(&value);
        setting.numbers[0] = flag ? float(*flag) : float(std::get<double>(value));
    }
    return setting;
}

void fillLook(const Scene& scene, render::RenderFrame& frame) {
    const Appearance& appearance = scene.appearance;
    fillSurface(scene, frame.surface);
    // The view is dark in both themes, so that the cloth is the brightest thing on the screen.
    const ThemeColors& colors = themeColors(Theme::Dark);
    frame.springs.drawn = appearance.springsDrawn;
    frame.springs.colors = {colors.structural, colors.shearing, colors.bending};
    frame.springs.overSurface = appearance.springsOverSurface;
    frame.springs.coloredByStrain = appearance.springColoring == SpringColoring::ByStrain;
    if (appearance.strainRange > 0)
        frame.strainRange = float(appearance.strainRange);
    frame.light = {toVector3D(appearance.lightPosition), toVector3D(appearance.lightIntensity),
                   appearance.shadows};
    frame.background = colors.window;
    if (const auto& rgb = appearance.background)
        frame.background = QColor::fromRgbF(float((*rgb)[0]), float((*rgb)[1]), float((*rgb)[2]));
    frame.groundGrid = appearance.groundGrid;
    frame.axes = appearance.axes;
    frame.samples = appearance.samples;
    frame.highlightColor = colors.selected;
    frame.pinnedColor = colors.pinned;
    frame.spheres.clear();
    for (const Sphere& sphere : scene.spheres)
        frame.spheres.push_back({toVector3D(sphere.origin), float(sphere.radius)});
    frame.planes.clear();
    for (const Plane& plane : scene.planes)
        frame.planes.push_back({toVector3D(plane.point), toVector3D(plane.normal.stableNormalized())});
}

void fillSheet(const Scene& scene, const Sheet& sheet, const PointArray& position, bool shaderTakesStrain,
               render::RenderFrame& frame) {
    const Grid grid = gridOf(scene.cloth);
    frame.sheet.width = grid.width;
    frame.sheet.height = grid.height;
    fillPositions(position, frame.sheet.positions);
    frame.sheet.pinned.clear();
    for (const GridPoint& p : scene.cloth.pinned)
        frame.sheet.pinned.push_back(std::uint32_t(grid.index(p)));
    const bool seen = shaderTakesStrain || springsShowStrain(scene.appearance);
    if (seen && sheet.grid == grid)
        fillStrains(scene, sheet, position, frame);
    else
        frame.sheet.strains.clear();
}

} // namespace clothlab
