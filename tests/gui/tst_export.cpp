// Export from the window: the dialog, by keys and clicks, and the files that come of it.
#include "tests/gui/dialog_answer.h"
#include "tests/gui/test_window.h"
#include "tests/support/export_frames.h"

#include "app/window/export_controller.h"
#include "app/window/export_dialog.h"
#include "app/window/export_progress.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QStandardItemModel>

using namespace clothlab;

class TestExport : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void theKeyOpensADialogThatBlocksNothing();
    void whatItProposesFollowsTheRecording();
    void whatWasTypedStays();
    void theRowsAreThoseOfTheFormat();
    void itSaysWhatTheFilesWillHold();
    void whatCannotBeUsedSaysWhy();
    void aPointCacheOfARange();
    void inAndOutPointsAreWhatIsProposed();
    void aSequenceWithAxesAndUnits();
    void enterInTheNameExports();
    void itAsksOnceBeforeItReplacesFiles();
    void cancelLeavesNothingAndTheWindowGoesOn();
    void troubleIsTold();
    void aFrameThatIsLaterDroppedIsStillWritten();
    void closingTheWindowAsks();

private:
    ExportDialog& dialog() { return (*m_window)->exports().dialog(); }
    ExportDialog& openDialog() {
        m_window->key(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        if (!QTest::qWaitForWindowActive(&dialog(), kPatience))
            qFatal("the dialog does not become the active window");
        return dialog();
    }
    void choose(ExportKind kind) {
        dialog().kindField()->setFocus();
        while (dialog().kindField()->currentIndex() < int(kind))
            m_window->key(Qt::Key_Down);
        while (dialog().kindField()->currentIndex() > int(kind))
            m_window->key(Qt::Key_Up);
    }
    void typePath(const QString& path) {
        m_window->click(dialog().pathField());
        dialog().pathField()->selectAll();
        m_window->type(path);
    }
    bool running() { return (*m_window)->exports().isRunning(); }
    QStringList files() const {
        return QDir(m_window->path("out"))
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }
    // Frames that take long enough to write that a click comes in between.
    void recordALot() {
        Scene scene = smallScene();
        scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = 120;
        scene.cloth.pinned = {{0, 0}};
        QVERIFY(m_window->load(scene));
        QVERIFY(m_window->simulateTo(20));
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestExport::init() {
    m_window = std::make_unique<TestWindow>();
    QVERIFY(m_window->load(smallScene()));
    QVERIFY(QDir(m_window->path(".")).mkdir("out"));
    QVERIFY(m_window->simulateTo(9));
}

void TestExport::theKeyOpensADialogThatBlocksNothing() {
    ExportDialog& shown = openDialog();
    QVERIFY(shown.isVisible() && !shown.isModal());
    QVERIFY(!QApplication::activeModalWidget());
    m_window->simulation().showFrame(3);
    (*m_window)->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&**m_window, kPatience));
    m_window->key(Qt::Key_Right);
    QCOMPARE(m_window->frame(), 4);
    QVERIFY(shown.isVisible());
}

void TestExport::whatItProposesFollowsTheRecording() {
    ExportDialog& shown = openDialog();
    QCOMPARE(shown.request().path, m_window->path("scene.obj"));
    QCOMPARE(shown.request().frames.first, 0);
    QCOMPARE(shown.request().frames.last, 9);
    QVERIFY(m_window->simulateTo(14));
    QCOMPARE(shown.request().frames.last, 14);
    m_window->simulation().restart();
    QCOMPARE(shown.request().frames.last, 0);
    QVERIFY(shown.exportButton()->isEnabled());
}

void TestExport::whatWasTypedStays() {
    ExportDialog& shown = openDialog();
    m_window->typeInto(shown.lastField(), "5");
    m_window->key(Qt::Key_Return);
    typePath(m_window->path("out/mine.obj"));
    QVERIFY(m_window->simulateTo(12));
    QCOMPARE(shown.request().frames.last, 5);
    QVERIFY(m_window->load(smallScene()));
    QCOMPARE(shown.request().path, m_window->path("out/mine.obj"));
    QCOMPARE(shown.request().frames.last, 0); // there are no more
    choose(ExportKind::Glb);
    QCOMPARE(shown.request().path, m_window->path("out/mine.glb"));
    typePath("other"); // beside the scene, with the ending of the format
    QCOMPARE(shown.request().path, m_window->path("other.glb"));
    typePath("");
    m_window->key(Qt::Key_Backspace);
    QVERIFY(!shown.exportButton()->isEnabled());
}

