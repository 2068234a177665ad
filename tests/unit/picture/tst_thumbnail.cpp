#include "app/picture/thumbnail.h"

#include "tests/support/tiny_scene.h"

#include <QTest>

#include <chrono>
#include <limits>

using namespace clothlab;

namespace {

const ThumbnailLook kLook{Qt::black, Qt::white, QColor(0, 255, 0), QColor(255, 0, 0)};

Camera cameraOf(const Scene& scene) {
    Camera camera;
    camera.view = homeView(scene.cloth);
    return camera;
}

QImage pictureOf(const Scene& scene, const PointArray& position, const Camera& camera) {
    return thumbnail(scene, gridOf(scene.cloth), position, camera, {160, 100}, kLook);
}

Scene sheetOf(int points) {
    Scene scene;
    scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = points;
    scene.cloth.pinned = {{0, 0}};
    return scene;
}

} // namespace

class TestThumbnail : public QObject {
    Q_OBJECT
private slots:
    // Where the camera says that a point is, there is cloth; beside the sheet there is none.
    void theSheetIsWhereTheCameraSeesIt() {
        const Scene scene = sheetOf(30);
        const PointArray position = startState(scene).position;
        for (const bool orthographic : {false, true}) {
            Camera camera = cameraOf(scene);
            camera.orthographic = orthographic;
            const QImage picture = pictureOf(scene, position, camera);
            QCOMPARE(picture.size(), QSize(160, 100));
            for (int y = 1; y < 29; ++y)
                for (int x = 1; x < 29; ++x) {
                    const Vec3 p = position.at(y * 30 + x);
                    const auto seen = camera.project({float(p.x()), float(p.y()), float(p.z())}, {160, 100});
                    QVERIFY(seen.visible);
                    const QPoint pixel(int(seen.position.x()), int(seen.position.y()));
                    QVERIFY(qGray(picture.pixel(pixel)) > 30);
                }
            QCOMPARE(picture.pixel(1, 1), QColor(Qt::black).rgb());
        }
    }

    void itsSidesHaveTheirColors() {
        const Scene scene = sheetOf(10);
        const PointArray position = startState(scene).position;
        Camera camera = cameraOf(scene);
        const auto middle = [&] { return QColor(pictureOf(scene, position, camera).pixel(80, 50)); };
        camera.look(ViewDirection::Top);
        const QColor above = middle();
        camera.look(ViewDirection::Bottom);
        const QColor below = middle();
        const auto isGreen = [](const QColor& color) { return color.green() > 50 && color.red() < 20; };
        QVERIFY(isGreen(above) != isGreen(below));
    }

    void whatIsNearerHidesWhatIsBehind() {
        Scene scene = sheetOf(10);
        const PointArray position = startState(scene).position;
        scene.spheres.push_back({{0.5, 5, 0.5}, 0.5, 0.3, {}});
        Camera camera = cameraOf(scene);
        camera.view.distance = 20;
        camera.look(ViewDirection::Top);
        QCOMPARE(QColor(pictureOf(scene, position, camera).pixel(80, 50)).green(), 0); // the sphere
        camera.look(ViewDirection::Bottom);
        QVERIFY(QColor(pictureOf(scene, position, camera).pixel(80, 50)).green() > 50); // the sheet
    }

    void oddPlacesDoNoHarm() {
        const Scene scene = test::tinyScene();
        PointArray position = startState(scene).position;
        position.x[3] = std::numeric_limits<double>::quiet_NaN();
        position.y[5] = std::numeric_limits<double>::infinity();
        position.z[6] = 1e300;
        Camera camera = cameraOf(scene);
        QVERIFY(!pictureOf(scene, position, camera).isNull());
        camera.view.distance = 0.01; // in the middle of it
        QVERIFY(!pictureOf(scene, position, camera).isNull());
        Scene one = sheetOf(1);
        QVERIFY(!pictureOf(one, startState(one).position, camera).isNull());
    }

    void itIsQuick() {
        for (const int points : {50, 512}) {
            const Scene scene = sheetOf(points);
            const PointArray position = startState(scene).position;
            const auto before = std::chrono::steady_clock::now();
            constexpr int times = 20;
            for (int i = 0; i < times; ++i)
                QVERIFY(!pictureOf(scene, position, cameraOf(scene)).isNull());
            const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - before;
            qInfo("%d by %d points: %.2f ms", points, points, spent.count() / times);
            QVERIFY(spent.count() / times < 40); // a few ms, on a machine that may be busy
        }
    }
};

QTEST_GUILESS_MAIN(TestThumbnail)
#include "tst_thumbnail.moc"
