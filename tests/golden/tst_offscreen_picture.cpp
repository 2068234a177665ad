// Pictures without a window.
#include "app/render/offscreen_picture.h"
#include "tests/golden/canvas.h"

using namespace clothlab::render;

class OffscreenPictureTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }

    void isWhatTheViewportDraws();
    void sizesThatCannotBe_data();
    void sizesThatCannotBe();
    void problemsComeAlong();
};

void OffscreenPictureTest::isWhatTheViewportDraws() {
    RenderFrame frame = flatFrame(8);
    frame.light.shadows = true;
    frame.spheres = {{QVector3D(0.5F, 0.6F, 0.5F), 0.2F}};
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        Problems problems;
        QString reason;
        const std::optional<QImage> image =
            renderPicture(frame, kSize, {kShaders, kTextures}, problems, reason);
        QVERIFY2(image, qPrintable(reason));
        QVERIFY(problems.isEmpty() && reason.isEmpty());
        Studio studio;
        QCOMPARE(image->convertToFormat(QImage::Format_ARGB32), studio.draw(frame));
    }
}

void OffscreenPictureTest::sizesThatCannotBe_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("none") << QSize(0, 0);
    QTest::newRow("flat") << QSize(100, 0);
    QTest::newRow("negative") << QSize(-5, 100);
    QTest::newRow("too wide") << QSize(kGreatestPicture + 1, 10);
    QTest::newRow("too high") << QSize(10, 1'000'000'000);
}

void OffscreenPictureTest::sizesThatCannotBe() {
    QFETCH(QSize, size);
    Problems problems;
    QString reason;
    QVERIFY(!renderPicture(flatFrame(4), size, {kShaders, kTextures}, problems, reason));
    QVERIFY2(reason.contains(QStringLiteral("pixels")), qPrintable(reason));
}

void OffscreenPictureTest::problemsComeAlong() {
    Problems problems;
    QString reason;
    RenderFrame frame = flatFrame(4);
    frame.surface.shader = QStringLiteral("Texture");
    QVERIFY(renderPicture(frame, QSize(40, 30), {kShaders, QStringLiteral("/nowhere")}, problems, reason));
    QCOMPARE(problems.size(), 1);
    QCOMPARE(problems[0].path, QStringLiteral("/nowhere/texture_1.png"));
    problems.clear();
    frame.surface.shader = QStringLiteral("Nobody");
    QVERIFY(renderPicture(frame, QSize(40, 30), {kShaders, kTextures}, problems, reason));
    QCOMPARE(problems.size(), 1);
    QVERIFY(problems[0].path.endsWith(QStringLiteral("Nobody.frag")));
}

int main(int argc, char** argv) {
    return runOnDisplay<OffscreenPictureTest>(argc, argv);
}
#include "tst_offscreen_picture.moc"