void TestExport::theRowsAreThoseOfTheFormat() {
    ExportDialog& shown = openDialog();
    const auto rows = [&](int placement, int size, int pace) {
        return shown.upField()->isVisible() == bool(placement) &&
               shown.scaleField()->isVisible() == bool(placement) &&
               shown.widthField()->isVisible() == bool(size) &&
               shown.framesPerSecondField()->isVisible() == bool(pace);
    };
    QVERIFY(rows(1, 0, 0));
    choose(ExportKind::Measures);
    QVERIFY(rows(0, 0, 0));
    choose(ExportKind::Mdd);
    QVERIFY(rows(1, 0, 0));
    // These cannot be chosen without OpenGL, by keys.
    shown.kindField()->setCurrentIndex(int(ExportKind::PngFiles));
    QVERIFY(rows(0, 1, 0));
    shown.kindField()->setCurrentIndex(int(ExportKind::WebM));
    QVERIFY(rows(0, 1, 1));
}

void TestExport::itSaysWhatTheFilesWillHold() {
    ExportDialog& shown = openDialog();
    QVERIFY2(shown.summary().contains("10 files, scene_0000.obj to scene_0009.obj"),
             qPrintable(shown.summary()));
    m_window->typeInto(shown.everyField(), "4");
    m_window->key(Qt::Key_Return);
    QVERIFY2(shown.summary().contains("3 files, scene_0000.obj to scene_0002.obj"),
             qPrintable(shown.summary()));
    choose(ExportKind::Pc2);
    QVERIFY2(shown.summary().contains("3 frames") && shown.summary().contains("scene.obj beside it") &&
                 shown.summary().contains("KiB"),
             qPrintable(shown.summary()));
    m_window->typeInto(shown.firstField(), "9");
    m_window->key(Qt::Key_Return);
    QVERIFY2(shown.summary().startsWith("1 frame "), qPrintable(shown.summary()));
    m_window->typeInto(shown.lastField(), "8");
    m_window->key(Qt::Key_Return);
    QVERIFY(shown.summary().contains("before the first") && !shown.exportButton()->isEnabled());
    m_window->typeInto(shown.firstField(), "0");
    m_window->key(Qt::Key_Return);
    shown.kindField()->setCurrentIndex(int(ExportKind::Mp4));
    m_window->typeInto(shown.everyField(), "3");
    m_window->key(Qt::Key_Return);
    QVERIFY2(shown.summary().startsWith("3 frames, 0.10 s in real time"), qPrintable(shown.summary()));
    m_window->typeInto(shown.framesPerSecondField(), "7.5");
    m_window->typeInto(shown.widthField(), "641");
    m_window->key(Qt::Key_Return);
    QVERIFY2(shown.summary().startsWith("3 frames, 0.40 s at 0.25 × real time") &&
                 shown.summary().contains("640 × 720"),
             qPrintable(shown.summary()));
}

void TestExport::whatCannotBeUsedSaysWhy() {
    ExportDialog& shown = openDialog();
    const auto* model = qobject_cast<QStandardItemModel*>(shown.kindField()->model());
    for (int i = 0; i < kExportKinds; ++i) {
        const QStandardItem* item = model->item(i);
        QCOMPARE(item->isEnabled(), !hasPictures(ExportKind(i)));
        QCOMPARE(item->toolTip().contains("OpenGL"), hasPictures(ExportKind(i)));
    }
}

