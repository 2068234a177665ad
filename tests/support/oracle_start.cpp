// Where the oracle's sheet starts and what its springs are.
#include "tests/support/oracle.h"
#include "tests/support/random.h"

namespace clothlab::oracle {
namespace {

struct Link {
    SpringType type;
    int dx;
    int dy;
};
constexpr Link kLinks[] = {{SpringType::Structural, -1, 0}, {SpringType::Structural, 0, -1},
                           {SpringType::Shearing, -1, -1},  {SpringType::Shearing, 1, -1},
                           {SpringType::Bending, -2, 0},    {SpringType::Bending, 0, -2}};

std::vector<PointMass> startPoints(const Scene& scene) {
    const clothlab::Cloth& cloth = scene.cloth;
    const int nx = cloth.numWidthPoints;
    const int ny = cloth.numHeightPoints;
    const double dx = nx > 1 ? cloth.width / (nx - 1) : 0;
    const double dy = ny > 1 ? cloth.height / (ny - 1) : 0;
    SplitMix64 random(scene.simulation.seed);
    std::vector<PointMass> points;
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            PointMass p;
            if (cloth.orientation == Orientation::Horizontal)
                p.position = Vec3(x * dx, 1, y * dy);
            else
                p.position = Vec3(x * dx, y * dy, -0.001 + 0.002 * random.unit());
            p.lastPosition = p.position;
            points.push_back(p);
        }
    }
    for (const GridPoint& pin : cloth.pinned)
        points[std::size_t(pin.y * nx + pin.x)].pinned = true;
    return points;
}

std::vector<Spring> springsOf(const clothlab::Cloth& cloth, const std::vector<PointMass>& points) {
    const int nx = cloth.numWidthPoints;
    const int ny = cloth.numHeightPoints;
    std::vector<Spring> springs;
    for (const Link& link : kLinks) {
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                const int otherX = x + link.dx;
                const int otherY = y + link.dy;
                if (otherX < 0 || otherX >= nx || otherY < 0 || otherY >= ny)
                    continue;
                Spring s;
                s.a = y * nx + x;
                s.b = otherY * nx + otherX;
                s.restLength = (points[std::size_t(s.a)].position - points[std::size_t(s.b)].position).norm();
                s.stiffness = link.type == SpringType::Bending ? 0.2 * cloth.ks : cloth.ks;
                s.type = link.type;
                springs.push_back(s);
            }
        }
    }
    return springs;
}

} // namespace

Cloth::Cloth(const Scene& scene)
    : points(startPoints(scene)), springs(springsOf(scene.cloth, points)), m_scene(scene) {
    const clothlab::Cloth& c = scene.cloth;
    m_pointMass = c.width * c.height * c.density / (double(c.numWidthPoints) * double(c.numHeightPoints));
}

} // namespace clothlab::oracle
