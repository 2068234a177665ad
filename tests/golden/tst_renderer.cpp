// What the renderer draws, and that odd input does not stop it.
#include "tests/golden/canvas.h"

#include <limits>
#include <optional>

using namespace clothlab::render;

class RendererTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init() { QVERIFY(m_studio.emplace().isGood()); }
    void cleanup() { m_studio.reset(); }

    void saysWhyThereIsNothingToDrawWith();
    void backgroundIsOpaqueAndExact();
    void sphereIsDrawnSmaller();
    void planeIsDrawnFromBothSides();
    void oddSheets_data();
    void oddSheets();
    void largeSheet();
    void resampledSheetIsNeverAnOldOne();
    void theFirstFrameMayBeWithoutShadows();
    void multisampledEdgesAreSmooth();
    void samplesAreOfTheFrame();

private:
    std::optional<Studio> m_studio;
};

void RendererTest::saysWhyThereIsNothingToDrawWith() {
    m_studio->renderer.release();
    m_studio->loseContext();
    QString error;
    QVERIFY(!m_studio->renderer.initialize(&error));
    QVERIFY2(error.contains(QStringLiteral("context")), qPrintable(error));
    QVERIFY(!m_studio->renderer.initialize(nullptr));
    QVERIFY(!m_studio->renderer.isInitialized());
    m_studio->renderer.render(flatFrame(4), kSize);
    m_studio->renderer.release();
}

void RendererTest::backgroundIsOpaqueAndExact() {
    RenderFrame frame = flatFrame(4);
    frame.sheet = SheetShape();
    const QImage image = m_studio->draw(frame);
    QCOMPARE(countPixels(image, frame.background, 0), kSize.width() * kSize.height());
    QCOMPARE(qAlpha(image.pixel(0, 0)), 255);
    m_studio->renderer.render(frame, QSize(0, 10));
}

void RendererTest::sphereIsDrawnSmaller() {
    ShaderDirectory directory;
    QVERIFY(directory.write(QStringLiteral("Show.frag"),
                            "#version 330\nin vec4 v_normal; in vec2 v_uv; out vec4 out_color;\n"
                            "void main() { out_color = vec4(0.5 + 0.5 * v_normal.xy, v_uv.y, 1); }\n"));
    m_studio->renderer.setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(4);
    frame.sheet = SheetShape();
    frame.surface.shader = QStringLiteral("Show");
    frame.viewProjection = QMatrix4x4();
    frame.viewProjection.ortho(-1.6F, 1.6F, -1.2F, 1.2F, -5, 5); // 100 pixels a metre, looking along -z
    frame.spheres = {{QVector3D(0, 0, 0), 1.0F}, {QVector3D(1, 1, 0), 0.0F}};
    const QImage image = m_studio->draw(frame);
    const int covered = kSize.width() * kSize.height() - countPixels(image, frame.background, 0);
    QVERIFY(std::abs(covered - 3.14159 * 92 * 92) < 0.005 * covered);
    QVERIFY(isNear(image.pixel(160, 120), qRgb(128, 128, 128), 2));      // the equator
    QVERIFY(isNear(image.pixel(160 + 65, 120), qRgb(218, 128, 128), 4)); // 45 degrees to the right
    QVERIFY(isNear(image.pixel(160, 120 - 65), qRgb(128, 218, 64), 4));  // 45 degrees to the north pole
}

void RendererTest::planeIsDrawnFromBothSides() {
    RenderFrame frame = flatFrame(4);
    frame.sheet = SheetShape();
    for (const QVector3D normal : {QVector3D(0, 1, 0), QVector3D(0, -1, 0)}) {
        frame.planes = {{QVector3D(0.5F, 0, 0.5F), normal}};
        const QImage image = m_studio->draw(frame);
        const QRgb middle = image.pixel(kSize.width() / 2, kSize.height() / 2);
        QVERIFY(qRed(middle) > qRed(frame.background.rgb()) + 20); // lit
        QVERIFY(qRed(middle) < 160);                               // and calmer than the sheet
    }
    frame.planes = {{QVector3D(), QVector3D()}};
    QCOMPARE(countPixels(m_studio->draw(frame), frame.background, 0), kSize.width() * kSize.height());
}

void RendererTest::oddSheets_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("floats");
    QTest::newRow("empty") << 0 << 0 << 0;
    QTest::newRow("no positions yet") << 10 << 10 << 0;
    QTest::newRow("too few positions") << 10 << 10 << 299;
    QTest::newRow("one point") << 1 << 1 << 3;
    QTest::newRow("one row") << 5 << 1 << 15;
    QTest::newRow("one column") << 1 << 5 << 15;
    QTest::newRow("two by two") << 2 << 2 << 12;
    QTest::newRow("negative") << -2 << -2 << 12;
}

