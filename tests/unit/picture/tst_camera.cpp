#include "app/picture/camera.h"

#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace clothlab;

Q_DECLARE_METATYPE(clothlab::ViewDirection)

namespace {

const std::array<QSizeF, 5> kSizes{{{1440, 900}, {500, 500}, {400, 1200}, {1920, 200}, {1, 1}}};

struct Random {
    std::mt19937 engine;
    double operator()(double from, double to) {
        return from + (to - from) * double(engine()) / double(std::mt19937::max());
    }
    QVector3D vector(double reach) {
        return {float((*this)(-reach, reach)), float((*this)(-reach, reach)), float((*this)(-reach, reach))};
    }
};

Camera randomCamera(Random& random) {
    Camera camera;
    camera.view.target = {random(-2, 2), random(-2, 2), random(-2, 2)};
    camera.view.distance = std::exp(random(-2, 3));
    camera.view.azimuth = random(-180, 180);
    camera.view.elevation = random(-90, 90);
    camera.orthographic = random(0, 1) < 0.5;
    return camera;
}

double distanceTo(const Ray& ray, const QVector3D& point) {
    return double(point.distanceToLine(ray.origin, ray.direction));
}

bool near(const QVector3D& a, const QVector3D& b, double tolerance) {
    return double((a - b).length()) <= tolerance;
}

QByteArray words(const QVector3D& v) {
    return QStringLiteral("(%1, %2, %3)").arg(v.x()).arg(v.y()).arg(v.z()).toUtf8();
}

} // namespace

class TestCamera : public QObject {
    Q_OBJECT
private slots:
    void theTargetIsInTheMiddle() {
        Random random{std::mt19937(1)};
        for (const QSizeF size : kSizes)
            for (int i = 0; i < 50; ++i) {
                const Camera camera = randomCamera(random);
                const Camera::Projected p = camera.project(camera.target(), size);
                QVERIFY(p.visible);
                QVERIFY(std::abs(p.position.x() - size.width() / 2) < 1e-3 * size.width());
                QVERIFY(std::abs(p.position.y() - size.height() / 2) < 1e-3 * size.height());
                QVERIFY(std::abs(double(p.depth) / camera.view.distance - 1) < 1e-4);
            }
    }

    void rayAndPictureAreInverse() {
        Random random{std::mt19937(2)};
        for (const QSizeF size : {QSizeF(1440, 900), QSizeF(500, 500), QSizeF(400, 1200)})
            for (int i = 0; i < 300; ++i) {
                const Camera camera = randomCamera(random);
                // From the screen into the world and back, at any depth.
                const QPointF at(random(0, size.width()), random(0, size.height()));
                const Ray ray = camera.rayThrough(at, size);
                QVERIFY(std::abs(double(ray.direction.length()) - 1) < 1e-5);
                const auto start = double(QVector3D::dotProduct(camera.eye() - ray.origin, ray.direction));
                const double along = start + camera.view.distance * random(0.3, 3);
                const Camera::Projected p = camera.project(ray.origin + float(along) * ray.direction, size);
                QVERIFY(p.visible);
                const QPointF miss = p.position - at;
                QVERIFY2(std::hypot(miss.x(), miss.y()) < 0.1, qPrintable(QString::number(i)));
                // From the world onto the screen and back.
                const QVector3D point = camera.target() + random.vector(camera.view.distance / 2);
                const Camera::Projected q = camera.project(point, size);
                QVERIFY(q.visible);
                QVERIFY(distanceTo(camera.rayThrough(q.position, size), point) < 1e-3 * camera.view.distance);
            }
    }

