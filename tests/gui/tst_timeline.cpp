// Playing by keys and selectors, scrubbing, and typed frames and times of the timeline.
#include "tests/gui/timeline_window.h"

#include <QSet>

using namespace clothlab;

class TestTimeline : public QObject {
    Q_OBJECT

private slots:
    void init() { m_window = std::make_unique<TimelineWindow>(); }
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
    void aTypedTimeShowsTheNearestFrame();
    void nothingIsCutOffInHalfAWindow();

private:
    TimelinePanel& timeline() { return m_window->timeline(); }
    Scrubber& scrubber() { return m_window->scrubber(); }
    Simulation& simulation() { return m_window->simulation(); }
    Actions& actions() { return m_window->actions(); }

    std::unique_ptr<TimelineWindow> m_window;
};

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
    QCOMPARE(m_window->choice("playbackSpeed")->currentText(), QString::fromUtf8("1/8×"));
}

void TestTimeline::selectorsAndActionsShowTheSameSettings() {
    m_window->choose("playbackSpeed", QString::fromUtf8("4×"));
    m_window->choose("playbackPace", "Real time");
    m_window->choose("playbackRepeat", "Ping-pong");
    QCOMPARE(simulation().playback(), (PlaybackSettings{4, true, Repeat::PingPong}));
    QVERIFY(actions().loop->isChecked());
    m_window->key(Qt::Key_L);
    QCOMPARE(m_window->choice("playbackRepeat")->currentText(), QStringLiteral("Once"));
    m_window->key(Qt::Key_L);
    QCOMPARE(m_window->choice("playbackRepeat")->currentText(), QStringLiteral("Loop"));
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
        m_window->choose("playbackPace", realTime ? "Real time" : "Every frame");
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
    m_window->choose("playbackRepeat", "Ping-pong");
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
    m_window->choose("playbackPace", "Real time");
    m_window->choose("playbackSpeed", QString::fromUtf8("8×"));
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
    m_window->drag(&scrubber(), m_window->onBar(4), m_window->onBar(20));
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
    send(QEvent::MouseButtonPress, m_window->onBar(0), Qt::LeftButton);
    QCOMPARE(shown, QList<int>{0});
    for (int i = 1; i <= 100; ++i)
        send(QEvent::MouseMove, m_window->onBar(i % 61), Qt::NoButton);
    QApplication::processEvents();
    QCOMPARE(m_window->frame(), 100 % 61);
    QCOMPARE(shown, (QList<int>{0, 100 % 61}));
    send(QEvent::MouseMove, m_window->onBar(50), Qt::NoButton);
    send(QEvent::MouseButtonRelease, m_window->onBar(50), Qt::LeftButton); // does not wait for anything
    QCOMPARE(m_window->frame(), 50);
    QTest::qWait(50);
    QCOMPARE(shown, (QList<int>{0, 100 % 61, 50}));
    disconnect(&simulation(), nullptr, this, nullptr);
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

void TestTimeline::nothingIsCutOffInHalfAWindow() {
    (*m_window)->dock("timeline")->setFloating(true);
    for (const int width : {1280, 720, 640, 480}) {
        (*m_window)->dock("timeline")->resize(width, 200);
        QApplication::processEvents();
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
