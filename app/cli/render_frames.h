// The part of `clothlab render` that makes many pictures: a sequence, or a video.
#pragma once

#include "app/cli/render_options.h"
#include "app/picture/camera.h"
#include "simcore/solver/verlet_solver.h"

namespace clothlab::cli {

Eigen::AlignedBox3d boxAround(const PointArray& position);

// As the key A does in the window.
void fitCamera(const Eigen::AlignedBox3d& box, QSize size, Camera& camera);

// Simulates and draws frame after frame. scene: that of the solver, with files named absolutely. Returns the
// exit status.
int renderFrames(VerletSolver& solver, const Scene& scene, const RenderOptions& options);

} // namespace clothlab::cli
