// Speeds, loops, in and out points, markers, plot and pictures of the timeline, by keys and mouse.
#include "app/docks/frame_preview.h"
#include "app/picture/thumbnail.h"
#include "app/widgets/theme.h"
#include "tests/gui/test_window.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QSet>

#include <chrono>

using namespace clothlab;

class TestTimeline : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void noKeyIsTakenTwice();
    void shiftSpacePlaysBackward();
    void backwardFromTheStartBeginsAtTheEnd();
    void backwardWithNothingRecordedIsNotOffered();
    void bracketsChangeTheSpeed();
    void selectorsAndActionsShowTheSameSettings();
    void aLoopStaysInItsRangeAndRecordsNothing();
    void pingPongGoesToAndFro();
    void playingStopsAtTheOutPoint();
    void livePlayIsSaidAndRecordsEveryFrame();
    void scrubbingPausesAndNeverPlaysAgain();
    void ofManyMouseMovesTheNewestWins();
    void markersByKeysCanBeUndone();
    void aClickOnAMarkerGoesThere();
    void aMarkerIsRenamedInPlace();
    void deleteRemovesTheMarkerThatWasClicked();
    void inAndOutPointsAreDragged();
    void aBranchBeginsWithoutMarks();
    void marksAreSavedAndOpened();
    void marksSurviveACrash();
    void aTypedTimeShowsTheNearestFrame();
    void thePlotKnowsEveryPackedFrame();
    void aPictureAppearsWhereTheMouseRests();
    void theBarSaysWhatIsKeptOfFrames();
    void whatIsOnDiskOnlyIsSaid();
    void paintingCostsTheSameForManyFrames();
    void nothingIsCutOffInHalfAWindow();

