// Every shader of the program on a sheet and on a sphere, against the pictures in tests/golden/pictures.
// After a change that is meant, CLOTHLAB_WRITE_GOLDEN=1 writes them anew: look at what git shows of it.
#include "app/render/shader_library.h"
#include "tests/golden/canvas.h"
#include "tests/golden/golden_picture.h"

#include <optional>

using namespace clothlab::render;

namespace {

constexpr QSize kPictureSize(160, 120);

// A cloth that is drawn in folds over an edge, with some stretch in it.
SheetShape wavySheet() {
    SheetShape sheet = sheetOf(24, 24, [](float u, float v) {
        const float fold = 0.07F * std::sin(11 * u + 2 * v) * v;
        const float drop = v * v;
        return QVector3D(u, 0.85F - 0.55F * drop + fold, v - 0.25F * drop + 0.3F * fold);
    });
    for (std::size_t i = 0; i < 24 * 24; ++i)
        sheet.strains.push_back(0.12F * std::sin(0.02F * float(i)));
    return sheet;
}

RenderFrame goldenFrame(const QString& shader) {
    RenderFrame frame = emptyFrame();
    frame.surface.shader = shader;
    frame.light.shadows = true;
    frame.surface.backColor = QVector4D(0.9F, 0.7F, 0.4F, 1);
    frame.cameraPosition = QVector3D(1.7F, 1.5F, 2.1F);
    frame.viewProjection = viewFrom(frame.cameraPosition, QVector3D(0.5F, 0.55F, 0.4F));
    return frame;
}

} // namespace

class GoldenTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init() { QVERIFY(m_studio.emplace().isGood()); }
    void cleanup() { m_studio.reset(); }

    void pictures_data();
    void pictures();
    void noPictureTooMany();
    void aFewWrongPixelsPass();
    void manyWrongPixelsFail();
    void anotherSizeFails();
    void aMissingPictureFails();
    void picturesCanBeWrittenAnew();

private:
    std::optional<Studio> m_studio;
};

void GoldenTest::pictures_data() {
    QTest::addColumn<QString>("shader");
    QTest::addColumn<bool>("sphere");
    for (const QString& shader : listShaders(kShaders)) {
        QTest::addRow("%s_sheet", qPrintable(shader)) << shader << false;
        QTest::addRow("%s_sphere", qPrintable(shader)) << shader << true;
    }
}

void GoldenTest::pictures() {
    QFETCH(QString, shader);
    QFETCH(bool, sphere);
    RenderFrame frame = goldenFrame(shader);
    frame.planes = {{QVector3D(), QVector3D(0, 1, 0)}};
    if (sphere)
        frame.spheres = {{QVector3D(0.5F, 0.6F, 0.4F), 0.5F}};
    else
        frame.sheet = wavySheet();
    const QImage picture = m_studio->draw(frame, kPictureSize);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    const GoldenFolders folders{QStringLiteral(CLOTHLAB_SOURCE_DIR "/tests/golden/pictures"),
                                QDir::tempPath() + QStringLiteral("/clothlab_golden"),
                                qEnvironmentVariable("CLOTHLAB_WRITE_GOLDEN") == QLatin1String("1")};
    const QString fault = compareWithGolden(picture, QString::fromLatin1(QTest::currentDataTag()), folders);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

// A shader that was renamed or removed leaves no picture behind.
void GoldenTest::noPictureTooMany() {
    const QStringList files =
        QDir(QStringLiteral(CLOTHLAB_SOURCE_DIR "/tests/golden/pictures")).entryList(QDir::Files);
    QCOMPARE(files.size(), 2 * listShaders(kShaders).size());
    for (const QString& file : files)
        QVERIFY2(listShaders(kShaders).contains(file.section(u'_', 0, 0)), qPrintable(file));
}

namespace {

// A golden picture in a folder of its own, and one that differs from it in `part` of its pixels by `step`.
struct Trial {
    QTemporaryDir directory;
    QImage golden{100, 80, QImage::Format_RGB32};
    QImage actual;
    GoldenFolders folders{directory.filePath(QStringLiteral("golden")),
                          directory.filePath(QStringLiteral("failed"))};

    Trial(double part, int step) {
        golden.fill(qRgb(100, 150, 200));
        actual = golden;
        for (int i = 0; i < int(std::lround(part * 8000)); ++i)
            actual.setPixel(i % 100, i / 100, qRgb(100, 150, 200 + step));
        QDir().mkpath(folders.golden);
        golden.save(folders.golden + QStringLiteral("/x.png"));
    }
    QString compare() { return compareWithGolden(actual, QStringLiteral("x"), folders); }
    bool failedHas(const char* file) const { return QFile::exists(folders.failed + QLatin1String(file)); }
};

} // namespace

void GoldenTest::aFewWrongPixelsPass() {
    QCOMPARE(Trial(0, 0).compare(), QString());
    QCOMPARE(Trial(0.004, 50).compare(), QString());
    QCOMPARE(Trial(1, kChannelTolerance).compare(), QString());
    QVERIFY(!Trial(1, kChannelTolerance + 1).compare().isEmpty());
    QVERIFY(!Trial(1, -kChannelTolerance - 1).compare().isEmpty());
}

void GoldenTest::manyWrongPixelsFail() {
    Trial trial(0.02, 50);
    const QString fault = trial.compare();
    QVERIFY2(fault.contains(QStringLiteral("160 of 8000")), qPrintable(fault));
    QVERIFY(fault.contains(trial.folders.failed));
    QVERIFY(trial.failedHas("/x_actual.png"));
    const QImage difference(trial.folders.failed + QStringLiteral("/x_difference.png"));
    QCOMPARE(countPixels(difference, QColor(255, 0, 0), 0), 160);
    QCOMPARE(
        QImage(trial.folders.failed + QStringLiteral("/x_actual.png")).convertToFormat(QImage::Format_RGB32),
        trial.actual);
}

void GoldenTest::anotherSizeFails() {
    Trial trial(0, 0);
    trial.actual = trial.golden.copy(0, 0, 100, 79);
    QVERIFY(trial.compare().contains(QStringLiteral("100 by 79")));
    trial.actual = QImage(); // nothing was drawn
    QVERIFY(!trial.compare().isEmpty());
}

void GoldenTest::aMissingPictureFails() {
    Trial trial(0, 0);
    QVERIFY(QFile::remove(trial.folders.golden + QStringLiteral("/x.png")));
    QVERIFY(trial.compare().contains(QStringLiteral("CLOTHLAB_WRITE_GOLDEN")));
    QVERIFY(trial.failedHas("/x_actual.png"));
}

void GoldenTest::picturesCanBeWrittenAnew() {
    Trial trial(0.5, 50);
    trial.folders.write = true;
    QCOMPARE(trial.compare(), QString());
    trial.folders.write = false;
    QCOMPARE(trial.compare(), QString());
    trial.actual = trial.golden;
    QVERIFY(!trial.compare().isEmpty());
}

int main(int argc, char** argv) {
    return runOnDisplay<GoldenTest>(argc, argv);
}
#include "tst_golden.moc"