void TestExport::aPointCacheOfARange() {
    ExportDialog& shown = openDialog();
    choose(ExportKind::Pc2);
    typePath(m_window->path("out/run"));
    m_window->typeInto(shown.firstField(), "2");
    m_window->typeInto(shown.lastField(), "8");
    m_window->typeInto(shown.everyField(), "2");
    m_window->click(shown.exportButton()); // what is typed and not yet taken counts
    TRY_VERIFY(!running());
    QCOMPARE(files(), QStringList({"run.obj", "run.pc2"}));
    test::ByteReader reader(test::bytesOfFile(m_window->path("out/run.pc2").toStdString()));
    QCOMPARE(reader.text(12), std::string("POINTCACHE2\0", 12));
    QCOMPARE(reader.little(), 1U);
    QCOMPARE(reader.little(), 36U);
    reader.little();
    reader.little();
    QCOMPARE(reader.little(), 4U); // 2, 4, 6, 8
    for (const int frame : {2, 4, 6, 8}) {
        const PointArray& position = m_window->simulation().recording().frame(frame).exact->state.position;
        for (int p = 0; p < 36; ++p)
            for (const double value : {position.at(p).x(), position.at(p).y(), position.at(p).z()})
                QVERIFY(test::sameFloat(reader.littleFloat(), float(value)));
    }
    QVERIFY(reader.atEnd());
    QVERIFY2(shown.resultText().contains("4 frames") && shown.resultText().contains("run.pc2"),
             qPrintable(shown.resultText()));
    QVERIFY(m_window->output().contains("Exported 4 frames"));
    QVERIFY((*m_window)->statusBar()->currentMessage().contains("Exported 4 frames"));
    QVERIFY(!shown.progress()->isVisible());
}

void TestExport::inAndOutPointsAreWhatIsProposed() {
    m_window->simulation().showFrame(3);
    m_window->viewport().setFocus();
    m_window->key(Qt::Key_I);
    m_window->simulation().showFrame(7);
    m_window->key(Qt::Key_O);
    ExportDialog& shown = openDialog();
    QCOMPARE(shown.request().frames.first, 3);
    QCOMPARE(shown.request().frames.last, 7);
}

void TestExport::aSequenceWithAxesAndUnits() {
    ExportDialog& shown = openDialog();
    typePath(m_window->path("out/50% of %d.obj"));
    shown.upField()->setFocus();
    m_window->key(Qt::Key_Down);
    m_window->typeInto(shown.scaleField(), "100");
    m_window->key(Qt::Key_Return);
    m_window->click(shown.exportButton());
    TRY_VERIFY(!running());
    QCOMPARE(files().size(), 10);
    QCOMPARE(files().constLast(), "50% of %d_0009.obj");
    const FramePointer last = m_window->simulation().look(9);
    QVERIFY(!exportFrame(*last, ExportFormat::Obj, m_window->path("expected.obj").toStdString(),
                         {UpAxis::Z, 100}));
    QCOMPARE(test::bytesOfFile(m_window->path("out/50% of %d_0009.obj").toStdString()),
             test::bytesOfFile(m_window->path("expected.obj").toStdString()));
}

void TestExport::enterInTheNameExports() {
    openDialog();
    choose(ExportKind::Measures);
    typePath(m_window->path("out/run.csv"));
    m_window->key(Qt::Key_Return);
    TRY_VERIFY(!running() && files() == QStringList{"run.csv"});
    const auto text = QString::fromStdString(test::bytesOfFile(m_window->path("out/run.csv").toStdString()));
    QCOMPARE(text.count('\n'), 11); // with the names of the columns
    QCOMPARE(text.section('\n', 10, 10).section(',', 1, 1).toDouble(), 0.1);
}

