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

int main(int argc, char** argv) {
    return runOnDisplay<LightingTest>(argc, argv);
}
#include "tst_lighting.moc"
