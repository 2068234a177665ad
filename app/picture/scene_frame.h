// Turns a scene and a state of its sheet into what the renderer draws.
#pragma once

#include "app/render/render_frame.h"
#include "simcore/cloth/cloth_state.h"

#include <QString>

namespace clothlab {

// Everything but camera, sheet and highlights. `folder` is where files with relative names are: that of the
// scene. frame.strainRange stays as it is where the scene leaves it to the sheet.
void fillLook(const Scene& scene, const QString& folder, render::RenderFrame& frame);

// Whether strains are seen: on the surface, or on springs that are drawn.
bool showsStrain(const Appearance& appearance);

// Positions and pinned points; strains, and the range of their colours, only if they are seen.
void fillSheet(const Scene& scene, const Sheet& sheet, const PointArray& position,
               render::RenderFrame& frame);

render::UniformSetting toSetting(const UniformValue& value, const QString& folder);

} // namespace clothlab
