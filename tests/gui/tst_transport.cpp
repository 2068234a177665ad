// Playing, stepping and scrubbing by keys, buttons and the timeline.
#include "tests/gui/test_window.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QTextEdit>

using namespace clothlab;

class TestTransport : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void spaceAndPPlayAndPause();
    void spacePlaysWhateverHasTheFocus();
    void pPlaysWhateverHasTheFocusButAFieldThatTakesText();
    void nSimulatesOneFrameMore();
    void keysGoThroughTheRecording();
    void keysAtTheEndsOfTheRecordingDoNothing();
    void rBeginsANewRecording();
    void homeResetsTheCamera();
    void buttonsOfTheTimelineDoAsTheKeys();
    void aClickOnTheScrubberShowsThatFrame();
    void aDragOnTheScrubberShowsEveryFrameOnTheWay();
    void aTypedFrameIsShown();
    void aTypedFrameBeyondTheRecordingIsRefusedInWords();
    void playingShowsWhatIsRecordedAndThenSimulatesOn();
    void anEditBeforeTheEndMakesLaterFramesStaleUntilItIsUndone();
    void playingReplacesStaleFrames();
    void anotherSheetBeginsANewRecording();
    void aBlowUpStopsAndIsToldInWords();

private:
    TimelinePanel& timeline() { return (*m_window)->timelinePanel(); }
    QPoint onScrubber(double frame) {
        Scrubber* scrubber = timeline().scrubber();
        return {qRound(scrubber->positionOf(frame)), scrubber->height() - 12};
    }
    QList<QWidget*> focusable();

    std::unique_ptr<TestWindow> m_window;
};

void TestTransport::init() {
    m_window = std::make_unique<TestWindow>();
    QVERIFY(m_window->load(smallScene()));
}

// Every widget of the window that Tab or a click can give the focus to.
QList<QWidget*> TestTransport::focusable() {
    QList<QWidget*> found;
    for (QWidget* widget : (*m_window)->findChildren<QWidget*>())
        if (widget->focusPolicy() != Qt::NoFocus && widget->isVisible() && widget->isEnabled() &&
            !widget->focusProxy())
            found << widget;
    return found;
}

void TestTransport::spaceAndPPlayAndPause() {
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_P}) {
        m_window->key(key);
        QVERIFY(m_window->simulation().isPlaying());
        QCOMPARE((*m_window)->actions().playPause->text(), QStringLiteral("Pause"));
        m_window->key(key);
        QVERIFY(!m_window->simulation().isPlaying());
        QCOMPARE((*m_window)->actions().playPause->text(), QStringLiteral("Play"));
    }
}

void TestTransport::spacePlaysWhateverHasTheFocus() {
    (*m_window)->dock("output")->raise();
    const Scene before = m_window->scene();
    const QList<QWidget*> widgets = focusable();
    QVERIFY(widgets.size() > 30);
    for (QWidget* widget : widgets) {
        widget->setFocus();
        if (!widget->hasFocus()) // hidden by a fold, or behind a tab
            continue;
        const QByteArray name = widget->metaObject()->className() + (' ' + widget->accessibleName().toUtf8());
        m_window->key(Qt::Key_Space);
        QVERIFY2(m_window->simulation().isPlaying(), name);
        m_window->key(Qt::Key_Space);
        QVERIFY2(!m_window->simulation().isPlaying(), name);
        QVERIFY2(m_window->scene() == before, name);
        QVERIFY2(!QApplication::activePopupWidget(), name);
    }
}

void TestTransport::pPlaysWhateverHasTheFocusButAFieldThatTakesText() {
    (*m_window)->dock("output")->raise();
    const Scene before = m_window->scene();
    int tried = 0;
    for (QWidget* widget : focusable()) {
        widget->setFocus();
        if (!widget->hasFocus() || qobject_cast<QLineEdit*>(widget))
            continue;
        const QByteArray name = widget->metaObject()->className() + (' ' + widget->accessibleName().toUtf8());
        m_window->key(Qt::Key_P);
        QVERIFY2(m_window->simulation().isPlaying(), name);
        m_window->key(Qt::Key_P);
        QVERIFY2(!m_window->simulation().isPlaying(), name);
        QVERIFY2(m_window->scene() == before, name);
        ++tried;
    }
    QVERIFY(tried > 15);

    NumberField* field = m_window->field("cloth.ks");
    m_window->typeInto(field, "2*pi");
    QCOMPARE(field->text(), QStringLiteral("2*pi"));
    QVERIFY(!m_window->simulation().isPlaying());
}

void TestTransport::nSimulatesOneFrameMore() {
    m_window->key(Qt::Key_N);
    TRY_COMPARE(m_window->frameCount(), 2);
    QCOMPARE(m_window->frame(), 1);
    m_window->key(Qt::Key_Period);
    TRY_COMPARE(m_window->frameCount(), 3);
    // From anywhere it goes on after the last.
    m_window->key(Qt::Key_Home, Qt::ControlModifier);
    QCOMPARE(m_window->frame(), 0);
    m_window->key(Qt::Key_N);
    TRY_COMPARE(m_window->frame(), 3);
    QCOMPARE(m_window->frameCount(), 4);
}

