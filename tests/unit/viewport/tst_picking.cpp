// Picking against all pictures of points and springs, computed one by one by the words of the header.
#include "app/viewport/picking.h"

#include <QRectF>
#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace clothlab;

namespace {

using Kind = Selection::Kind;
using Item = Selection::Item;

const QSizeF kSize(800, 600);

QVector3D at(const PointArray& position, int i) {
    const Vec3 p = position.at(i);
    return {float(p.x()), float(p.y()), float(p.z())};
}

// Upright, one metre square, seen from the front.
PointArray uprightSheet(const Grid& grid) {
    PointArray position(std::size_t(grid.pointCount()));
    for (int i = 0; i < grid.pointCount(); ++i) {
        const GridPoint p = grid.place(i);
        position.set(i, {double(p.x) / (grid.width - 1), double(p.y) / (grid.height - 1), 0});
    }
    return position;
}

Camera frontCamera() {
    Camera camera;
    camera.view.target = {0.5, 0.5, 0};
    camera.view.distance = 3;
    return camera;
}

PickQuery queryAt(QPointF position) {
    PickQuery query;
    query.position = position;
    query.size = kSize;
    return query;
}

struct Candidate {
    int number;
    double pixels;
    double depth;
};

// The nearest; of those at most 1.5 pixels farther the one in front; of those as far in front the nearest.
std::optional<int> choose(const std::vector<Candidate>& all) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    double nearest = inf, front = inf;
    for (const Candidate& c : all)
        nearest = std::min(nearest, c.pixels);
    for (const Candidate& c : all)
        if (c.pixels <= nearest + 1.5)
            front = std::min(front, c.depth);
    std::optional<int> best;
    double bestPixels = inf;
    for (const Candidate& c : all)
        if (c.pixels <= nearest + 1.5 && c.depth <= front + 0.002 * std::abs(front) &&
            c.pixels < bestPixels) {
            best = c.number;
            bestPixels = c.pixels;
        }
    return best;
}

double distanceToSegment(QPointF p, QPointF a, QPointF b, double& along) {
    // The distance falls up to the nearest place and then grows: cut off the third that is farther.
    const auto distance = [&](double t) {
        const QPointF d = a + t * (b - a) - p;
        return std::hypot(d.x(), d.y());
    };
    double from = 0, to = 1;
    for (int i = 0; i < 100; ++i) {
        const double third = (to - from) / 3;
        if (distance(from + third) < distance(to - third))
            to -= third;
        else
            from += third;
    }
    along = from;
    return distance(along);
}

std::optional<Item> pickFromAll(const Camera& camera, const Grid& grid, const PointArray& position,
                                const PickQuery& query) {
    std::vector<Candidate> points, springs;
    std::vector<Camera::Projected> pictures;
    for (int i = 0; i < grid.pointCount(); ++i) {
        pictures.push_back(camera.project(at(position, i), query.size));
        const QPointF d = pictures.back().position - query.position;
        const double pixels = std::hypot(d.x(), d.y());
        if (pictures.back().visible && pixels <= query.pointRadius)
            points.push_back({i, pixels, double(pictures.back().depth)});
    }
    if (const auto point = choose(points))
        return Item{Kind::Point, *point};
    for (int number = 0; number < grid.springCount(); ++number) {
        const Spring s = grid.spring(number);
        const Camera::Projected& a = pictures[std::size_t(s.a)];
        const Camera::Projected& b = pictures[std::size_t(s.b)];
        if (!a.visible || !b.visible || !query.springs[std::size_t(s.type())])
            continue;
        double along = 0;
        const double pixels = distanceToSegment(query.position, a.position, b.position, along);
        if (pixels <= query.springRadius)
            springs.push_back({number, pixels, double(a.depth) + along * double(b.depth - a.depth)});
    }
    if (const auto spring = choose(springs))
        return Item{Kind::Spring, *spring};
    return std::nullopt;
}

QByteArray words(const std::optional<Item>& item) {
    if (!item)
        return "nothing";
    return (item->kind == Kind::Point ? "point " : "spring ") + QByteArray::number(item->number);
}

} // namespace