    void theMatricesSayTheSameAsTheDefinition() {
        // Right and up on the screen are right and up in the world, and the depth is along the view.
        Camera camera;
        camera.view.target = {1, 2, 3};
        camera.view.distance = 4;
        const QSizeF size(800, 600);
        QVERIFY(near(camera.eye(), {1, 2, 7}, 1e-5)); // azimuth 0 looks along -z
        for (const bool orthographic : {false, true}) {
            camera.orthographic = orthographic;
            // One metre in the target plane is the same either way, so that switching does not jump.
            const double pixels = 300 / (4 * std::tan(17.5 / 180 * M_PI));
            const Camera::Projected right = camera.project({2, 2, 3}, size);
            QVERIFY(std::abs(right.position.x() - (400 + pixels)) < 0.01);
            QVERIFY(std::abs(right.position.y() - 300) < 0.01);
            const Camera::Projected up = camera.project({1, 3, 3}, size);
            QVERIFY(std::abs(up.position.x() - 400) < 0.01);
            QVERIFY(std::abs(up.position.y() - (300 - pixels)) < 0.01);
            QVERIFY(std::abs(double(camera.metresPerPixel(4, size)) * pixels - 1) < 1e-4);
            QVERIFY(std::abs(camera.project({1, 2, 5}, size).depth - 2) < 1e-4F);
            const double farther = camera.project({2, 2, -1}, size).position.x() - 400;
            QVERIFY(std::abs(farther - (orthographic ? pixels : pixels / 2)) < 0.01);
        }
    }

    void nothingIsVisibleBehindAnEyeInPerspective() {
        Random random{std::mt19937(3)};
        for (int i = 0; i < 200; ++i) {
            Camera camera = randomCamera(random);
            const QVector3D back = camera.eye() - camera.target();
            camera.orthographic = false;
            QVERIFY(!camera.project(camera.target() + 1.01F * back, {800, 600}).visible);
            QVERIFY(!camera.project(camera.eye() + 50 * back, {800, 600}).visible);
            QVERIFY(camera.project(camera.target() + 0.9F * back, {800, 600}).visible);
            camera.orthographic = true; // parallel rays have no eye
            QVERIFY(camera.project(camera.target() + 1.5F * back, {800, 600}).visible);
        }
    }

    void parallelRaysBeginBeforeAllThatIsDrawn() {
        Random random{std::mt19937(4)};
        for (int i = 0; i < 100; ++i) {
            Camera camera = randomCamera(random);
            camera.orthographic = true;
            const QSizeF size(800, 600);
            const Ray ray = camera.rayThrough({400, 300}, size);
            // The near plane, by undoing the projection.
            const QVector3D nearest = camera.viewProjection(size).inverted().map(QVector3D(0, 0, -1));
            QVERIFY(QVector3D::dotProduct(nearest - ray.origin, ray.direction) > 0);
            QVERIFY(double(QVector3D::dotProduct(camera.target() - nearest, ray.direction)) >= 10);
        }
    }

    void orbitingKeepsTargetAndDistance() {
        Random random{std::mt19937(5)};
        for (int i = 0; i < 100; ++i) {
            Camera camera = randomCamera(random);
            const CameraView before = camera.view;
            camera.orbit({random(-2000, 2000), random(-2000, 2000)});
            QCOMPARE(camera.view.distance, before.distance);
            QVERIFY(camera.view.target == before.target);
            QVERIFY(std::abs(camera.view.azimuth) <= 180);
            QVERIFY(std::abs(camera.view.elevation) <= 90); // never over the top
            const auto far = double((camera.eye() - camera.target()).length());
            QVERIFY(std::abs(far / before.distance - 1) < 1e-3);
        }
    }

    void orbitingTurnsTheSceneWithTheMouse() {
        Camera camera;                     // in front, looking along -z
        const QVector3D front(0, 0, 0.2F); // a point on the near side
        const QSizeF size(800, 600);
        const QPointF before = camera.project(front, size).position;
        Camera right = camera, down = camera;
        right.orbit({20, 0});
        QVERIFY(right.project(front, size).position.x() > before.x());
        down.orbit({0, 20});
        QVERIFY(down.project(front, size).position.y() > before.y());
        right.orbit({-20, 0});
        QVERIFY(std::abs(right.view.azimuth - camera.view.azimuth) < 1e-9);
    }

