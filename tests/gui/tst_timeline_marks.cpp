// Markers, in and out points: by keys and mouse, undone, saved, and after a crash.
#include "tests/gui/timeline_window.h"

#include <QDir>
#include <QLineEdit>

using namespace clothlab;

class TestTimelineMarks : public QObject {
    Q_OBJECT

private slots:
    void init() { m_window = std::make_unique<TimelineWindow>(); }
    void cleanup() { m_window.reset(); }

    void markersByKeysCanBeUndone();
    void aClickOnAMarkerGoesThere();
    void aMarkerIsRenamedInPlace();
    void deleteRemovesTheMarkerThatWasClicked();
    void inAndOutPointsAreDragged();
    void aBranchBeginsWithoutMarks();
    void marksAreSavedAndOpened();
    void marksSurviveACrash();

private:
    Scrubber& scrubber() { return m_window->scrubber(); }
    Simulation& simulation() { return m_window->simulation(); }
    Actions& actions() { return m_window->actions(); }

    std::unique_ptr<TimelineWindow> m_window;
};

void TestTimelineMarks::markersByKeysCanBeUndone() {
    QVERIFY(m_window->simulateTo(20));
    for (const int frame : {12, 4, 8}) {
        simulation().showFrame(frame);
        m_window->key(Qt::Key_M);
    }
    QCOMPARE(m_window->markers(), (std::vector<int>{4, 8, 12}));
    QVERIFY(!actions().addMarker->isEnabled()); // there is one
    m_window->key(Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(m_window->frame(), 12);
    QVERIFY(!actions().nextMarker->isEnabled());
    m_window->key(Qt::Key_Left, Qt::ControlModifier);
    m_window->key(Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(m_window->frame(), 4);
    QVERIFY(!actions().previousMarker->isEnabled());
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_window->markers(), (std::vector<int>{4, 12}));
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(m_window->markers().empty());
    for (int i = 0; i < 3; ++i)
        m_window->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(m_window->markers(), (std::vector<int>{4, 8, 12}));
    QCOMPARE(m_window->frame(), 4); // undo shows no other frame
}

void TestTimelineMarks::aClickOnAMarkerGoesThere() {
    QVERIFY(m_window->simulateTo(60));
    simulation().setMarker(25, "splash");
    m_window->click(&scrubber(), m_window->onMarks(25) + QPoint(3, 0)); // beside it
    QCOMPARE(m_window->frame(), 25);
}

void TestTimelineMarks::aMarkerIsRenamedInPlace() {
    QVERIFY(m_window->simulateTo(60));
    simulation().setMarker(25, "splash");
    const auto field = [this] { return scrubber().findChild<QLineEdit*>("markerName"); };
    m_window->doubleClick(&scrubber(), m_window->onMarks(25));
    QVERIFY(field() && field()->hasFocus());
    m_window->type("first touch, in May"); // with letters that are keys elsewhere
    QCOMPARE(field()->text(), QStringLiteral("first touch, in May"));
    m_window->key(Qt::Key_Return);
    QCOMPARE(simulation().marks().markers.at(0).name, std::string("first touch, in May"));
    QVERIFY(!simulation().isPlaying());
    TRY_VERIFY(!field());
    m_window->doubleClick(&scrubber(), m_window->onMarks(25));
    m_window->type("other");
    m_window->key(Qt::Key_Escape);
    QCOMPARE(simulation().marks().markers.at(0).name, std::string("first touch, in May"));
    TRY_VERIFY(!field());
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(simulation().marks().markers.at(0).name, std::string("splash"));
}

void TestTimelineMarks::deleteRemovesTheMarkerThatWasClicked() {
    QVERIFY(m_window->simulateTo(60));
    simulation().setMarker(25, "a");
    simulation().setMarker(50, "b");
    m_window->key(Qt::Key_Delete); // none was clicked
    QCOMPARE(m_window->markers(), (std::vector<int>{25, 50}));
    m_window->click(&scrubber(), m_window->onMarks(50));
    m_window->key(Qt::Key_Delete);
    QCOMPARE(m_window->markers(), std::vector<int>{25});
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_window->markers(), (std::vector<int>{25, 50}));
}

