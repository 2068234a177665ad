#include "app/viewport/picking.h"

#include "app/picture/to_vector_3d.h"

#include <QRectF>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace clothlab {
namespace {

// Distance along the ray to the triangle (Möller and Trumbore 1997), or infinity.
float hitDistance(const Ray& ray, const QVector3D& a, const QVector3D& b, const QVector3D& c) {
    constexpr float miss = std::numeric_limits<float>::infinity();
    const QVector3D ab = b - a;
    const QVector3D ac = c - a;
    const QVector3D p = QVector3D::crossProduct(ray.direction, ac);
    const float determinant = QVector3D::dotProduct(ab, p);
    if (determinant == 0)
        return miss;
    const QVector3D fromA = ray.origin - a;
    const float u = QVector3D::dotProduct(fromA, p) / determinant;
    const QVector3D q = QVector3D::crossProduct(fromA, ab);
    const float v = QVector3D::dotProduct(ray.direction, q) / determinant;
    const float t = QVector3D::dotProduct(ac, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : miss;
}

// The same to where the ray enters a sphere.
float hitDistance(const Ray& ray, const Sphere& sphere) {
    const QVector3D toCentre = toVector3D(sphere.origin) - ray.origin;
    const float along = QVector3D::dotProduct(toCentre, ray.direction);
    const float besideSquared = toCentre.lengthSquared() - along * along;
    const float halfChordSquared = float(sphere.radius * sphere.radius) - besideSquared;
    const float t = along - std::sqrt(std::max(0.0F, halfChordSquared));
    return halfChordSquared > 0 && t > 0 ? t : std::numeric_limits<float>::infinity();
}

// Distance along the ray to the sheet's surface, or infinity.
float surfaceDistance(const Ray& ray, const Grid& grid, const PointArray& position) {
    float nearest = std::numeric_limits<float>::infinity();
    const auto corner = [&](int x, int y) { return toVector3D(position.at(grid.index(x, y))); };
    for (int y = 0; y + 1 < grid.height; ++y)
        for (int x = 0; x + 1 < grid.width; ++x) {
            const QVector3D b = corner(x + 1, y), c = corner(x, y + 1);
            nearest = std::min({nearest, hitDistance(ray, corner(x, y), b, c),
                                hitDistance(ray, b, c, corner(x + 1, y + 1))});
        }
    return nearest;
}

// Depth, along the view direction, from which on nothing can be seen under the mouse; infinity if there is
// none.
float hiddenFrom(const Camera& camera, const Grid& grid, const PointArray& position, const PickQuery& query) {
    const Ray ray = camera.rayThrough(query.position, query.size);
    float nearest =
        query.surfaceHides ? surfaceDistance(ray, grid, position) : std::numeric_limits<float>::infinity();
    for (const Sphere& sphere : query.spheres)
        nearest = std::min(nearest, hitDistance(ray, sphere));
    if (!std::isfinite(nearest))
        return nearest;
    const float depth = camera.project(ray.origin + nearest * ray.direction, query.size).depth;
    // A point beside the ray may lie a little deeper than where the ray meets the surface.
    return depth + 4 * float(query.pointRadius) * camera.metresPerPixel(depth, query.size);
}

// What is under the mouse, as far as a hand can tell.
class Candidates {
public:
    void offer(int number, double pixels, float depth) { m_all.push_back({number, pixels, depth}); }

    std::optional<int> best() {
        // Pictures closer together than this are as near to a hand with a mouse.
        constexpr double same = 1.5;
        const auto nearest = std::ranges::min_element(m_all, {}, &Candidate::pixels);
        if (nearest == m_all.end())
            return std::nullopt;
        std::erase_if(m_all, [limit = nearest->pixels + same](const auto& c) { return c.pixels > limit; });
        const float front = std::ranges::min_element(m_all, {}, &Candidate::depth)->depth;
        std::erase_if(m_all,
                      [limit = front + 0.002F * std::abs(front)](const auto& c) { return c.depth > limit; });
        return std::ranges::min_element(m_all, {}, &Candidate::pixels)->number;
    }

private:
    struct Candidate {
        int number;
        double pixels;
        float depth;
    };
    std::vector<Candidate> m_all;
};

// Place on the segment nearest to a point, 0 … 1 from its start.
double nearestOnSegment(QPointF p, QPointF a, QPointF b) {
    const QPointF ab = b - a;
    const double lengthSquared = QPointF::dotProduct(ab, ab);
    return lengthSquared > 0 ? std::clamp(QPointF::dotProduct(p - a, ab) / lengthSquared, 0.0, 1.0) : 0;
}

double length(QPointF p) {
    return std::hypot(p.x(), p.y());
}

} // namespace

std::optional<Selection::Item> pick(const Camera& camera, const Grid& grid, const PointArray& position,
                                    const PickQuery& query) {
    std::vector<Camera::Projected> projected(position.size());
    for (int i = 0; i < int(position.size()); ++i)
        projected[std::size_t(i)] = camera.project(toVector3D(position.at(i)), query.size);

    const float behind = hiddenFrom(camera, grid, position, query);
    Candidates points;
    for (int i = 0; i < int(projected.size()); ++i) {
        const Camera::Projected& p = projected[std::size_t(i)];
        const double pixels = length(p.position - query.position);
        if (p.visible && pixels <= query.pointRadius && !(p.depth > behind))
            points.offer(i, pixels, p.depth);
    }
    if (const auto point = points.best())
        return Selection::Item{Selection::Kind::Point, *point};

    Candidates springs;
    for (int number = 0, count = grid.springCount(); number < count; ++number) {
        const Spring s = grid.spring(number);
        const Camera::Projected& a = projected[std::size_t(s.a)];
        const Camera::Projected& b = projected[std::size_t(s.b)];
        if (!query.springs[std::size_t(s.type())] || !a.visible || !b.visible)
            continue;
        const double along = nearestOnSegment(query.position, a.position, b.position);
        const double pixels = length(a.position + along * (b.position - a.position) - query.position);
        const float depth = a.depth + float(along) * (b.depth - a.depth);
        if (pixels <= query.springRadius && !(depth > behind))
            springs.offer(number, pixels, depth);
    }
    if (const auto spring = springs.best())
        return Selection::Item{Selection::Kind::Spring, *spring};
    return std::nullopt;
}

std::vector<int> pointsIn(const QRectF& rectangle, const Camera& camera, const PointArray& position,
                          QSizeF size) {
    std::vector<int> inside;
    for (int i = 0; i < int(position.size()); ++i) {
        const Camera::Projected p = camera.project(toVector3D(position.at(i)), size);
        if (p.visible && rectangle.contains(p.position))
            inside.push_back(i);
    }
    return inside;
}

} // namespace clothlab