    void panningKeepsWhatIsUnderTheMouse() {
        Random random{std::mt19937(6)};
        for (const QSizeF size : {QSizeF(1440, 900), QSizeF(400, 1200)})
            for (int i = 0; i < 100; ++i) {
                Camera camera = randomCamera(random);
                const QPointF from(random(0, size.width()), random(0, size.height()));
                const QPointF moved(random(-200, 200), random(-200, 200));
                const QVector3D held = inTargetPlane(camera, from, size);
                const CameraView before = camera.view;
                camera.pan(moved, size);
                const QPointF miss = camera.project(held, size).position - (from + moved);
                QVERIFY2(std::hypot(miss.x(), miss.y()) < 0.1, words(held));
                QCOMPARE(camera.view.distance, before.distance);
                QCOMPARE(camera.view.azimuth, before.azimuth);
                QCOMPARE(camera.view.elevation, before.elevation);
            }
    }

    void zoomingKeepsWhatIsUnderTheCursor() {
        Random random{std::mt19937(7)};
        for (const QSizeF size : {QSizeF(1440, 900), QSizeF(400, 1200)})
            for (int i = 0; i < 100; ++i) {
                Camera camera = randomCamera(random);
                const QPointF at(random(0, size.width()), random(0, size.height()));
                const QVector3D held = inTargetPlane(camera, at, size);
                const double before = camera.view.distance;
                const double factor = std::exp(random(-1, 1));
                camera.zoom(factor, at, size);
                QVERIFY(std::abs(camera.view.distance / before - factor) < 1e-9);
                const QPointF miss = camera.project(held, size).position - at;
                QVERIFY2(std::hypot(miss.x(), miss.y()) < 0.1, words(held));
            }
    }

    void zoomingEndsAtLimits() {
        for (const double factor : {0.5, 2.0}) {
            Camera camera;
            for (int i = 0; i < 200; ++i)
                camera.zoom(factor, {100, 100}, {800, 600});
            QVERIFY(camera.view.distance > 0.001 && camera.view.distance < 1e6);
            const Vec3 target = camera.view.target;
            camera.zoom(factor, {100, 100}, {800, 600});
            QVERIFY(camera.view.target == target); // at the limit nothing slides
        }
    }

    void directionsLookAlongTheAxes_data() {
        QTest::addColumn<ViewDirection>("direction");
        QTest::addColumn<QVector3D>("back");
        QTest::addColumn<QVector3D>("up");
        QTest::newRow("front") << ViewDirection::Front << QVector3D(0, 0, 1) << QVector3D(0, 1, 0);
        QTest::newRow("back") << ViewDirection::Back << QVector3D(0, 0, -1) << QVector3D(0, 1, 0);
        QTest::newRow("right") << ViewDirection::Right << QVector3D(1, 0, 0) << QVector3D(0, 1, 0);
        QTest::newRow("left") << ViewDirection::Left << QVector3D(-1, 0, 0) << QVector3D(0, 1, 0);
        QTest::newRow("top") << ViewDirection::Top << QVector3D(0, 1, 0) << QVector3D(0, 0, -1);
        QTest::newRow("bottom") << ViewDirection::Bottom << QVector3D(0, -1, 0) << QVector3D(0, 0, 1);
    }
    void directionsLookAlongTheAxes() {
        QFETCH(ViewDirection, direction);
        QFETCH(QVector3D, back);
        QFETCH(QVector3D, up);
        Camera camera;
        camera.view.target = {1, 2, 3};
        camera.look(direction);
        const QVector3D from = (camera.eye() - camera.target()).normalized();
        QVERIFY2(near(from, back, 1e-5), words(from));
        const QSizeF size(600, 600);
        const Camera::Projected above = camera.project(camera.target() + 0.1F * up, size);
        QVERIFY(above.visible);
        QVERIFY(std::abs(above.position.x() - 300) < 0.01 && above.position.y() < 290);
    }

