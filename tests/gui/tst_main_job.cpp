// The main job from end to end, by clicks and keys: open, change, undo, run, look, save, open again.
#include "tests/gui/dialog_answer.h"
#include "tests/gui/test_window.h"

using namespace clothlab;

class TestMainJob : public QObject {
    Q_OBJECT

private slots:
    void aSceneOfTheCourseIsOpenedChangedRunLookedAtSavedAndOpenedAgain();
};

void TestMainJob::aSceneOfTheCourseIsOpenedChangedRunLookedAtSavedAndOpenedAgain() {
    TestWindow window;

    // Open.
    DialogAnswer chooseScene(chooseFile(QStringLiteral(CLOTHLAB_SOURCE_DIR "/scenes/pinned2.json")));
    window.key(Qt::Key_O, Qt::ControlModifier);
    QVERIFY(chooseScene.asked());
    QCOMPARE(window.document().displayName(), QStringLiteral("pinned2.json"));
    QCOMPARE(window->windowTitle(), QStringLiteral("pinned2.json[*] — ClothLab"));
    QCOMPARE(window.scene().cloth.pinned.size(), std::size_t(2));
    QVERIFY(!window->isWindowModified());

    // Edit.
    window.typeInto(window.field("cloth.ks"), "2500");
    window.key(Qt::Key_Return);
    QCOMPARE(window.scene().cloth.ks, 2500.0);
    QVERIFY(window->isWindowModified());

    // Undo and redo.
    window.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(window.scene().cloth.ks, 5000.0);
    QCOMPARE(window.field("cloth.ks")->value(), 5000.0);
    QVERIFY(!window->isWindowModified());
    window.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(window.scene().cloth.ks, 2500.0);
    QVERIFY(window->isWindowModified());

    // Play and pause.
    window.key(Qt::Key_Space);
    QVERIFY(window.simulation().isPlaying());
    TRY_VERIFY(window.frameCount() > 10);
    window.key(Qt::Key_P);
    QVERIFY(!window.simulation().isPlaying());
    const int last = window.frame();
    QCOMPARE(last, window.frameCount() - 1);

    // Scrub, and step back.
    Scrubber* scrubber = window->timelinePanel().scrubber();
    window.click(scrubber, QPoint(int(scrubber->positionOf(6)), scrubber->height() - 12));
    QCOMPARE(window.frame(), 6);
    window.key(Qt::Key_Left);
    QCOMPARE(window.frame(), 5);
    QCOMPARE(window.frameCount(), last + 1);

    // Pick what is drawn in the middle of the upper edge.
    const Grid grid = window.document().grid();
    const int point = grid.index(25, 0);
    const Selection::Item item{Selection::Kind::Point, point};
    QCOMPARE(window.viewport().itemAt(window.viewport().positionOf(point)), std::optional(item));
    window.click(&window.viewport(), window.viewport().positionOf(point).toPoint());
    QCOMPARE(window.document().selection().active(), std::optional(item));
    QCOMPARE(window->inspectorPanel().lines().at(0).second, QString::number(point));
    QCOMPARE(window->inspectorPanel().lines().at(1).second, QStringLiteral("(25, 0)"));

    // Save as, change, save.
    const QString path = window.path("mine.json");
    DialogAnswer chooseName(chooseFile(path));
    window.key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(chooseName.asked());
    QCOMPARE(window.document().path(), path);
    QVERIFY(!window->isWindowModified());
    window.typeInto(window.field("cloth.density"), "20");
    window.key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!window->isWindowModified());
    const Scene saved = window.scene();
    QCOMPARE(saved.cloth.density, 200.0);

    // Open it again, in a new window.
    window.open();
    QVERIFY(window->files().open(path));
    QVERIFY(window.scene() == saved);
    QCOMPARE(window.field("cloth.ks")->value(), 2500.0);
    QCOMPARE(window.field("cloth.density")->value(), 20.0);
}

CLOTHLAB_GUI_TEST_MAIN(TestMainJob)
#include "tst_main_job.moc"
