// Meshes of the colliders, and where they stand.
#pragma once

#include "app/render/render_frame.h"
#include "app/render/surface_mesh.h"

namespace clothlab::render {

// Spheres are drawn at this part of their radius: the sheet's flat triangles cut into the true one.
inline constexpr float kDrawnRadius = 0.92F;

// Planes are infinite; drawn is a square of this side around their point, metres.
inline constexpr float kPlaneSide = 4.0F;

// Unit sphere around the origin with its poles on the y axis. u is the longitude from +x towards -z, v the
// latitude from the north pole, both 0..1; tangents are dp/du. `segments` around (at least 3), `rings` from
// pole to pole (at least 2).
SurfaceMesh makeUnitSphere(int segments, int rings);

// Square of side kPlaneSide in y = 0, normal +y, uv 0..1 with u along +x and v along +z.
SurfaceMesh makePlaneSquare();

QMatrix4x4 sphereModel(const SphereShape& sphere);

// Turns +y to the plane's normal. The identity at its point for a normal without a direction.
QMatrix4x4 planeModel(const PlaneShape& plane);

} // namespace clothlab::render