    void framingFitsASphere_data() {
        QTest::addColumn<QSizeF>("size");
        QTest::addColumn<bool>("orthographic");
        for (const QSizeF size : {QSizeF(1440, 900), QSizeF(900, 900), QSizeF(400, 1200), QSizeF(90, 900)})
            for (const bool orthographic : {false, true})
                QTest::addRow("%g by %g, %s", size.width(), size.height(),
                              orthographic ? "parallel" : "perspective")
                    << size << orthographic;
    }
    void framingFitsASphere() {
        QFETCH(QSizeF, size);
        QFETCH(bool, orthographic);
        Random random{std::mt19937(8)};
        for (const double radius : {0.02, 0.5, 30.0}) {
            Camera camera = randomCamera(random);
            camera.orthographic = orthographic;
            const QVector3D centre = random.vector(3);
            const CameraView before = camera.view;
            camera.frame(centre, radius, size);
            QCOMPARE(camera.view.azimuth, before.azimuth);
            QCOMPARE(camera.view.elevation, before.elevation);
            double widest = 0;
            for (int i = 0; i < 5000; ++i) {
                const QVector3D point = centre + random.vector(1).normalized() * float(radius);
                const Camera::Projected p = camera.project(point, size);
                QVERIFY(p.visible);
                const double x = std::abs(p.position.x() / size.width() * 2 - 1);
                const double y = std::abs(p.position.y() / size.height() * 2 - 1);
                widest = std::max({widest, x, y});
                const QVector3D clip = camera.viewProjection(size).map(point);
                QVERIFY(std::abs(clip.z()) < 1);
            }
            QVERIFY2(widest <= 1, qPrintable(QString::number(widest)));
            QVERIFY2(widest > 0.8, qPrintable(QString::number(widest))); // and not a speck
        }
    }

    void viewsWithoutSizeGiveNumbers() {
        Random random{std::mt19937(9)};
        for (const QSizeF size : {QSizeF(0, 0), QSizeF(0, 600), QSizeF(800, 0), QSizeF(-1, -1)})
            for (int i = 0; i < 20; ++i) {
                Camera camera = randomCamera(random);
                camera.pan({3, 4}, size);
                camera.zoom(0.5, {1, 1}, size);
                camera.frame(random.vector(1), 0.5, size);
                QVERIFY(camera.view.target.allFinite() && std::isfinite(camera.view.distance));
                const Camera::Projected p = camera.project(random.vector(1), size);
                QVERIFY(std::isfinite(p.position.x()) && std::isfinite(p.position.y()));
                const Ray ray = camera.rayThrough({1, 2}, size);
                QVERIFY(std::abs(double(ray.direction.length()) - 1) < 1e-4);
                for (int k = 0; k < 16; ++k)
                    QVERIFY(std::isfinite(camera.viewProjection(size).constData()[k]));
            }
    }

    void noPlaceIsNotVisible() {
        constexpr float nan = std::numeric_limits<float>::quiet_NaN();
        Camera camera;
        for (const bool orthographic : {false, true}) {
            camera.orthographic = orthographic;
            QVERIFY(!camera.project({nan, 0, 0}, {800, 600}).visible);
            QVERIFY(!camera.project({nan, nan, nan}, {800, 600}).visible);
        }
    }

    void theHomeViewShowsTheSheet() {
        for (const Orientation orientation : {Orientation::Horizontal, Orientation::Vertical})
            for (const double width : {0.2, 1.0, 5.0}) {
                Cloth cloth;
                cloth.orientation = orientation;
                cloth.width = width;
                Camera camera;
                camera.view = homeView(cloth);
                for (const double u : {0.0, cloth.width})
                    for (const double v : {0.0, cloth.height}) {
                        const QVector3D corner = orientation == Orientation::Horizontal
                                                     ? QVector3D(float(u), 1, float(v))
                                                     : QVector3D(float(u), float(v), 0);
                        const Camera::Projected p = camera.project(corner, {1440, 900});
                        QVERIFY(p.visible && QRectF(0, 0, 1440, 900).contains(p.position));
                    }
            }
    }

private:
    // Where the ray through a place on the screen meets the plane through the target across the view.
    static QVector3D inTargetPlane(const Camera& camera, QPointF at, QSizeF size) {
        const Ray ray = camera.rayThrough(at, size);
        const QVector3D back = (camera.eye() - camera.target()).normalized();
        const float t = QVector3D::dotProduct(camera.target() - ray.origin, back) /
                        QVector3D::dotProduct(ray.direction, back);
        return ray.origin + t * ray.direction;
    }
};

QTEST_APPLESS_MAIN(TestCamera)
#include "tst_camera.moc"