void TestTransport::keysGoThroughTheRecording() {
    QVERIFY(m_window->simulateTo(25));
    const auto after = [this](Qt::Key key, Qt::KeyboardModifiers modifiers) {
        m_window->key(key, modifiers);
        return m_window->frame();
    };
    QCOMPARE(after(Qt::Key_Left, Qt::NoModifier), 24);
    QCOMPARE(after(Qt::Key_Left, Qt::ShiftModifier), 14);
    QCOMPARE(after(Qt::Key_Right, Qt::NoModifier), 15);
    QCOMPARE(after(Qt::Key_Right, Qt::ShiftModifier), 25);
    QCOMPARE(after(Qt::Key_Home, Qt::ControlModifier), 0);
    QCOMPARE(after(Qt::Key_Right, Qt::ShiftModifier), 10);
    QCOMPARE(after(Qt::Key_End, Qt::ControlModifier), 25);
    QCOMPARE(m_window->frameCount(), 26);
    QCOMPARE(timeline().frameField()->value(), 25.0);
}

void TestTransport::keysAtTheEndsOfTheRecordingDoNothing() {
    QVERIFY(m_window->simulateTo(3));
    const Scene before = m_window->scene();
    for (QWidget* widget : focusable()) {
        if (qobject_cast<QLineEdit*>(widget) || qobject_cast<QTextEdit*>(widget))
            continue;
        widget->setFocus();
        m_window->simulation().showFrame(0);
        m_window->key(Qt::Key_Left);
        QCOMPARE(m_window->frame(), 0);
        m_window->simulation().showFrame(3);
        m_window->key(Qt::Key_Right);
        QCOMPARE(m_window->frame(), 3);
        QVERIFY2(m_window->scene() == before, widget->metaObject()->className());
    }
}

void TestTransport::rBeginsANewRecording() {
    QVERIFY(m_window->simulateTo(5));
    m_window->key(Qt::Key_R);
    QCOMPARE(m_window->frame(), 0);
    QCOMPARE(m_window->frameCount(), 1);
    QVERIFY(!m_window->simulation().isPlaying());
    // While it plays, too.
    m_window->key(Qt::Key_Space);
    TRY_VERIFY(m_window->frameCount() > 3);
    m_window->key(Qt::Key_R);
    QCOMPARE(m_window->frameCount(), 1);
    QVERIFY(!m_window->simulation().isPlaying());
}

void TestTransport::homeResetsTheCamera() {
    const CameraView home = m_window->viewport().camera().view;
    m_window->key(Qt::Key_7);
    QVERIFY(m_window->viewport().camera().view != home);
    m_window->key(Qt::Key_Home);
    QVERIFY(m_window->viewport().camera().view == home);
}

void TestTransport::buttonsOfTheTimelineDoAsTheKeys() {
    QVERIFY(m_window->simulateTo(4));
    Actions& actions = (*m_window)->actions();
    const auto click = [&](QAction* action) { m_window->click(action, &timeline()); };
    click(actions.stepBack);
    QCOMPARE(m_window->frame(), 3);
    click(actions.stepForward);
    QCOMPARE(m_window->frame(), 4);
    click(actions.firstFrame);
    QCOMPARE(m_window->frame(), 0);
    QVERIFY(!actions.stepBack->isEnabled());
    click(actions.lastFrame);
    QCOMPARE(m_window->frame(), 4);
    QVERIFY(!actions.stepForward->isEnabled());
    click(actions.simulateFrame);
    TRY_COMPARE(m_window->frame(), 5);
    click(actions.playPause);
    QVERIFY(m_window->simulation().isPlaying());
    click(actions.playPause);
    QVERIFY(!m_window->simulation().isPlaying());
    click(actions.restart);
    QCOMPARE(m_window->frameCount(), 1);
}

void TestTransport::aClickOnTheScrubberShowsThatFrame() {
    QVERIFY(m_window->simulateTo(30));
    for (const int frame : {7, 0, 30, 19}) {
        m_window->click(timeline().scrubber(), onScrubber(frame));
        QCOMPARE(m_window->frame(), frame);
    }
    // Beyond what is recorded there is only the last frame.
    m_window->click(timeline().scrubber(), onScrubber(80));
    QCOMPARE(m_window->frame(), 30);
}

void TestTransport::aDragOnTheScrubberShowsEveryFrameOnTheWay() {
    QVERIFY(m_window->simulateTo(30));
    QList<int> shown;
    connect(&m_window->simulation(), &Simulation::frameShown, this, [&] { shown << m_window->frame(); });
    m_window->drag(timeline().scrubber(), onScrubber(4), onScrubber(20));
    QCOMPARE(m_window->frame(), 20);
    QVERIFY(shown.contains(4) && shown.contains(8) && shown.contains(12) && shown.contains(16));
    disconnect(&m_window->simulation(), nullptr, this, nullptr);
}