void TestTimelineMarks::inAndOutPointsAreDragged() {
    QVERIFY(m_window->simulateTo(80));
    simulation().setInPoint(20);
    simulation().setOutPoint(60);
    const int steps = m_window->document().undoStack().count();
    const int frame = m_window->frame();
    m_window->drag(&scrubber(), m_window->onMarks(20), m_window->onMarks(30));
    QCOMPARE(simulation().marks().range, (InOutPoints{30, 60}));
    QCOMPARE(m_window->document().undoStack().count(), steps + 1);             // one step
    m_window->drag(&scrubber(), m_window->onMarks(60), m_window->onMarks(10)); // not past the other
    QCOMPARE(simulation().marks().range, (InOutPoints{30, 30}));
    QCOMPARE(m_window->frame(), frame); // that was no scrubbing
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(simulation().marks().range, (InOutPoints{30, 60}));
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(simulation().marks().range, (InOutPoints{20, 60}));
    m_window->key(Qt::Key_X, Qt::AltModifier);
    QVERIFY(!simulation().marks().range);
    QVERIFY(!actions().clearRange->isEnabled());
}

void TestTimelineMarks::aBranchBeginsWithoutMarks() {
    QVERIFY(m_window->simulateTo(10));
    simulation().setMarker(3, "a");
    simulation().setInPoint(2);
    simulation().showFrame(5);
    m_window->typeInto(m_window->field("cloth.ks"), "900");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->markers().size(), 1U);
    const int takes = int(simulation().recording().takes().size());
    m_window->viewport().setFocus();
    m_window->key(Qt::Key_N);
    TRY_COMPARE(int(simulation().recording().takes().size()), takes + 1);
    QVERIFY(simulation().marks() == TakeMarks());
    simulation().openTake(1);
    QCOMPARE(m_window->markers().size(), 1U);
}

void TestTimelineMarks::marksAreSavedAndOpened() {
    QVERIFY(m_window->simulateTo(10));
    simulation().setMarker(3, "first touch");
    simulation().setMarker(8, "b");
    simulation().setInPoint(2);
    const TakeMarks before = simulation().marks();
    const QString path = m_window->path("marks.clothtake");
    bool written = false;
    simulation().gatherContents(
        [&](const TakeFileContents& contents) { written = !writeTakeFile(path.toStdString(), contents); });
    TRY_VERIFY(written);
    m_window->document().newScene();
    QVERIFY(simulation().marks() == TakeMarks());
    QVERIFY((*m_window)->files().openUnasked(path));
    QVERIFY(simulation().marks() == before);
    QCOMPARE(m_window->frameCount(), 11);
}

// What the journal holds while nothing was saved.
void TestTimelineMarks::marksSurviveACrash() {
    QVERIFY(m_window->simulateTo(10));
    simulation().setMarker(3, "first touch");
    simulation().setOutPoint(7);
    m_window->typeInto(m_window->field("cloth.ks"), "900"); // which is told, too
    m_window->key(Qt::Key_Return);
    bool packed = false;
    simulation().whenPacked([&] { packed = true; });
    TRY_VERIFY(packed);
    const QStringList journals =
        QDir(m_window->path("recovery")).entryList({"*.clothtake"}, QDir::Files, QDir::Time);
    QVERIFY(!journals.isEmpty());
    const TakeFileReading reading =
        readTakeFile(m_window->path("recovery/" + journals.constFirst()).toStdString());
    QVERIFY(reading.contents);
    const LoadedTakes loaded = takesOf(*reading.contents);
    QVERIFY(loaded.open->marks() == simulation().marks());
    QCOMPARE(loaded.scene->cloth.ks, 900.0);
}

CLOTHLAB_GUI_TEST_MAIN(TestTimelineMarks)
#include "tst_timeline_marks.moc"
