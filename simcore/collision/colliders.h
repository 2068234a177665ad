// What the sheet meets (physics.md of the course's model, phase 4).
#pragma once

#include "simcore/kernels/kernels.h"

#include <vector>

namespace clothlab {

// The spheres and planes of a scene. Spheres first, each in the order of the scene.
class Colliders {
public:
    void set(const Scene& scene);

    // Moves every unpinned point of the rows that is inside a sphere to its surface, less friction; a point
    // exactly at the origin leaves along +y. Then every one that crossed a plane since its last position back
    // to the side it came from; a last position on the plane counts as on the side the normal points to.
    void collide(const Kernels& kernels, const StepData& data, RowRange rows) const;

private:
    std::vector<SphereData> m_spheres;
    std::vector<PlaneData> m_planes;
};

} // namespace clothlab