class TestPicking : public QObject {
    Q_OBJECT
private slots:
    void anyPlaceAgainstAllPictures_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 10; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void anyPlaceAgainstAllPictures() {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        const auto between = [&](double a, double b) {
            return a + (b - a) * double(random()) / double(std::mt19937::max());
        };
        const Grid grid{int(2 + random() % 7), int(2 + random() % 7)};
        int found[2] = {0, 0};
        for (int i = 0; i < 150; ++i) {
            PointArray position(std::size_t(grid.pointCount()));
            for (int p = 0; p < grid.pointCount(); ++p) // crumpled beyond what cloth does
                position.set(p, {between(0, 1), between(0, 1), between(-0.5, 0.5)});
            Camera camera = frontCamera();
            camera.view.azimuth = between(-180, 180);
            camera.view.elevation = between(-90, 90);
            camera.view.distance = between(0.3, 4); // near ones have points behind the eye
            camera.orthographic = random() % 2 == 0;
            PickQuery query = queryAt({between(200, 600), between(100, 500)});
            if (random() % 2 == 0) { // near the picture of some point
                const int near = int(random() % unsigned(grid.pointCount()));
                query.position = camera.project(at(position, near), kSize).position +
                                 QPointF(between(-9, 9), between(-9, 9));
            }
            query.surfaceHides = false;
            query.springs = {random() % 4 != 0, random() % 4 != 0, random() % 4 != 0};
            const auto picked = pick(camera, grid, position, query);
            const auto expected = pickFromAll(camera, grid, position, query);
            QVERIFY2(picked == expected,
                     words(picked) + " instead of " + words(expected) + ", query " + QByteArray::number(i));
            if (picked)
                ++found[int(picked->kind)];
        }
        QVERIFY(found[0] > 0 && found[1] > 0);
    }

    void everyPointIsFoundWhereItIs() {
        const Grid grid{7, 5};
        const PointArray position = uprightSheet(grid);
        for (const bool orthographic : {false, true}) {
            Camera camera = frontCamera();
            camera.orthographic = orthographic;
            for (int i = 0; i < grid.pointCount(); ++i) {
                const QPointF place = camera.project(at(position, i), kSize).position;
                const auto picked = pick(camera, grid, position, queryAt(place + QPointF(2, -3)));
                QVERIFY2(picked == Item({Kind::Point, i}), words(picked));
            }
        }
    }

    void everyStructuralSpringIsFoundAtItsMiddle() {
        const Grid grid{4, 4};
        const PointArray position = uprightSheet(grid);
        const Camera camera = frontCamera();
        PickQuery query;
        query.size = kSize;
        query.springs = {true, false, false};
        for (int number = 0; number < grid.springCount(SpringType::Structural); ++number) {
            const Spring s = grid.spring(number);
            query.position = camera.project((at(position, s.a) + at(position, s.b)) / 2, kSize).position;
            const auto picked = pick(camera, grid, position, query);
            QVERIFY2(picked == Item({Kind::Spring, number}), words(picked));
        }
        query.springs = {false, false, false};
        QVERIFY(!pick(camera, grid, position, query));
    }

    void aPointWinsOverASpring() {
        const Grid grid{4, 4};
        const PointArray position = uprightSheet(grid);
        const Camera camera = frontCamera();
        const QPointF place = camera.project(at(position, 5), kSize).position;
        const QPointF right = camera.project(at(position, 6), kSize).position;
        const QPointF along = (right - place) / std::hypot(right.x() - place.x(), right.y() - place.y());
        PickQuery query = queryAt(place + 7 * along); // on the spring, and 7 pixels from the point
        QVERIFY(pick(camera, grid, position, query) == Item({Kind::Point, 5}));
        query.position = place + 9 * along;
        QVERIFY(pick(camera, grid, position, query).value().kind == Kind::Spring);
        query.pointRadius = 10;
        QVERIFY(pick(camera, grid, position, query) == Item({Kind::Point, 5}));
        query.position = {5, 5};
        QVERIFY(!pick(camera, grid, position, query));
    }

