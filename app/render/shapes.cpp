#include "app/render/shapes.h"

#include <QQuaternion>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clothlab::render {
namespace {

void addSphereVertex(SurfaceMesh& mesh, float u, float v) {
    const float longitude = u * 2 * std::numbers::pi_v<float>;
    const float polar = v * std::numbers::pi_v<float>;
    const float c = std::cos(longitude);
    const float s = std::sin(longitude);
    const float ring = std::sin(polar);
    const float x = ring * c;
    const float y = std::cos(polar);
    const float z = -ring * s;
    // The tangent needs only the longitude, so it has a direction at the poles too.
    mesh.vertices.push_back({{x, y, z}, {x, y, z, 0}, {-s, 0, -c, 0}});
    mesh.uvs.push_back({u, v});
}

} // namespace

SurfaceMesh makeUnitSphere(int segments, int rings) {
    segments = std::max(segments, 3);
    rings = std::max(rings, 2);
    SurfaceMesh mesh;
    for (int ring = 0; ring <= rings; ++ring)
        for (int segment = 0; segment <= segments; ++segment)
            addSphereVertex(mesh, static_cast<float>(segment) / static_cast<float>(segments),
                            static_cast<float>(ring) / static_cast<float>(rings));
    const auto stride = static_cast<std::uint32_t>(segments + 1);
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            const auto a = static_cast<std::uint32_t>(ring) * stride + static_cast<std::uint32_t>(segment);
            if (ring + 1 < rings)
                mesh.indices.insert(mesh.indices.end(), {a, a + stride, a + stride + 1});
            if (ring > 0)
                mesh.indices.insert(mesh.indices.end(), {a, a + stride + 1, a + 1});
        }
    }
    return mesh;
}

SurfaceMesh makePlaneSquare() {
    SurfaceMesh mesh;
    for (const float v : {0.0F, 1.0F}) {
        for (const float u : {0.0F, 1.0F}) {
            mesh.vertices.push_back(
                {{(u - 0.5F) * kPlaneSide, 0, (v - 0.5F) * kPlaneSide}, {0, 1, 0, 0}, {1, 0, 0, 0}});
            mesh.uvs.push_back({u, v});
        }
    }
    mesh.indices = {0, 2, 1, 1, 2, 3};
    return mesh;
}

QMatrix4x4 sphereModel(const SphereShape& sphere) {
    QMatrix4x4 model;
    model.translate(sphere.origin);
    model.scale(kDrawnRadius * sphere.radius);
    return model;
}

QMatrix4x4 planeModel(const PlaneShape& plane) {
    QMatrix4x4 model;
    model.translate(plane.point);
    const QVector3D normal = plane.normal.normalized();
    if (!normal.isNull())
        model.rotate(QQuaternion::rotationTo(QVector3D(0, 1, 0), normal));
    return model;
}

} // namespace clothlab::render
