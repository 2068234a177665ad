// Turns a scene and a state of its sheet into what the renderer draws.
#pragma once

#include "app/render/render_frame.h"
#include "simcore/cloth/cloth_state.h"

namespace clothlab {

// Everything but camera, sheet and highlights. Files of the scene are named absolutely
// (app/document/scene_files.h). frame.strainRange stays as it is where the scene leaves it to the sheet.
void fillLook(const Scene& scene, render::RenderFrame& frame);

// Positions and pinned points. Strains, and the range of their colours, only where they are seen: on a
// surface whose shader takes them, or on springs that are drawn in the colours of strain.
void fillSheet(const Scene& scene, const Sheet& sheet, const PointArray& position, bool shaderTakesStrain,
               render::RenderFrame& frame);

render::UniformSetting toSetting(const UniformValue& value);

} // namespace clothlab