private:
    TimelinePanel& timeline() { return (*m_window)->timelinePanel(); }
    Scrubber& scrubber() { return *timeline().scrubber(); }
    Actions& actions() { return (*m_window)->actions(); }
    Simulation& simulation() { return m_window->simulation(); }
    QPoint onBar(double frame) { return {qRound(scrubber().positionOf(frame)), scrubber().height() - 10}; }
    QPoint onMarks(double frame) {
        return {qRound(scrubber().positionOf(frame)), qRound(scrubber().marksRow().center().y())};
    }
    QComboBox* choice(const char* name) { return timeline().findChild<QComboBox*>(name); }
    void choose(const char* name, const QString& text) {
        QComboBox* box = choice(name);
        box->setCurrentIndex(box->findText(text));
        emit box->activated(box->currentIndex());
    }
    std::vector<int> markers() {
        std::vector<int> frames;
        for (const Marker& marker : simulation().marks().markers)
            frames.push_back(marker.frame);
        return frames;
    }
    // Without a button, as a platform sends them.
    void moveMouse(QPoint at) {
        QTest::mouseEvent(QTest::MouseMove, scrubber().window()->windowHandle(), Qt::NoButton, {},
                          scrubber().mapTo(scrubber().window(), at));
    }

    // Of the bar, at that frame.
    static QColor colorAt(Scrubber& bar, double frame) {
        return bar.grab().toImage().pixelColor(qRound(bar.positionOf(frame)), bar.height() - 10);
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestTimeline::init() {
    m_window = std::make_unique<TestWindow>();
    QVERIFY(m_window->load(smallScene()));
}

void TestTimeline::noKeyIsTakenTwice() {
    QSet<QString> taken;
    for (const QAction* action : (*m_window)->QWidget::actions())
        for (const QKeySequence& key : action->shortcuts()) {
            QVERIFY2(!taken.contains(key.toString()), qPrintable(key.toString()));
            taken << key.toString();
        }
    for (const char* key : {"Shift+Space", "[", "]", "L", "I", "O", "Alt+X", "M", "Ctrl+Left", "Ctrl+Right"})
        QVERIFY2(taken.contains(key), key);
}

void TestTimeline::shiftSpacePlaysBackward() {
    QVERIFY(m_window->simulateTo(12));
    simulation().showFrame(6);
    QList<int> shown;
    connect(&simulation(), &Simulation::frameShown, this, [&] { shown << m_window->frame(); });
    m_window->key(Qt::Key_Space, Qt::ShiftModifier);
    QVERIFY(simulation().isPlayingBackward());
    QCOMPARE(timeline().stateText(), QStringLiteral("Backward"));
    TRY_VERIFY(!simulation().isPlaying());
    disconnect(&simulation(), nullptr, this, nullptr);
    QCOMPARE(shown.mid(0, 6), (QList<int>{5, 4, 3, 2, 1, 0}));
    QCOMPARE(m_window->frameCount(), 13);
    // While it plays forward it turns round; again, it pauses.
    simulation().showFrame(3);
    m_window->key(Qt::Key_BracketLeft);
    m_window->key(Qt::Key_Space);
    m_window->key(Qt::Key_Space, Qt::ShiftModifier);
    QVERIFY(simulation().isPlayingBackward());
    m_window->key(Qt::Key_Space, Qt::ShiftModifier);
    QVERIFY(!simulation().isPlaying());
}

void TestTimeline::backwardFromTheStartBeginsAtTheEnd() {
    QVERIFY(m_window->simulateTo(12));
    m_window->key(Qt::Key_Home, Qt::ControlModifier);
    m_window->key(Qt::Key_Space, Qt::ShiftModifier);
    QVERIFY(m_window->frame() > 8);
    TRY_COMPARE(m_window->frame(), 0);
    QVERIFY(!simulation().isPlaying());
}

void TestTimeline::backwardWithNothingRecordedIsNotOffered() {
    QVERIFY(!actions().playBackward->isEnabled());
    QCOMPARE(actions().playBackward->toolTip(), QStringLiteral("Nothing is recorded yet"));
    m_window->key(Qt::Key_Space, Qt::ShiftModifier);
    QVERIFY(!simulation().isPlaying());
    m_window->key(Qt::Key_L);
    m_window->key(Qt::Key_Space); // nothing to loop over
    QVERIFY(!simulation().isPlaying());
    QVERIFY2(m_window->output().contains("Nothing is recorded yet"), qPrintable(m_window->output()));
}

void TestTimeline::bracketsChangeTheSpeed() {
    m_window->key(Qt::Key_BracketRight);
    QCOMPARE(simulation().playback().speed, 2.0);
    for (int i = 0; i < 5; ++i)
        m_window->key(Qt::Key_BracketRight);
    QCOMPARE(simulation().playback().speed, 8.0);
    QVERIFY(!actions().faster->isEnabled());
    for (int i = 0; i < 9; ++i)
        m_window->key(Qt::Key_BracketLeft);
    QCOMPARE(simulation().playback().speed, 0.125);
    QVERIFY(!actions().slower->isEnabled() && actions().faster->isEnabled());
    QCOMPARE(choice("playbackSpeed")->currentText(), QString::fromUtf8("1/8×"));
}

void TestTimeline::selectorsAndActionsShowTheSameSettings() {
    choose("playbackSpeed", QString::fromUtf8("4×"));
    choose("playbackPace", "Real time");
    choose("playbackRepeat", "Ping-pong");
    QCOMPARE(simulation().playback(), (PlaybackSettings{4, true, Repeat::PingPong}));
    QVERIFY(actions().loop->isChecked());
    m_window->key(Qt::Key_L);
    QCOMPARE(choice("playbackRepeat")->currentText(), QStringLiteral("Once"));
    m_window->key(Qt::Key_L);
    QCOMPARE(choice("playbackRepeat")->currentText(), QStringLiteral("Loop"));
    QVERIFY(actions().loop->isChecked());
}

void TestTimeline::aLoopStaysInItsRangeAndRecordsNothing() {
    QVERIFY(m_window->simulateTo(20));
    simulation().showFrame(5);
    m_window->key(Qt::Key_I);
    simulation().showFrame(9);
    m_window->key(Qt::Key_O);
    simulation().showFrame(15);
    m_window->key(Qt::Key_L);
    for (const bool realTime : {false, true}) {
        choose("playbackPace", realTime ? "Real time" : "Every frame");
        QList<int> shown;
        connect(&simulation(), &Simulation::frameShown, this, [&] { shown << m_window->frame(); });
        m_window->key(Qt::Key_Space);
        QVERIFY(simulation().isPlaying());
        TRY_VERIFY(shown.size() > 25);
        QVERIFY(!simulation().isRecordingLive());
        m_window->key(Qt::Key_Space);
        disconnect(&simulation(), nullptr, this, nullptr);
        for (const int frame : shown)
            QVERIFY2(frame >= 5 && frame <= 9, qPrintable(QString::number(frame)));
        QCOMPARE(m_window->frameCount(), 21);
    }
}

void TestTimeline::pingPongGoesToAndFro() {
    QVERIFY(m_window->simulateTo(3));
    choose("playbackRepeat", "Ping-pong");
    QList<int> shown;
    connect(&simulation(), &Simulation::frameShown, this, [&] { shown << m_window->frame(); });
    m_window->key(Qt::Key_Space);
    TRY_VERIFY(shown.size() >= 8);
    m_window->key(Qt::Key_Space);
    disconnect(&simulation(), nullptr, this, nullptr);
    QCOMPARE(shown.mid(0, 8), (QList<int>{2, 1, 0, 1, 2, 3, 2, 1}));
    QCOMPARE(m_window->frameCount(), 4);
}

void TestTimeline::playingStopsAtTheOutPoint() {
    QVERIFY(m_window->simulateTo(10));
    simulation().showFrame(6);
    m_window->key(Qt::Key_O);
    simulation().showFrame(2);
    m_window->key(Qt::Key_Space);
    TRY_VERIFY(!simulation().isPlaying());
    QCOMPARE(m_window->frame(), 6);
    QCOMPARE(m_window->frameCount(), 11);
    m_window->key(Qt::Key_Space); // from there on
    TRY_VERIFY(m_window->frameCount() > 13);
    m_window->key(Qt::Key_Space);
}

void TestTimeline::livePlayIsSaidAndRecordsEveryFrame() {
    choose("playbackPace", "Real time");
    choose("playbackSpeed", QString::fromUtf8("8×"));
    QList<int> shown;
    connect(&simulation(), &Simulation::frameShown, this, [&] { shown << m_window->frame(); });
    m_window->key(Qt::Key_Space);
    QVERIFY(simulation().isRecordingLive());
    QVERIFY(timeline().stateText().contains("Live"));
    TRY_VERIFY(m_window->frameCount() > 60);
    m_window->key(Qt::Key_Space);
    disconnect(&simulation(), nullptr, this, nullptr);
    for (int i = 0; i < shown.size(); ++i)
        QCOMPARE(shown.at(i), i + 1);
    QCOMPARE(timeline().stateText(), QStringLiteral("Paused"));
}

void TestTimeline::scrubbingPausesAndNeverPlaysAgain() {
    QVERIFY(m_window->simulateTo(30));
    simulation().showFrame(0);
    m_window->key(Qt::Key_Space);
    QVERIFY(simulation().isPlaying());
    m_window->drag(&scrubber(), onBar(4), onBar(20));
    QVERIFY(!simulation().isPlaying());
    QTest::qWait(100);
    QVERIFY(!simulation().isPlaying());
    QCOMPARE(m_window->frame(), 20);
    QCOMPARE(m_window->frameCount(), 31);
}

// None of them waits in a queue: the mouse may move while a frame is being shown.
void TestTimeline::ofManyMouseMovesTheNewestWins() {
    QVERIFY(m_window->simulateTo(60));
    QList<int> shown;
    connect(&simulation(), &Simulation::frameShown, this, [&] { shown << m_window->frame(); });
    const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton button) {
        const bool up = type == QEvent::MouseButtonRelease;
        QMouseEvent event(type, at, scrubber().mapToGlobal(QPointF(at)), button,
                          up ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&scrubber(), &event);
    };
    send(QEvent::MouseButtonPress, onBar(0), Qt::LeftButton);
    QCOMPARE(shown, QList<int>{0});
    for (int i = 1; i <= 100; ++i)
        send(QEvent::MouseMove, onBar(i % 61), Qt::NoButton);
    QApplication::processEvents();
    QCOMPARE(m_window->frame(), 100 % 61);
    QCOMPARE(shown, (QList<int>{0, 100 % 61}));
    send(QEvent::MouseMove, onBar(50), Qt::NoButton);
    send(QEvent::MouseButtonRelease, onBar(50), Qt::LeftButton); // does not wait for anything
    QCOMPARE(m_window->frame(), 50);
    QTest::qWait(50);
    QCOMPARE(shown, (QList<int>{0, 100 % 61, 50}));
    disconnect(&simulation(), nullptr, this, nullptr);
}