void TestTransport::aTypedFrameIsShown() {
    QVERIFY(m_window->simulateTo(12));
    m_window->typeInto(timeline().frameField(), "5");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->frame(), 5);
    m_window->click(timeline().frameField());
    m_window->key(Qt::Key_Up);
    QCOMPARE(m_window->frame(), 6);
}

void TestTransport::aTypedFrameBeyondTheRecordingIsRefusedInWords() {
    QVERIFY(m_window->simulateTo(12));
    m_window->typeInto(timeline().frameField(), "13");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->frame(), 12);
    QVERIFY2(m_window->output().contains("from 0 to 12"), qPrintable(m_window->output()));
}

void TestTransport::playingShowsWhatIsRecordedAndThenSimulatesOn() {
    QVERIFY(m_window->simulateTo(5));
    m_window->key(Qt::Key_Home, Qt::ControlModifier);
    QList<int> shown;
    connect(&m_window->simulation(), &Simulation::frameShown, this, [&] { shown << m_window->frame(); });
    m_window->key(Qt::Key_Space);
    TRY_VERIFY(m_window->frameCount() > 8);
    m_window->key(Qt::Key_Space);
    disconnect(&m_window->simulation(), nullptr, this, nullptr);
    for (int i = 0; i < shown.size(); ++i)
        QCOMPARE(shown.at(i), i + 1);
}

void TestTransport::anEditBeforeTheEndMakesLaterFramesStaleUntilItIsUndone() {
    QVERIFY(m_window->simulateTo(10));
    m_window->simulation().showFrame(4);
    m_window->typeInto(m_window->field("cloth.ks"), "900");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->simulation().firstStaleFrame(), 5);
    QCOMPARE(m_window->frameCount(), 11);
    m_window->simulation().showFrame(8);
    QCOMPARE(timeline().stateText(), QStringLiteral("Stale"));
    QCOMPARE(m_window->viewport().overlay().badges().size(), std::size_t(1));
    QVERIFY(m_window->viewport().overlay().badges()[0].text.startsWith("Stale"));

    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_window->simulation().firstStaleFrame(), 11);
    QCOMPARE(timeline().stateText(), QStringLiteral("Paused"));
    QVERIFY(m_window->viewport().overlay().badges().empty());
}

void TestTransport::playingReplacesStaleFrames() {
    QVERIFY(m_window->simulateTo(10));
    m_window->simulation().showFrame(4);
    m_window->typeInto(m_window->field("cloth.ks"), "900");
    m_window->key(Qt::Key_Return);
    m_window->simulation().showFrame(8); // stale, and gone as soon as it plays
    QList<int> shown;
    connect(&m_window->simulation(), &Simulation::frameShown, this, [&] { shown << m_window->frame(); });
    m_window->key(Qt::Key_Space);
    TRY_COMPARE(m_window->simulation().recording().takes().size(), 2U); // of its own, which is shorter
    TRY_VERIFY(m_window->frameCount() > 7);
    m_window->key(Qt::Key_Space);
    disconnect(&m_window->simulation(), nullptr, this, nullptr);
    QCOMPARE(shown.mid(0, 3), (QList<int>{4, 5, 6}));
    const Recording& recording = m_window->simulation().recording();
    QCOMPARE(recording.frame(4).scene->cloth.ks, 5000.0);
    for (int i = 5; i < recording.frameCount(); ++i)
        QCOMPARE(recording.frame(i).scene->cloth.ks, 900.0);
    QVERIFY(m_window->output().contains("Take 2 begins at frame 4; Take 1 keeps the 6 frame"));
}

void TestTransport::anotherSheetBeginsANewRecording() {
    QVERIFY(m_window->simulateTo(10));
    m_window->typeInto(m_window->field("cloth.width"), "1.5");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->frameCount(), 1);
    QCOMPARE(m_window->frame(), 0);
    QVERIFY(m_window->output().contains("Take 1 keeps its frames"));
}

void TestTransport::aBlowUpStopsAndIsToldInWords() {
    Scene scene = smallScene();
    scene.cloth.ks = 1e9;
    scene.simulation.stepsPerFrame = 1;
    scene.simulation.framesPerSecond = 10;
    QVERIFY(m_window->load(scene));
    m_window->key(Qt::Key_Space);
    TRY_VERIFY(!m_window->simulation().blowUp().isEmpty());
    QVERIFY(!m_window->simulation().isPlaying());
    QVERIFY(m_window->output().contains(m_window->simulation().blowUp()));
    QVERIFY(m_window->viewport().overlay().badges()[0].text.contains(m_window->simulation().blowUp()));
    // Everything works as before.
    m_window->key(Qt::Key_R);
    QVERIFY(m_window->simulation().blowUp().isEmpty());
    QVERIFY(m_window->viewport().overlay().badges().empty());
}

CLOTHLAB_GUI_TEST_MAIN(TestTransport)
#include "tst_transport.moc"