    void theNearerOfTwoWinsWhateverTheirOrder() {
        const Grid grid{2, 2};
        const Camera camera = frontCamera();
        const double pixel = double(camera.metresPerPixel(3, kSize));
        for (const int nearer : {0, 1}) { // 1 pixel nearer, in the same plane
            PointArray position(4);
            position.set(nearer, {0.5 + 4 * pixel, 0.5, 0});
            position.set(1 - nearer, {0.5 - 5 * pixel, 0.5, 0});
            position.set(2, {2, 2, 0});
            position.set(3, {-2, 2, 0});
            const auto picked = pick(camera, grid, position, queryAt({400, 300}));
            QVERIFY2(picked == Item({Kind::Point, nearer}), words(picked));
        }
    }

    void ofTwoInOnePlaceTheOneInFrontWins() {
        const Grid grid{2, 2};
        for (const bool orthographic : {false, true})
            for (const int front : {0, 1}) {
                Camera camera = frontCamera();
                camera.orthographic = orthographic;
                PointArray position(4);
                position.set(front, {0.5, 0.5, 0.3});
                position.set(1 - front, {0.5, 0.5, -0.3});
                position.set(2, {2, 2, 0});
                position.set(3, {-2, 2, 0});
                PickQuery query = queryAt({401, 301});
                query.surfaceHides = false;
                const auto picked = pick(camera, grid, position, query);
                QVERIFY2(picked == Item({Kind::Point, front}), words(picked));
            }
    }

    // The rows 0 … 3 in front, the rows 7 … 4 behind them: halves of a sheet that was folded upwards.
    void pointsBehindAFoldAreHidden_data() {
        QTest::addColumn<bool>("orthographic");
        QTest::addColumn<double>("distance");
        QTest::newRow("perspective") << false << 3.0;
        QTest::newRow("parallel") << true << 3.0;
        QTest::newRow("parallel, the eye's plane behind all") << true << 0.2;
    }
    void pointsBehindAFoldAreHidden() {
        QFETCH(bool, orthographic);
        QFETCH(double, distance);
        const Grid grid{9, 8};
        PointArray position(std::size_t(grid.pointCount()));
        for (int i = 0; i < grid.pointCount(); ++i) {
            const GridPoint p = grid.place(i);
            const bool front = p.y < 4;
            const int row = front ? p.y : 7 - p.y;
            // The back half is shifted so that its points lie between those in front.
            position.set(i, {p.x * 0.125 + (front ? 0 : 0.06), 0.2 + row * 0.2 + (front ? 0 : -0.1),
                             front ? 1.0 : 0.4});
        }
        Camera camera = frontCamera();
        camera.orthographic = orthographic;
        camera.view.distance = distance;
        // The picture as large as it takes to have the sheet in it.
        const QSizeF size = distance < 1 ? QSizeF(12000, 9000) : kSize;
        PickQuery query;
        query.size = size;
        query.springs = {false, false, false};
        int covered = 0;
        for (int i = 4 * grid.width; i < grid.pointCount(); ++i) {
            const GridPoint p = grid.place(i);
            if (p.x == grid.width - 1 || p.y == 7)
                continue; // beside the half in front
            const Camera::Projected picture = camera.project(at(position, i), size);
            QVERIFY(picture.visible);
            query.position = picture.position;
            query.surfaceHides = true;
            const auto hidden = pick(camera, grid, position, query);
            QVERIFY2(!hidden || hidden->number < 4 * grid.width, words(hidden));
            query.surfaceHides = false;
            covered += pick(camera, grid, position, query) == Item({Kind::Point, i}) ? 1 : 0;
        }
        QVERIFY(covered > 10);                     // so there was something to hide
        for (int i = 0; i < 4 * grid.width; ++i) { // and what is in front stays
            query.surfaceHides = true;
            query.position = camera.project(at(position, i), size).position;
            const auto picked = pick(camera, grid, position, query);
            QVERIFY2(picked == Item({Kind::Point, i}), words(picked));
        }
    }

