// Small vectors for the loops over all points, where QVector3D's safe normalising would cost too much.
#pragma once

#include <array>
#include <cmath>

namespace clothlab::render {

using Vec3 = std::array<float, 3>;

inline Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 operator*(float s, const Vec3& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
inline float dot(const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Unit vector along `a`, or `fallback` where `a` has no finite direction.
inline Vec3 normalizedOr(const Vec3& a, const Vec3& fallback) {
    const float lengthSquared = dot(a, a);
    if (!(lengthSquared > 1e-30F) || !std::isfinite(lengthSquared))
        return fallback;
    return (1 / std::sqrt(lengthSquared)) * a;
}

// A unit vector perpendicular to the unit vector `n`.
inline Vec3 anyPerpendicular(const Vec3& n) {
    const Vec3 axis = std::abs(n[0]) < 0.8F ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
    return normalizedOr(axis - dot(axis, n) * n, {1, 0, 0});
}

} // namespace clothlab::render
