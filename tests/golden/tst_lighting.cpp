// Light on surfaces against formulas, pixel by pixel.
#include "tests/golden/canvas.h"

#include <optional>

using namespace clothlab::render;

class LightingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init() { QVERIFY(m_studio.emplace().isGood()); }
    void cleanup() { m_studio.reset(); }

    void diffuseIsLambert();
    void bothSidesAreLit();
    void normalShaderShowsDirections();
    void phongIsBrighterInTheLightAndNeverBlownOut();
    void backColorIsOnTheBackOnly();
    void oneSidedLightKnowsOneNormal();
    void shadowsFallWhereTheyShould_data();
    void shadowsFallWhereTheyShould();

private:
    std::optional<Studio> m_studio;
};

void LightingTest::diffuseIsLambert() {
    RenderFrame frame = flatFrame(20);
    frame.surface.shader = QStringLiteral("Diffuse");
    frame.surface.color = QVector4D(0.9F, 0.6F, 0.3F, 1);
    const QImage image = m_studio->draw(frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    for (int i = 0; i < 10; ++i) {
        const QPoint pixel =
            toPixel(frame, QVector3D(0.05F + 0.1F * float(i), 0.5F, 0.08F + 0.09F * float((i * 7) % 10)));
        const QVector3D toLight = frame.light.position - toPlane(frame, pixel, 0.5F);
        const float cosine = toLight.normalized().y();
        const QVector3D lit =
            frame.surface.color.toVector3D() * frame.light.intensity * (cosine / toLight.lengthSquared());
        const auto channel = [](float value) { return int(std::lround(255 * std::min(value, 1.0F))); };
        const QRgb expected = qRgb(channel(lit.x()), channel(lit.y()), channel(lit.z()));
        QVERIFY2(isNear(image.pixel(pixel), expected, 2),
                 qPrintable(QStringLiteral("%1 at %2,%3, expected %4")
                                .arg(QColor(image.pixel(pixel)).name())
                                .arg(pixel.x())
                                .arg(pixel.y())
                                .arg(QColor(expected).name())));
    }
}

// With light and camera mirrored at the sheet, the picture from below is as bright as that from above.
void LightingTest::bothSidesAreLit() {
    for (const char* shader : {"Diffuse", "Phong"}) {
        RenderFrame frame = flatFrame(10);
        frame.surface.shader = QString::fromLatin1(shader);
        const QPoint middle = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));
        const QRgb above = m_studio->draw(frame).pixel(middle);
        frame.cameraPosition.setY(1 - frame.cameraPosition.y());
        frame.light.position.setY(1 - frame.light.position.y());
        frame.viewProjection = viewFrom(frame.cameraPosition);
        const QRgb below = m_studio->draw(frame).pixel(toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F)));
        QVERIFY(qRed(below) > 60);
        // The sky is brighter than the ground; the lamp is the same.
        QVERIFY(isNear(above, below, frame.surface.shader == QLatin1String("Phong") ? 40 : 2));
    }
}

void LightingTest::normalShaderShowsDirections() {
    RenderFrame frame = flatFrame(10);
    frame.surface.shader = QStringLiteral("Normal");
    const QImage up = m_studio->draw(frame);
    for (const float u : {0.1F, 0.35F, 0.5F, 0.9F})
        QVERIFY(isNear(up.pixel(toPixel(frame, QVector3D(u, 0.5F, 1 - u))), qRgb(128, 255, 128), 1));
    for (std::size_t i = 0; i < frame.sheet.positions.size(); i += 3) // tilted: y grows with x by 1 : 1
        frame.sheet.positions[i + 1] = frame.sheet.positions[i];
    const QImage tilted = m_studio->draw(frame);
    const int high = int(std::lround(255 * (0.5 + 0.5 * std::sqrt(0.5))));
    QVERIFY(
        isNear(tilted.pixel(toPixel(frame, QVector3D(0.5F, 0.5F, 0.5F))), qRgb(255 - high, high, 128), 1));
}

void LightingTest::phongIsBrighterInTheLightAndNeverBlownOut() {
    RenderFrame frame = flatFrame(20);
    const QPoint nearLight = toPixel(frame, QVector3D(0.5F, 0.5F, 0.9F));
    const QPoint far = toPixel(frame, QVector3D(0.1F, 0.5F, 0.1F));
    const QImage lit = m_studio->draw(frame);
    QVERIFY(qRed(lit.pixel(nearLight)) > qRed(lit.pixel(far)) + 10);
    QVERIFY(qRed(lit.pixel(far)) > 100); // well lit
    frame.light.intensity *= 20;
    const QImage glaring = m_studio->draw(frame);
    QVERIFY(qRed(glaring.pixel(nearLight)) < 255);
    QVERIFY(qRed(glaring.pixel(nearLight)) > qRed(glaring.pixel(far)));
    frame.light.intensity = QVector3D();
    const QRgb dark = m_studio->draw(frame).pixel(far);
    QVERIFY(qRed(dark) > qRed(frame.background.rgb()) + 20); // ambient light is left
}

