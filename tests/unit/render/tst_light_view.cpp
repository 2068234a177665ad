// What the main light sees of what casts shadows.
#include "app/render/shadow_map.h"

#include <QTest>
#include <QVector4D>

#include <cmath>
#include <limits>

using namespace clothlab::render;

namespace {

Bounds boxOf(const QVector3D& lower, const QVector3D& upper) {
    Bounds bounds;
    bounds.add(lower);
    bounds.add(upper);
    return bounds;
}

std::array<QVector3D, 8> cornersOf(const Bounds& b) {
    std::array<QVector3D, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {i & 1 ? b.upper.x() : b.lower.x(), i & 2 ? b.upper.y() : b.lower.y(),
                      i & 4 ? b.upper.z() : b.lower.z()};
    return corners;
}

bool isFinite(const QMatrix4x4& matrix) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(matrix.constData()[i]))
            return false;
    return true;
}

} // namespace

class LightViewTest : public QObject {
    Q_OBJECT

private slots:
    void boundsHoldWhatWasAdded();
    void theWholeBoxIsSeen_data();
    void theWholeBoxIsSeen();
    void nothingIsWasted();
    void whatIsFartherHasMoreDepth();
    void fromWithin();
    void withoutASize_data();
    void withoutASize();
};

void LightViewTest::boundsHoldWhatWasAdded() {
    Bounds bounds;
    QVERIFY(bounds.isEmpty());
    bounds.add({1, -2, 3});
    QVERIFY(!bounds.isEmpty());
    QCOMPARE(bounds.radius(), 0.0F);
    bounds.add({-1, 2, 3});
    bounds.add({0, 0, 0});
    QCOMPARE(bounds.lower, QVector3D(-1, -2, 0));
    QCOMPARE(bounds.upper, QVector3D(1, 2, 3));
    QCOMPARE(bounds.centre(), QVector3D(0, 0, 1.5F));
}

void LightViewTest::theWholeBoxIsSeen_data() {
    QTest::addColumn<QVector3D>("light");
    QTest::addColumn<QVector3D>("upper");
    const QVector3D cube(1, 1, 1);
    QTest::newRow("the course's") << QVector3D(0.5F, 2, 2) << cube;
    QTest::newRow("above") << QVector3D(0.5F, 5, 0.5F) << cube;
    QTest::newRow("below") << QVector3D(0.5F, -5, 0.5F) << cube;
    QTest::newRow("aside") << QVector3D(-4, 0.5F, 0.5F) << cube;
    QTest::newRow("far away") << QVector3D(300, 400, 500) << cube;
    QTest::newRow("close by") << QVector3D(0.5F, 1.6F, 0.5F) << cube;
    QTest::newRow("flat box") << QVector3D(0.5F, 2, 2) << QVector3D(1, 0, 1);
    QTest::newRow("a line") << QVector3D(0.5F, 2, 2) << QVector3D(1, 0, 0);
    QTest::newRow("a hall") << QVector3D(50, 90, 120) << QVector3D(100, 20, 100);
    QTest::newRow("a crumb") << QVector3D(0.002F, 0.004F, 0.001F) << QVector3D(1e-3F, 1e-3F, 1e-3F);
}

void LightViewTest::theWholeBoxIsSeen() {
    QFETCH(QVector3D, light);
    QFETCH(QVector3D, upper);
    const Bounds bounds = boxOf(QVector3D(), upper);
    const QMatrix4x4 view = lightViewProjection(light, bounds);
    QVERIFY(!view.isIdentity());
    for (const QVector3D& corner : cornersOf(bounds)) {
        const QVector4D clip = view * QVector4D(corner, 1);
        QVERIFY(clip.w() > 0);
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY2(std::abs(clip[axis]) <= clip.w() * 1.0001F,
                     qPrintable(QStringLiteral("axis %1: %2").arg(axis).arg(clip[axis] / clip.w())));
    }
}

// A corner, at least, comes near the edge of what is seen: texels are not spent on nothing.
void LightViewTest::nothingIsWasted() {
    const Bounds bounds = boxOf({0, 0, 0}, {1, 1, 1});
    const QMatrix4x4 view = lightViewProjection({2, 3, 4}, bounds);
    float most = 0;
    for (const QVector3D& corner : cornersOf(bounds)) {
        const QVector3D seen = view.map(corner);
        most = std::max({most, std::abs(seen.x()), std::abs(seen.y())});
    }
    QVERIFY(most > 0.6F);
}

void LightViewTest::whatIsFartherHasMoreDepth() {
    const QVector3D light(0.5F, 2, 2);
    const Bounds bounds = boxOf({0, 0, 0}, {1, 1, 1});
    const QMatrix4x4 view = lightViewProjection(light, bounds);
    const QVector3D along = bounds.centre() - light;
    float last = -2;
    for (int i = 0; i <= 10; ++i) {
        const QVector3D seen = view.map(light + (0.7F + 0.06F * float(i)) * along);
        QVERIFY(seen.z() > last);
        QVERIFY(std::abs(seen.x()) < 1e-4F && std::abs(seen.y()) < 1e-4F); // the middle stays the middle
        last = seen.z();
    }
}

void LightViewTest::fromWithin() {
    const Bounds bounds = boxOf({0, 0, 0}, {1, 1, 1});
    for (const QVector3D light : {QVector3D(0.5F, 0.9F, 0.5F), QVector3D(0.5F, 0.6F, 0.4F),
                                  QVector3D(0.9F, 0.9F, 0.9F), QVector3D(0.5F, 0.501F, 0.5F)}) {
        const QMatrix4x4 view = lightViewProjection(light, bounds);
        QVERIFY(isFinite(view));
        QVERIFY(!view.isIdentity());
        // What it looks at is in front of it, and of use.
        const QVector4D centre = view * QVector4D(2 * bounds.centre() - light, 1);
        QVERIFY(centre.w() > 0);
    }
}

void LightViewTest::withoutASize_data() {
    QTest::addColumn<QVector3D>("light");
    QTest::addColumn<QVector3D>("lower");
    QTest::addColumn<QVector3D>("upper");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    QTest::newRow("a point") << QVector3D(0, 1, 0) << QVector3D(1, 1, 1) << QVector3D(1, 1, 1);
    QTest::newRow("in the centre") << QVector3D(0.5F, 0.5F, 0.5F) << QVector3D() << QVector3D(1, 1, 1);
    QTest::newRow("no number") << QVector3D(0, nan, 0) << QVector3D() << QVector3D(1, 1, 1);
    QTest::newRow("no number in the box") << QVector3D(0, 1, 0) << QVector3D(nan, 0, 0) << QVector3D(1, 1, 1);
    QTest::newRow("infinite box") << QVector3D(0, 1, 0) << QVector3D() << QVector3D(1, infinity, 1);
    QTest::newRow("infinitely far") << QVector3D(infinity, 1, 0) << QVector3D() << QVector3D(1, 1, 1);
}

void LightViewTest::withoutASize() {
    QFETCH(QVector3D, light);
    QFETCH(QVector3D, lower);
    QFETCH(QVector3D, upper);
    QVERIFY(lightViewProjection(light, Bounds{lower, upper}).isIdentity());
    QVERIFY(lightViewProjection(light, Bounds{}).isIdentity());
}

QTEST_APPLESS_MAIN(LightViewTest)
#include "tst_light_view.moc"
