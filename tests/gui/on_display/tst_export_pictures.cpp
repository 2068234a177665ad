// Pictures and video from the window, on a real display: what they show, and that the window goes on.
#include "tests/gui/on_display/display.h"
#include "tests/support/video.h"

#include "app/render/offscreen_picture.h"
#include "app/window/export_controller.h"
#include "app/window/export_dialog.h"
#include "app/window/export_progress.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardItemModel>

using namespace clothlab;

class TestExportPictures : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { CLOTHLAB_NEEDS_PICTURE(); }
    void init();
    void cleanup() { m_window.reset(); }

    void picturesShowEachFrameAsTheViewDoes();
    void theLookIsThatOfTheBeginning();
    void anMp4IsMadeAndTheWindowGoesOn();
    void cancelledVideoLeavesNothing();
    void withoutFfmpegVideoCannotBeChosen();

private:
    ExportDialog& dialog() { return (*m_window)->exports().dialog(); }
    void setUp(ExportKind kind, const QString& name, QSize size) {
        m_window->key(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(QTest::qWaitForWindowActive(&dialog(), kPatience));
        dialog().kindField()->setFocus();
        while (dialog().kindField()->currentIndex() < int(kind))
            m_window->key(Qt::Key_Down);
        m_window->typeInto(dialog().widthField(), QString::number(size.width()));
        m_window->typeInto(dialog().heightField(), QString::number(size.height()));
        m_window->click(dialog().pathField());
        dialog().pathField()->selectAll();
        m_window->type(m_window->path("out/" + name));
    }
    bool running() { return (*m_window)->exports().isRunning(); }
    QStringList files() const {
        return QDir(m_window->path("out"))
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }
    // What the view shows now, drawn on this thread.
    QImage view(QSize size) {
        render::Problems problems;
        QString reason;
        return render::renderPicture(
                   m_window->viewport().frameFor(size), size,
                   {CLOTHLAB_SOURCE_DIR "/shaders", CLOTHLAB_SOURCE_DIR "/resources/textures"}, problems,
                   reason)
            .value_or(QImage());
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestExportPictures::init() {
    m_window = std::make_unique<TestWindow>();
    QVERIFY(m_window->load(smallScene()));
    QVERIFY(QDir(m_window->path(".")).mkdir("out"));
    QVERIFY(m_window->simulateTo(30));
}

void TestExportPictures::picturesShowEachFrameAsTheViewDoes() {
    constexpr QSize size(320, 180);
    m_window->key(Qt::Key_3); // from the right
    m_window->document().setSelection({});
    setUp(ExportKind::PngFiles, "a %d.png", size);
    m_window->typeInto(dialog().everyField(), "10");
    m_window->click(dialog().exportButton());
    TRY_VERIFY(!running());
    QCOMPARE(files(), QStringList({"a %d_0000.png", "a %d_0001.png", "a %d_0002.png", "a %d_0003.png"}));
    QVERIFY2(dialog().resultText().endsWith("out/a %d_0000.png … a %d_0003.png"),
             qPrintable(dialog().resultText()));
    for (int i = 0; i < 4; ++i) {
        m_window->simulation().showFrame(10 * i);
        const QImage image(m_window->path(QStringLiteral("out/a %d_000%1.png").arg(i)));
        QCOMPARE(image.size(), size);
        QCOMPARE(image.convertToFormat(QImage::Format_RGB32), view(size));
    }
    QVERIFY(QImage(m_window->path("out/a %d_0000.png")) != QImage(m_window->path("out/a %d_0003.png")));
}

void TestExportPictures::theLookIsThatOfTheBeginning() {
    constexpr QSize size(160, 90);
    m_window->simulation().showFrame(30);
    const QImage before = view(size);
    setUp(ExportKind::PngFiles, "a.png", size);
    m_window->click(dialog().exportButton());
    QVERIFY(running());
    m_window->viewport().look(ViewDirection::Top);
    setShader(m_window->document(), "Wireframe");
    TRY_VERIFY(!running());
    QVERIFY(view(size) != before);
    QCOMPARE(QImage(m_window->path("out/a_0030.png")).convertToFormat(QImage::Format_RGB32), before);
}

void TestExportPictures::anMp4IsMadeAndTheWindowGoesOn() {
    CLOTHLAB_NEEDS_FFMPEG();
    setUp(ExportKind::Mp4, "a.mp4", {321, 180});
    m_window->click(dialog().exportButton());
    QVERIFY(running());
    (*m_window)->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&**m_window, kPatience));
    m_window->simulation().showFrame(30);
    m_window->key(Qt::Key_Left);
    QCOMPARE(m_window->frame(), 29);
    TRY_VERIFY(!running());
    QVERIFY2(dialog().resultText().contains("11 frames"), qPrintable(dialog().resultText()));
    QCOMPARE(files(), QStringList{"a.mp4"});
    const test::Video video = test::probe(m_window->path("out/a.mp4"));
    QCOMPARE(video.size, QSize(320, 180));
    QCOMPARE(video.frames, 11); // every third of 31
    QCOMPARE(video.framesPerSecond, 30.0);
    QCOMPARE(video.pixelFormat, "yuv420p");
}

void TestExportPictures::cancelledVideoLeavesNothing() {
    CLOTHLAB_NEEDS_FFMPEG();
    setUp(ExportKind::WebM, "a.webm", {1920, 1080});
    m_window->click(dialog().exportButton());
    QVERIFY(running());
    TRY_VERIFY(!files().isEmpty()); // the file under another name
    QApplication::processEvents();
    m_window->click(dialog().progress()->cancelButton());
    TRY_VERIFY(!running());
    QVERIFY2(dialog().resultText().contains("cancelled"), qPrintable(dialog().resultText()));
    QCOMPARE(files(), QStringList());
}

void TestExportPictures::withoutFfmpegVideoCannotBeChosen() {
    const test::FakeFfmpeg none(m_window->path("bin"), {});
    m_window->key(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    const auto* model = qobject_cast<QStandardItemModel*>(dialog().kindField()->model());
    for (const ExportKind kind : {ExportKind::Mp4, ExportKind::WebM}) {
        QVERIFY(!model->item(int(kind))->isEnabled());
        QVERIFY2(model->item(int(kind))->toolTip().contains("sudo apt install ffmpeg"),
                 qPrintable(model->item(int(kind))->toolTip()));
    }
    QVERIFY(model->item(int(ExportKind::PngFiles))->isEnabled());
}

CLOTHLAB_DISPLAY_TEST_MAIN(TestExportPictures)
#include "tst_export_pictures.moc"