void TestExport::itAsksOnceBeforeItReplacesFiles() {
    ExportDialog& shown = openDialog();
    QVERIFY(!m_window->writeText("out/run_0003.obj", "before").isEmpty());
    QVERIFY(!m_window->writeText("out/run_0005.obj", "before").isEmpty());
    typePath(m_window->path("out/run.obj"));
    {
        DialogAnswer no(QMessageBox::Cancel);
        m_window->click(shown.exportButton());
        QVERIFY(no.asked());
        QVERIFY2(no.text().contains("2 of the files") && no.text().contains("run_0003.obj"),
                 qPrintable(no.text()));
    }
    QVERIFY(!running());
    QCOMPARE(files(), QStringList({"run_0003.obj", "run_0005.obj"}));
    QCOMPARE(test::bytesOfFile(m_window->path("out/run_0003.obj").toStdString()), std::string("before"));
    DialogAnswer yes(QMessageBox::Yes);
    m_window->click(shown.exportButton());
    QVERIFY(yes.asked());
    TRY_VERIFY(!running());
    QCOMPARE(files().size(), 10);
    QVERIFY(test::bytesOfFile(m_window->path("out/run_0003.obj").toStdString()) != "before");
}

void TestExport::cancelLeavesNothingAndTheWindowGoesOn() {
    recordALot();
    ExportDialog& shown = openDialog();
    choose(ExportKind::CsvFiles);
    typePath(m_window->path("out/run.csv"));
    ExportProgress* inStatusBar = (*m_window)->exports().statusWidget();
    for (ExportProgress* progress : {shown.progress(), inStatusBar}) {
        shown.show();
        m_window->click(shown.exportButton());
        QVERIFY(running());
        QVERIFY(shown.progress()->isVisible() && !inStatusBar->isVisible());
        QVERIFY(!shown.exportButton()->isEnabled());
        if (progress == inStatusBar)
            shown.close();
        QVERIFY(progress->isVisible());
        QVERIFY2(progress->text().contains("of 21"), qPrintable(progress->text()));
        m_window->simulation().showFrame(7);
        QCOMPARE(m_window->frame(), 7);
        QApplication::processEvents(); // the layout with the button in it
        m_window->click(progress->cancelButton());
        TRY_VERIFY(!running());
        QCOMPARE(files(), QStringList());
        QVERIFY2(shown.resultText().contains("cancelled"), qPrintable(shown.resultText()));
        QVERIFY(!shown.progress()->isVisible() && !inStatusBar->isVisible());
        QVERIFY(shown.exportButton()->isEnabled());
    }
}

void TestExport::troubleIsTold() {
    ExportDialog& shown = openDialog();
    choose(ExportKind::Mdd);
    typePath(m_window->path("nowhere/" + QString(" in a long name").repeated(8).trimmed() + "/run.mdd"));
    m_window->click(shown.exportButton());
    TRY_VERIFY(!running());
    for (const QString& text : {shown.resultText(), (*m_window)->messageBar().text()})
        QVERIFY2(text.contains("name/run.mdd: ") && text.contains("no such file or folder"),
                 qPrintable(text));
    for (NumberField* field : {shown.firstField(), shown.scaleField()}) // a long text squeezes nothing
        QVERIFY(field->height() >= field->minimumSizeHint().height());
}

void TestExport::aFrameThatIsLaterDroppedIsStillWritten() {
    recordALot();
    ExportDialog& shown = openDialog();
    typePath(m_window->path("out/run.obj"));
    m_window->click(shown.exportButton());
    QVERIFY(running());
    m_window->simulation().restart();
    QCOMPARE(m_window->frameCount(), 1);
    TRY_VERIFY(!running());
    QCOMPARE(files().size(), 21);
}

void TestExport::closingTheWindowAsks() {
    recordALot();
    ExportDialog& shown = openDialog();
    choose(ExportKind::CsvFiles);
    typePath(m_window->path("out/run.csv"));
    m_window->click(shown.exportButton());
    QVERIFY(running());
    {
        DialogAnswer no(QMessageBox::No);
        (*m_window)->close();
        QVERIFY(no.asked());
    }
    QVERIFY((*m_window)->isVisible());
    const QString out = m_window->path("out");
    m_window->open(); // another window; the first one goes in the middle of it, or just after
    QVERIFY(!(*m_window)->exports().isRunning());
    const int left = int(QDir(out).entryList(QDir::Files | QDir::Hidden).size());
    QVERIFY2(left == 0 || left == 21, qPrintable(QString::number(left)));
}

CLOTHLAB_GUI_TEST_MAIN(TestExport)
#include "tst_export.moc"