void LightingTest::backColorIsOnTheBackOnly() {
    RenderFrame frame = flatFrame(6);
    frame.spheres = {{QVector3D(0.5F, 0.5F, 0.9F), 0.2F}};
    frame.surface.shader = QStringLiteral("Normal");
    const QPoint pixel = toPixel(frame, QVector3D(0.3F, 0.5F, 0.3F));
    const QImage plainFront = m_studio->draw(frame);
    frame.surface.backColor = QVector4D(1, 0, 0.5F, 1);
    QCOMPARE(m_studio->draw(frame), plainFront);
    QVERIFY(isNear(plainFront.pixel(pixel), qRgb(128, 255, 128), 1));

    lookFrom(frame, QVector3D(0.5F, -1, 1.2F));
    const QPoint below = toPixel(frame, QVector3D(0.3F, 0.5F, 0.3F));
    const QImage back = m_studio->draw(frame);
    QVERIFY2(isNear(back.pixel(below), qRgb(128, 0, 64), 1), seen(back, below, qRgb(128, 0, 64)));
    frame.surface.backColor.reset();
    const QImage plainBack = m_studio->draw(frame);
    QVERIFY2(isNear(plainBack.pixel(below), qRgb(128, 0, 128), 1), seen(plainBack, below, qRgb(128, 0, 128)));
    const QPoint ball = toPixel(frame, QVector3D(0.5F, 0.33F, 0.9F)); // colliders have no other side
    QVERIFY(back.rect().contains(ball));
    QCOMPARE(back.pixel(ball), plainBack.pixel(ball));
}

// Camera and light on the same or on different sides of a sheet that faces up.
void LightingTest::oneSidedLightKnowsOneNormal() {
    RenderFrame frame = flatFrame(6);
    frame.surface.shader = QStringLiteral("Diffuse");
    for (const bool cameraAbove : {true, false}) {
        for (const bool lightAbove : {true, false}) {
            for (const bool twoSided : {true, false}) {
                lookFrom(frame, QVector3D(0.5F, cameraAbove ? 2 : -1, 1.2F));
                frame.light.position = QVector3D(0.5F, lightAbove ? 2 : -1, 1);
                frame.surface.twoSided = twoSided;
                const QPoint pixel = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));
                const bool lit = qRed(m_studio->draw(frame).pixel(pixel)) > 0;
                QCOMPARE(lit, twoSided ? cameraAbove == lightAbove : lightAbove);
            }
        }
    }
}

namespace {

constexpr QVector3D kLamp(0.3F, 2.2F, 0.9F);
const QVector3D kBall(0.5F, 0.6F, 0.3F);

// How far the way from a point to the lamp passes outside of what is in it, in metres there; negative:
// within.
float missesSheet(const QVector3D& point) {
    const QVector3D at = Ray{point, kLamp - point}.meets(QVector3D(0, 0.5F, 0), QVector3D(0, 1, 0));
    return std::max({0.3F - at.x(), at.x() - 0.7F, 0.3F - at.z(), at.z() - 0.7F});
}

float missesBall(const QVector3D& point) {
    return kBall.distanceToLine(point, (kLamp - point).normalized()) - 0.92F * 0.2F;
}

} // namespace

void LightingTest::shadowsFallWhereTheyShould_data() {
    QTest::addColumn<bool>("ball");
    QTest::addColumn<bool>("shadows");
    QTest::addColumn<int>("resolution");
    for (const bool ball : {false, true})
        for (const bool shadows : {true, false})
            for (const int resolution : {0, 40})
                QTest::addRow("%s, %s, %d", ball ? "ball" : "sheet", shadows ? "shadows" : "none", resolution)
                    << ball << shadows << resolution;
}

void LightingTest::shadowsFallWhereTheyShould() {
    QFETCH(bool, ball);
    QFETCH(bool, shadows);
    QFETCH(int, resolution);
    RenderFrame frame = emptyFrame();
    frame.surface.shader = QStringLiteral("Diffuse");
    frame.surface.meshResolution = resolution;
    frame.light = {kLamp, QVector3D(9, 9, 9), shadows};
    frame.cameraPosition = QVector3D(2.2F, 1.6F, 1.8F);
    frame.viewProjection = viewFrom(frame.cameraPosition, QVector3D(0.5F, 0.1F, 0.3F));
    frame.planes = {{QVector3D(), QVector3D(0, 1, 0)}};
    const RenderFrame bare = frame;
    if (ball)
        frame.spheres = {{kBall, 0.2F}};
    else
        frame.sheet =
            sheetOf(9, 9, [](float u, float v) { return QVector3D(0.3F + 0.4F * u, 0.5F, 0.3F + 0.4F * v); });
    const QImage unshaded = m_studio->draw(bare);
    const QImage image = m_studio->draw(frame);
    int dark = 0;
    for (int y = 0; y < kSize.height(); y += 3) {
        for (int x = 0; x < kSize.width(); x += 3) {
            const QPoint pixel(x, y);
            const QVector3D point = toPlane(frame, pixel, 0);
            const Ray sight = rayThrough(frame, pixel);
            const QVector3D onSheet = sight.meets(QVector3D(0, 0.5F, 0), QVector3D(0, 1, 0));
            const bool hidden =
                ball ? kBall.distanceToLine(sight.from, sight.along) < 0.2F
                     : std::abs(onSheet.x() - 0.5F) < 0.21F && std::abs(onSheet.z() - 0.5F) < 0.21F;
            const float misses = ball ? missesBall(point) : missesSheet(point);
            // Shadows are smooth over a few texels, and what is hidden is not plane.
            if (hidden || std::abs(misses) < 0.012F || std::abs(point.x()) > 1.9F ||
                std::abs(point.z()) > 1.9F)
                continue;
            const bool inShadow = shadows && misses < 0;
            dark += inShadow ? 1 : 0;
            const QRgb expected = inShadow ? qRgb(0, 0, 0) : unshaded.pixel(pixel);
            QVERIFY2(isNear(image.pixel(pixel), expected, 2), seen(image, pixel, expected));
        }
    }
    QVERIFY(shadows ? dark > 40 : dark == 0);
    QVERIFY(qRed(unshaded.pixel(toPixel(frame, QVector3D(0.5F, 0, 0.3F)))) > 100);
}

int main(int argc, char** argv) {
    return runOnDisplay<LightingTest>(argc, argv);
}
#include "tst_lighting.moc"