    void viewsWithoutSizeDoNotCrash() {
        const Grid grid{4, 4};
        const PointArray position = uprightSheet(grid);
        for (const QSizeF size : {QSizeF(0, 0), QSizeF(0, 100), QSizeF(100, 0), QSizeF(-1, -1)})
            for (const bool orthographic : {false, true}) {
                Camera camera = frontCamera();
                camera.orthographic = orthographic;
                PickQuery query = queryAt({0, 0});
                query.size = size;
                const auto picked = pick(camera, grid, position, query);
                QVERIFY(!picked || picked->number < grid.springCount());
                QVERIFY(pointsIn(QRectF(0, 0, 10, 10), camera, position, size).size() <= position.size());
            }
    }

    void aSheetShrunkToAPlaceIsStillASheet() {
        const Grid grid{3, 3};
        PointArray position(9);
        for (int i = 0; i < 9; ++i)
            position.set(i, {0.5, 0.5, 0});
        const auto picked = pick(frontCamera(), grid, position, queryAt({400, 300}));
        QVERIFY2(picked == Item({Kind::Point, 0}), words(picked));
    }

    void whatHasNoPlaceIsNotPicked() {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        const Grid grid{3, 3};
        PointArray position = uprightSheet(grid);
        position.set(4, {nan, nan, nan});
        const Camera camera = frontCamera();
        PickQuery query = queryAt({400, 300});
        query.springs = {true, true, false}; // those of the point; bending springs pass by its place
        QVERIFY(!pick(camera, grid, position, query));
        const auto all = pointsIn(QRectF(0, 0, 800, 600), camera, position, kSize);
        QVERIFY(all == std::vector<int>({0, 1, 2, 3, 5, 6, 7, 8}));
        const QPointF corner = camera.project(at(position, 0), kSize).position;
        QVERIFY(pick(camera, grid, position, queryAt(corner)) == Item({Kind::Point, 0}));
    }

    void aSphereHidesWhatIsBehindIt() {
        const Grid grid{5, 5};
        const PointArray position = uprightSheet(grid);
        const Camera camera = frontCamera();
        const auto pickedAt = [&](int point, const std::vector<Sphere>& spheres) {
            PickQuery query = queryAt(camera.project(at(position, point), kSize).position);
            query.surfaceHides = false; // as of a wireframe
            query.spheres = spheres;
            return pick(camera, grid, position, query);
        };
        constexpr int middle = 12, corner = 0;
        Sphere sphere;
        sphere.radius = 0.2;
        sphere.origin = {0.5, 0.5, 0.5};
        QVERIFY(!pickedAt(middle, {sphere}));
        QVERIFY(pickedAt(corner, {sphere}) == Item({Kind::Point, corner}));
        sphere.origin.z() = -0.5;
        QVERIFY(pickedAt(middle, {sphere}) == Item({Kind::Point, middle}));
        sphere.origin.z() = -0.2; // the point lies on it
        QVERIFY(pickedAt(middle, {sphere}) == Item({Kind::Point, middle}));
        sphere.origin.z() = 5; // behind the camera
        QVERIFY(pickedAt(middle, {sphere}) == Item({Kind::Point, middle}));
    }

    void aRectangleHoldsThePointsInIt() {
        const Grid grid{6, 5};
        const PointArray position = uprightSheet(grid);
        Camera camera = frontCamera();
        camera.view.azimuth = 40;
        camera.view.elevation = 25;
        std::mt19937 random(1);
        for (int i = 0; i < 100; ++i) {
            const QRectF box(200 + int(random() % 300), 100 + int(random() % 300), int(random() % 300),
                             int(random() % 300));
            std::vector<int> expected;
            for (int p = 0; p < grid.pointCount(); ++p) {
                const QPointF place = camera.project(at(position, p), kSize).position;
                if (place.x() >= box.left() && place.x() <= box.left() + box.width() &&
                    place.y() >= box.top() && place.y() <= box.top() + box.height())
                    expected.push_back(p);
            }
            QVERIFY(pointsIn(box, camera, position, kSize) == expected);
        }
    }
};

QTEST_APPLESS_MAIN(TestPicking)
#include "tst_picking.moc"
