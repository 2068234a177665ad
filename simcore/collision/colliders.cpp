#include "simcore/collision/colliders.h"

#include <cmath>

namespace clothlab {

void collide(const Sphere& sphere, const std::vector<std::uint8_t>& pinned, ClothState& state) {
    for (int i = 0; i < int(state.size()); ++i) {
        const Vec3 offset = state.position.at(i) - sphere.origin;
        const double distanceSquared = offset.squaredNorm();
        if (!(distanceSquared < sphere.radius * sphere.radius) || pinned[std::size_t(i)])
            continue;
        const double distance = std::sqrt(distanceSquared);
        const Vec3 direction = distance > 0 ? Vec3(offset / distance) : Vec3::UnitY();
        const Vec3 tangent = sphere.origin + sphere.radius * direction;
        const Vec3 last = state.lastPosition.at(i);
        state.position.set(i, last + (1 - sphere.friction) * (tangent - last));
    }
}

void collide(const Plane& plane, const std::vector<std::uint8_t>& pinned, ClothState& state) {
    const Vec3 normal = plane.normal.stableNormalized();
    for (int i = 0; i < int(state.size()); ++i) {
        const Vec3 position = state.position.at(i);
        const Vec3 last = state.lastPosition.at(i);
        const double height = (position - plane.point).dot(normal);
        const double side = (last - plane.point).dot(normal) >= 0 ? 1 : -1;
        const bool crossed = side > 0 ? height < 0 : height >= 0;
        if (!crossed || pinned[std::size_t(i)])
            continue;
        const Vec3 tangent = position + (side * kPlaneOffset - height) * normal;
        state.position.set(i, last + (1 - plane.friction) * (tangent - last));
    }
}

} // namespace clothlab