void RendererTest::oddSheets() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(int, floats);
    RenderFrame frame = flatFrame(8);
    for (const char* shader : {"Phong", "Wireframe"}) {
        for (const float value : {0.5F, std::numeric_limits<float>::quiet_NaN(), 1e38F}) {
            frame.surface.shader = QLatin1String(shader);
            frame.springs.overSurface = true;
            frame.sheet.width = width;
            frame.sheet.height = height;
            frame.sheet.positions.assign(static_cast<std::size_t>(floats), value);
            frame.sheet.pinned = {0, 1, 100};
            QVERIFY(!m_studio->draw(frame).isNull());
        }
    }
    const RenderFrame usual = flatFrame(8); // and nothing of it is left
    const QPoint middle = toPixel(usual, QVector3D(0.44F, 0.5F, 0.36F));
    QVERIFY(qRed(m_studio->draw(usual).pixel(middle)) > 100);
}

void RendererTest::largeSheet() {
    RenderFrame frame = flatFrame(512);
    frame.springs.overSurface = true;
    const QImage image = m_studio->draw(frame);
    QVERIFY(!image.isNull());
    // Springs closer than pixels tint the sheet, and leave it visible.
    const QRgb middle = image.pixel(toPixel(frame, QVector3D(0.5F, 0.5F, 0.5F)));
    QVERIFY(qRed(middle) > 80);
}

// The drawn mesh follows the sheet, also if that moved while springs were drawn, and loses its strains with
// it.
void RendererTest::resampledSheetIsNeverAnOldOne() {
    const auto fresh = [](const RenderFrame& frame) {
        Studio studio;
        return studio.draw(frame);
    };
    RenderFrame frame = flatFrame(5);
    frame.surface.meshResolution = 9;
    frame.surface.shader = QStringLiteral("Wireframe");
    m_studio->draw(frame);
    frame.surface.shader = QStringLiteral("Normal");
    QCOMPARE(m_studio->draw(frame), fresh(frame));

    frame.surface.shader = QStringLiteral("Wireframe");
    frame.sheet.positions[1] += 0.3F;
    m_studio->draw(frame);
    frame.surface.shader = QStringLiteral("Normal");
    QCOMPARE(m_studio->draw(frame), fresh(frame));

    frame.surface.shader = QStringLiteral("Strain");
    frame.sheet.strains.assign(25, 0.1F);
    QCOMPARE(m_studio->draw(frame), fresh(frame));
    frame.sheet.strains.clear();
    QCOMPARE(m_studio->draw(frame), fresh(frame));
}

// Making the shadow map in the midst of a picture leaves the picture where it is.
void RendererTest::theFirstFrameMayBeWithoutShadows() {
    RenderFrame frame = flatFrame(4);
    frame.surface.shader = QStringLiteral("Diffuse");
    const QImage first = m_studio->draw(frame);
    QCOMPARE(m_studio->draw(frame), first);
}

void RendererTest::multisampledEdgesAreSmooth() {
    Canvas smooth(4);
    QVERIFY(smooth.isGood());
    Renderer renderer;
    QVERIFY(renderer.initialize(nullptr));
    renderer.setShaderDirectory(kShaders);
    RenderFrame frame = flatFrame(4);
    frame.surface.shader = QStringLiteral("Normal");
    const QImage image = smooth.draw(renderer, frame);
    const int all = kSize.width() * kSize.height();
    const int between =
        all - countPixels(image, frame.background, 1) - countPixels(image, QColor(128, 255, 128), 2);
    QVERIFY(between > 20);
    renderer.release();
}

// With a framebuffer that has one sample a pixel, the frame says how many there are.
void RendererTest::samplesAreOfTheFrame() {
    RenderFrame frame = flatFrame(4);
    frame.surface.shader = QStringLiteral("Normal");
    const auto between = [&](int samples) {
        frame.samples = samples;
        const QImage image = m_studio->draw(frame);
        return kSize.width() * kSize.height() - countPixels(image, frame.background, 1) -
               countPixels(image, QColor(128, 255, 128), 2);
    };
    QCOMPARE(between(1), 0);
    QVERIFY(between(4) > 20);
    QCOMPARE(between(1), 0);
    QVERIFY(between(1000) > 20); // as many as there are
    QCOMPARE(between(0), 0);
    QCOMPARE(between(-3), 0);
    // Another size needs another target.
    frame.samples = 4;
    for (const QSize size : {QSize(64, 48), QSize(200, 100)}) {
        const QImage image = m_studio->draw(frame, size);
        QCOMPARE(image.size(), size);
        QVERIFY(isNear(image.pixel(size.width() / 2, size.height() / 2), qRgb(128, 255, 128), 2));
    }
}

int main(int argc, char** argv) {
    return runOnDisplay<RendererTest>(argc, argv);
}
#include "tst_renderer.moc"
