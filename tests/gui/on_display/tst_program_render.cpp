// clothlab render on a real display: the picture is that of scene, frame, shader and size.
#include "app/picture/camera.h"
#include "simcore/scene/scene_io.h"
#include "tests/support/program.h"

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

using namespace clothlab;

class TestProgramRender : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const bool required = qEnvironmentVariable("CLOTHLAB_REQUIRE_GL") == "1";
        const bool there = !qEnvironmentVariable("DISPLAY").isEmpty();
        QVERIFY2(there || !required, "CLOTHLAB_REQUIRE_GL is 1, and there is no display");
        if (!there)
            QSKIP("There is no display.");
    }

    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_scene.cloth.numWidthPoints = m_scene.cloth.numHeightPoints = 8;
        m_scene.cloth.pinned = {{0, 0}, {7, 0}};
        m_scene.cloth.thickness = 0;
        m_scene.simulation.stepsPerFrame = 4;
        m_scene.camera = homeView(m_scene.cloth);
        m_scene.camera->elevation = 90; // from above, with the sheet in the middle
        QVERIFY(!saveScene(m_scene, in("scene.json").toStdString()));
    }

    void thePictureHasItsSize() {
        QCOMPARE(picture({"--size", "320x200", "--frame", "2"}).size(), QSize(320, 200));
        const QImage usual = picture({"--frame", "2"});
        QCOMPARE(usual.size(), QSize(1280, 800));
        QVERIFY(usual.pixel(640, 400) != usual.pixel(2, 2)); // the sheet, and what is behind it
    }

    void itShowsTheFrameAndTheShader() {
        const QImage start = picture({"--size", "200x200", "--frame", "0"});
        const QImage later = picture({"--size", "200x200", "--frame", "60"});
        QVERIFY(later != start);
        QCOMPARE(picture({"--size", "200x200", "--frame", "60", "--threads", "2"}), later);
        const QImage normals = picture({"--size", "200x200", "--frame", "60", "--shader", "Normal"});
        QVERIFY(normals != later);
        QCOMPARE(picture({"--size", "200x200", "--frame", "60", "--shader", "Phong"}), later); // the scene's
    }

    void allShadersAreOnOneSheet() {
        const auto shaders = int(QDir(CLOTHLAB_SOURCE_DIR "/shaders").entryList({"*.frag"}).size());
        const QImage sheet = picture({"--size", "160x100", "--frame", "3", "--shader", "all"});
        constexpr int gap = 8;
        constexpr int caption = 16;
        QCOMPARE(sheet.size(), QSize(4 * (160 + gap) + gap, (shaders + 3) / 4 * (100 + caption + gap) + gap));
        // Each shader by itself is there, in the order of their names after Wireframe.
        const QImage first = picture({"--size", "160x100", "--frame", "3", "--shader", "Wireframe"});
        QCOMPARE(sheet.copy(gap, gap, 160, 100), first.convertToFormat(sheet.format()));
    }

    void texturesAreFoundBesideTheScene() {
        QImage red(8, 8, QImage::Format_RGB32);
        red.fill(Qt::red);
        QVERIFY(red.save(in("red.png")));
        m_scene.appearance.shader = "Texture";
        const auto redPart = [&] {
            const QImage image = picture({"--size", "200x200", "--frame", "0"});
            int count = 0;
            for (int y = 0; y < 200; ++y)
                for (int x = 0; x < 200; ++x) {
                    const QRgb rgb = image.pixel(x, y);
                    count += qRed(rgb) > 60 && qGreen(rgb) < 20 && qBlue(rgb) < 20;
                }
            return count;
        };
        m_scene.appearance.textures[0] = "red.png";
        QVERIFY(!saveScene(m_scene, in("scene.json").toStdString()));
        const int with = redPart();
        QVERIFY2(with > 2000, qPrintable(QString::number(with)));
        m_scene.appearance.textures[0] = "";
        QVERIFY(!saveScene(m_scene, in("scene.json").toStdString()));
        QVERIFY(redPart() < with / 10);
    }

    void aShaderOfOnesOwnIsDrawnAndItsErrorsAreTold() {
        QVERIFY(QDir(m_folder->path()).mkdir("mine"));
        write("mine/Green.frag", "#version 330\nout vec4 out_color;\nvoid main() {\n"
                                 "    out_color = vec4(0, 1, 0, 1);\n}\n");
        const QStringList arguments{"--size",   "200x200", "--frame",      "0",
                                    "--shader", "Green",   "--shader-dir", in("mine")};
        QCOMPARE(QColor(picture(arguments).pixel(100, 100)), QColor(0, 255, 0));
        write("mine/Green.frag", "#version 330\nout vec4 out_color;\nthis is no GLSL\n");
        const auto run = render(arguments);
        QVERIFY2(run.err.contains("clothlab: Green.frag:3: "), qPrintable(run.err));
    }

    void aSizeTooLargeIsRefused() {
        const auto run = render({"--size", "20000x20000", "--frame", "0"});
        QVERIFY2(run.status == 2, qPrintable(run.err));
        QVERIFY2(run.err.contains("8192"), qPrintable(run.err));
        QVERIFY(!QFile::exists(in("a.png")));
    }

    void aPictureThatCannotBeWritten() {
        m_output = "none/a.png";
        const auto run = render({"--size", "100x100", "--frame", "0"});
        m_output = "a.png";
        QVERIFY2(run.status == 6, qPrintable(run.err));
        QVERIFY2(run.err.contains("none/a.png"), qPrintable(run.err));
    }

private:
    QString in(const QString& name) const { return m_folder->filePath(name); }
    void write(const QString& name, const QByteArray& text) const {
        QFile file(in(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }
    test::ProgramResult render(const QStringList& arguments) const {
        QFile::remove(in("a.png"));
        return test::runProgram(QStringList{"render", in("scene.json"), "--output", in(m_output)} + arguments,
                                {"DISPLAY=" + qEnvironmentVariable("DISPLAY")});
    }
    QImage picture(const QStringList& arguments) const {
        const auto run = render(arguments);
        if (run.status != 0)
            qWarning("status %d: %s", run.status, qPrintable(run.err));
        return QImage(in("a.png"));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    Scene m_scene;
    QString m_output = "a.png";
};

QTEST_GUILESS_MAIN(TestProgramRender)
#include "tst_program_render.moc"