void TestTimeline::markersByKeysCanBeUndone() {
    QVERIFY(m_window->simulateTo(20));
    for (const int frame : {12, 4, 8}) {
        simulation().showFrame(frame);
        m_window->key(Qt::Key_M);
    }
    QCOMPARE(markers(), (std::vector<int>{4, 8, 12}));
    QVERIFY(!actions().addMarker->isEnabled()); // there is one
    m_window->key(Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(m_window->frame(), 12);
    QVERIFY(!actions().nextMarker->isEnabled());
    m_window->key(Qt::Key_Left, Qt::ControlModifier);
    m_window->key(Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(m_window->frame(), 4);
    QVERIFY(!actions().previousMarker->isEnabled());
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(markers(), (std::vector<int>{4, 12}));
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(markers().empty());
    for (int i = 0; i < 3; ++i)
        m_window->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(markers(), (std::vector<int>{4, 8, 12}));
    QCOMPARE(m_window->frame(), 4); // undo shows no other frame
}

void TestTimeline::aClickOnAMarkerGoesThere() {
    QVERIFY(m_window->simulateTo(60));
    simulation().setMarker(25, "splash");
    m_window->click(&scrubber(), onMarks(25) + QPoint(3, 0)); // beside it
    QCOMPARE(m_window->frame(), 25);
}

void TestTimeline::aMarkerIsRenamedInPlace() {
    QVERIFY(m_window->simulateTo(60));
    simulation().setMarker(25, "splash");
    const auto field = [this] { return scrubber().findChild<QLineEdit*>("markerName"); };
    m_window->doubleClick(&scrubber(), onMarks(25));
    QVERIFY(field() && field()->hasFocus());
    m_window->type("first touch, in May"); // with letters that are keys elsewhere
    QCOMPARE(field()->text(), QStringLiteral("first touch, in May"));
    m_window->key(Qt::Key_Return);
    QCOMPARE(simulation().marks().markers.at(0).name, std::string("first touch, in May"));
    QVERIFY(!simulation().isPlaying());
    TRY_VERIFY(!field());
    m_window->doubleClick(&scrubber(), onMarks(25));
    m_window->type("other");
    m_window->key(Qt::Key_Escape);
    QCOMPARE(simulation().marks().markers.at(0).name, std::string("first touch, in May"));
    TRY_VERIFY(!field());
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(simulation().marks().markers.at(0).name, std::string("splash"));
}

void TestTimeline::deleteRemovesTheMarkerThatWasClicked() {
    QVERIFY(m_window->simulateTo(60));
    simulation().setMarker(25, "a");
    simulation().setMarker(50, "b");
    m_window->key(Qt::Key_Delete); // none was clicked
    QCOMPARE(markers(), (std::vector<int>{25, 50}));
    m_window->click(&scrubber(), onMarks(50));
    m_window->key(Qt::Key_Delete);
    QCOMPARE(markers(), std::vector<int>{25});
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(markers(), (std::vector<int>{25, 50}));
}

void TestTimeline::inAndOutPointsAreDragged() {
    QVERIFY(m_window->simulateTo(80));
    simulation().setInPoint(20);
    simulation().setOutPoint(60);
    const int steps = m_window->document().undoStack().count();
    const int frame = m_window->frame();
    m_window->drag(&scrubber(), onMarks(20), onMarks(30));
    QCOMPARE(simulation().marks().range, (InOutPoints{30, 60}));
    QCOMPARE(m_window->document().undoStack().count(), steps + 1); // one step
    m_window->drag(&scrubber(), onMarks(60), onMarks(10));         // not past the other
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

void TestTimeline::aBranchBeginsWithoutMarks() {
    QVERIFY(m_window->simulateTo(10));
    simulation().setMarker(3, "a");
    simulation().setInPoint(2);
    simulation().showFrame(5);
    m_window->typeInto(m_window->field("cloth.ks"), "900");
    m_window->key(Qt::Key_Return);
    QCOMPARE(markers().size(), 1U);
    const int takes = int(simulation().recording().takes().size());
    m_window->viewport().setFocus();
    m_window->key(Qt::Key_N);
    TRY_COMPARE(int(simulation().recording().takes().size()), takes + 1);
    QVERIFY(simulation().marks() == TakeMarks());
    simulation().openTake(1);
    QCOMPARE(markers().size(), 1U);
}

void TestTimeline::marksAreSavedAndOpened() {
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
void TestTimeline::marksSurviveACrash() {
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

void TestTimeline::aTypedTimeShowsTheNearestFrame() {
    QVERIFY(m_window->simulateTo(45));
    const auto goTo = [&](const QString& text) {
        m_window->typeInto(timeline().timeField(), text);
        m_window->key(Qt::Key_Return);
        return m_window->frame();
    };
    QCOMPARE(goTo("0.1"), 9);
    QCOMPARE(goTo("1/3"), 30);
    QCOMPARE(goTo("0"), 0);
    QCOMPARE(goTo("0.5"), 45);
    QCOMPARE(goTo("0.104"), 9);
    QCOMPARE(timeline().timeField()->value(), 0.1);
    goTo("2");
    QCOMPARE(m_window->frame(), 9);
    QVERIFY2(m_window->output().contains("from 0 s to 0.5 s"), qPrintable(m_window->output()));
}

void TestTimeline::thePlotKnowsEveryPackedFrame() {
    QVERIFY(m_window->simulateTo(40));
    TRY_COMPARE(scrubber().plot().frameCount(), 41);
    const auto check = [&](double FrameFacts::*what) {
        for (int frame = 0; frame < 41; ++frame) {
            const double value = factsOf(*simulation().recording().take(), frame)->*what;
            QCOMPARE(scrubber().plot().extent(frame, frame + 1).greatest, float(value));
        }
    };
    check(&FrameFacts::kineticEnergy);
    for (int begin = 0; begin < 41; ++begin)
        for (int end = begin + 1; end <= 41; ++end) {
            auto plain = scrubber().plot().extent(begin, begin + 1);
            for (int frame = begin; frame < end; ++frame) {
                const auto one = scrubber().plot().extent(frame, frame + 1);
                plain = {std::min(plain.least, one.least), std::max(plain.greatest, one.greatest)};
            }
            const auto extent = scrubber().plot().extent(begin, end);
            QVERIFY(extent.least == plain.least && extent.greatest == plain.greatest);
        }
    choose("plotQuantity", "Greatest strain");
    QCOMPARE(scrubber().plot().frameCount(), 41);
    check(&FrameFacts::greatestStrain);
    choose("plotQuantity", "No plot");
    QCOMPARE(scrubber().plot().frameCount(), 0);
    QVERIFY(!scrubber().grab().isNull());
}

void TestTimeline::aPictureAppearsWhereTheMouseRests() {
    QVERIFY(m_window->simulateTo(40));
    FramePreview& preview = scrubber().preview();
    QVERIFY(!preview.isVisible());
    moveMouse(onBar(10));
    moveMouse(onBar(20));
    TRY_COMPARE(preview.shownFrame(), 20);
    const QImage first = preview.picture();
    QSet<QRgb> colors;
    for (int y = 0; y < first.height(); ++y)
        for (int x = 0; x < first.width(); ++x)
            colors << first.pixel(x, y);
    QVERIFY2(colors.size() > 10, "a shaded sheet");
    moveMouse(onBar(40));
    TRY_COMPARE(preview.shownFrame(), 40);
    QVERIFY(preview.picture() != first); // it has moved
    moveMouse(onBar(20));
    TRY_COMPARE(preview.shownFrame(), 20);
    QCOMPARE(preview.picture(), first);
    QCOMPARE(m_window->frame(), 40); // hovering shows nothing in the view
    m_window->click(&scrubber(), onBar(30));
    QVERIFY(!preview.isVisible());
    moveMouse(QPoint(onBar(20).x(), 2)); // over the numbers
    QTest::qWait(200);
    QVERIFY(!preview.isVisible());
}

void TestTimeline::theBarSaysWhatIsKeptOfFrames() {
    const ThemeColors& colors = themeColors();
    QVERIFY(m_window->simulateTo(40));
    simulation().showFrame(20);
    QCOMPARE(colorAt(scrubber(), 10), colors.accent);
    QCOMPARE(colorAt(scrubber(), 60), colors.field);
    m_window->typeInto(m_window->field("cloth.ks"), "900");
    m_window->key(Qt::Key_Return);
    QCOMPARE(colorAt(scrubber(), 10), colors.accent);
    const QColor stale = colorAt(scrubber(), 30);
    QVERIFY(stale != colors.accent && stale != colors.field && stale.red() > stale.blue());

    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    m_window->key(Qt::Key_Space); // first what is recorded, which is not live
    QCOMPARE(colorAt(scrubber(), 10), colors.accent);
    TRY_VERIFY(m_window->frameCount() > 50);
    QCOMPARE(colorAt(scrubber(), 43), colors.error);
    QCOMPARE(colorAt(scrubber(), 10), colors.accent);
    m_window->key(Qt::Key_Space);
    QCOMPARE(colorAt(scrubber(), 43), colors.accent);
}

void TestTimeline::whatIsOnDiskOnlyIsSaid() {
    QTemporaryDir folder;
    Document document;
    Simulation simulation(document, nullptr, 60'000); // bytes
    simulation.setJournals([&] { return folder.filePath("journal.clothtake"); });
    document.edit("sheet", smallScene());
    Scrubber bar(document, simulation);
    bar.resize(600, 100);
    const auto isOnDisk = [&](int frame) {
        const RecordedFrame& recorded = simulation.recording().frame(frame);
        return !recorded.exact && recorded.group && recorded.group->payload->bytesInMemory() == 0;
    };
    simulation.play();
    TRY_VERIFY(simulation.recording().frameCount() > 80 && isOnDisk(4));
    simulation.pause();
    QTest::qWait(400); // it is not asked with every frame
    QVERIFY(!isOnDisk(simulation.recording().lastFrame()));
    const QColor onDisk = colorAt(bar, 4);
    const ThemeColors& colors = themeColors();
    QVERIFY(onDisk != colors.accent && onDisk != colors.field);
    QCOMPARE(colorAt(bar, simulation.recording().lastFrame() - 1), colors.accent);
}

void TestTimeline::paintingCostsTheSameForManyFrames() {
    // A take of that many frames, all of which one packed group stands for.
    constexpr int many = 300'000;
    QVERIFY(m_window->simulateTo(16));
    TRY_COMPARE(scrubber().plot().frameCount(), 17);
    const auto group = simulation().recording().frame(3).group;
    const FramePointer start = simulation().look(0);
    auto take = std::make_shared<Take>(1, "long", start);
    take->frame(0).group = group;
    std::vector<std::shared_ptr<const FrameGroup>> groups;
    for (int first = 0; first < many; first += 16) {
        auto made = std::make_shared<FrameGroup>(*group);
        made->first = first;
        made->frames.assign(16, group->frames.front());
        for (int i = 0; i < 16; ++i)
            made->frames[std::size_t(i)].facts.kineticEnergy = 1 + std::sin((first + i) / 5000.0);
        groups.push_back(std::move(made));
    }
    for (int frame = 0; frame < many; ++frame) {
        if (frame > 0)
            take->append({start->scene, frame / 90.0, nullptr, nullptr, nullptr});
        take->frame(frame).group = groups[std::size_t(frame / 16)];
    }
    simulation().load({{take}, take, 0, start->scene}, {});
    TRY_COMPARE(scrubber().plot().frameCount(), many);

    using Clock = std::chrono::steady_clock;
    const auto milliseconds = [](Clock::duration time) {
        return std::chrono::duration<double, std::milli>(time).count();
    };
    QImage image(scrubber().size(), QImage::Format_ARGB32_Premultiplied);
    scrubber().render(&image); // makes what changes seldom
    constexpr int times = 200;
    const auto before = Clock::now();
    for (int i = 0; i < times; ++i)
        scrubber().render(&image);
    const double each = milliseconds(Clock::now() - before) / times;
    const auto beforeAll = Clock::now();
    for (int i = 0; i < 10; ++i) {
        scrubber().resize(scrubber().width() - 1, scrubber().height());
        scrubber().render(&image);
    }
    const double whole = milliseconds(Clock::now() - beforeAll) / 10;
    qInfo("%d frames: %.3f ms to paint, %.3f ms with plot and ticks", many, each, whole);
    QVERIFY2(each < 8, qPrintable(QString::number(each))); // O(frames) would be tens of ms
    QVERIFY2(whole < 40, qPrintable(QString::number(whole)));
}

void TestTimeline::nothingIsCutOffInHalfAWindow() {
    (*m_window)->dock("timeline")->setFloating(true);
    for (const int width : {1280, 720, 640, 480}) {
        (*m_window)->dock("timeline")->resize(width, 200);
        QTest::qWait(50);
        for (const QWidget* child : timeline().findChildren<QWidget*>()) {
            if (!child->isVisible() || child->isWindow())
                continue;
            const QRect place(child->mapTo(&timeline(), QPoint()), child->size());
            QVERIFY2(timeline().rect().contains(place), qPrintable(child->objectName()));
            if (!qobject_cast<const Scrubber*>(child))
                QVERIFY2(
                    child->width() >= child->minimumSizeHint().width(),
                    qPrintable(QStringLiteral("%1 %2").arg(child->metaObject()->className()).arg(width)));
        }
        QVERIFY(scrubber().height() >= scrubber().minimumSizeHint().height());
    }
}

CLOTHLAB_GUI_TEST_MAIN(TestTimeline)
#include "tst_timeline.moc"
