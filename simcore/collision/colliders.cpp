#include "simcore/collision/colliders.h"

namespace clothlab {

void Colliders::set(const Scene& scene) {
    m_spheres.clear();
    for (const Sphere& s : scene.spheres)
        m_spheres.push_back({s.origin.x(), s.origin.y(), s.origin.z(), s.radius, s.friction});
    m_planes.clear();
    for (const Plane& p : scene.planes) {
        const Vec3 normal = p.normal.stableNormalized();
        m_planes.push_back(
            {p.point.x(), p.point.y(), p.point.z(), normal.x(), normal.y(), normal.z(), p.friction});
    }
}

void Colliders::collide(const Kernels& kernels, const StepData& data, RowRange rows) const {
    for (const SphereData& sphere : m_spheres)
        kernels.collideSphere(data, rows, sphere);
    for (const PlaneData& plane : m_planes)
        kernels.collidePlane(data, rows, plane);
}

} // namespace clothlab
