// No step is ever taken on the GUI thread, and what the user does never waits for one.
#include "tests/gui/test_window.h"

#include <QElapsedTimer>
#include <QTimer>

#include <thread>

using namespace clothlab;

class TestThreads : public QObject {
    Q_OBJECT

private slots:
    void init() { m_window = std::make_unique<TestWindow>(); }
    void cleanup() { m_window.reset(); }

    void noFrameIsEverComputedOnTheGuiThread();
    void eventsAreHandledWhileAFrameIsComputed();
    void pauseActsAtOnceAndNothingIsRecordedAfterIt();
    void pauseActsWithinAFrameWhilePlaying();
    void editsResetsAndFilesDoNotWaitForAFrame();
    void closingDoesNotWaitForAFrame();

private:
    Simulation& simulation() { return m_window->simulation(); }
    bool loadSlowScene();
    bool waitUntilTheWorkerIsIdle();

    std::unique_ptr<TestWindow> m_window;
};

namespace {

// One frame of this takes minutes.
Scene slowScene() {
    Scene scene;
    scene.cloth.numWidthPoints = 300;
    scene.cloth.numHeightPoints = 300;
    scene.cloth.pinned = {{0, 0}, {299, 0}};
    scene.cloth.ks = 50;
    scene.simulation.stepsPerFrame = 20000;
    return scene;
}

// Longer than a busy machine needs for what is done at once, and much shorter than a frame of the slow scene.
constexpr qint64 kAtOnce = 3000; // ms

} // namespace

bool TestThreads::loadSlowScene() {
    return m_window->load(slowScene());
}

// A frame of one step comes back only after whatever was under way before it, which must not be recorded.
bool TestThreads::waitUntilTheWorkerIsIdle() {
    const int before = m_window->frameCount();
    if (m_window->document().setParameter(*findParameter("simulation.steps_per_frame"), 1))
        return false;
    simulation().simulateFrame();
    return QTest::qWaitFor([&] { return m_window->frameCount() > before; }, kPatience) &&
           simulation().recording().frame(before).scene->simulation.stepsPerFrame == 1;
}

void TestThreads::noFrameIsEverComputedOnTheGuiThread() {
    QVERIFY(m_window->load(smallScene()));
    int frames = 0;
    bool elsewhere = true;
    connect(&simulation(), &Simulation::recordingChanged, this, [&] {
        if (m_window->frameCount() <= 1)
            return;
        ++frames;
        elsewhere &= simulation().lastComputedOn() != std::thread::id() &&
                     simulation().lastComputedOn() != std::this_thread::get_id();
    });
    // By every way that leads to a frame: playing, single frames, playing on after an edit.
    m_window->key(Qt::Key_Space);
    TRY_VERIFY(m_window->frameCount() > 20);
    m_window->key(Qt::Key_N);
    TRY_VERIFY(!simulation().isSimulating());
    m_window->typeInto(m_window->field("cloth.ks"), "900");
    m_window->key(Qt::Key_Return);
    m_window->click(&m_window->viewport(), {12, 12});
    const int before = m_window->frameCount();
    m_window->key(Qt::Key_Space);
    TRY_VERIFY(m_window->frameCount() > before + 5);
    m_window->key(Qt::Key_R);
    m_window->key(Qt::Key_N);
    TRY_COMPARE(m_window->frameCount(), 2);
    disconnect(&simulation(), nullptr, this, nullptr);
    QVERIFY(frames > 25);
    QVERIFY(elsewhere);
}

void TestThreads::eventsAreHandledWhileAFrameIsComputed() {
    QVERIFY(loadSlowScene());
    m_window->key(Qt::Key_N);
    QVERIFY(simulation().isSimulating());
    int ticks = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] { ++ticks; });
    timer.start(1);
    TRY_VERIFY(ticks > 100);
    QVERIFY(simulation().isSimulating());
    QCOMPARE(m_window->frameCount(), 1);
    // The window does what it is told meanwhile.
    m_window->key(Qt::Key_7);
    QCOMPARE(m_window->viewport().camera().view.elevation, 90.0);
    QVERIFY(simulation().isSimulating());
}

void TestThreads::pauseActsAtOnceAndNothingIsRecordedAfterIt() {
    QVERIFY(loadSlowScene());
    m_window->key(Qt::Key_Space);
    QVERIFY(simulation().isPlaying() && simulation().isSimulating());
    QElapsedTimer clock;
    clock.start();
    m_window->key(Qt::Key_Space);
    QVERIFY2(clock.elapsed() < kAtOnce, QByteArray::number(clock.elapsed()));
    QVERIFY(!simulation().isPlaying() && !simulation().isSimulating());
    QVERIFY(waitUntilTheWorkerIsIdle());
    QVERIFY2(clock.elapsed() < kPatience, "the frame under way was not abandoned");
    QCOMPARE(m_window->frameCount(), 2);
    QCOMPARE(simulation().recording().frame(1).scene->simulation.stepsPerFrame, 1);
}

void TestThreads::pauseActsWithinAFrameWhilePlaying() {
    QVERIFY(m_window->load(smallScene()));
    for (int round = 0; round < 10; ++round) {
        m_window->key(Qt::Key_Space);
        const int begin = m_window->frameCount();
        TRY_VERIFY(m_window->frameCount() > begin + 2);
        m_window->key(Qt::Key_P);
        QVERIFY(!simulation().isPlaying());
        const int count = m_window->frameCount();
        const int frame = m_window->frame();
        QVERIFY(waitUntilTheWorkerIsIdle());
        QCOMPARE(m_window->frameCount(), count + 1);
        QCOMPARE(m_window->frame(), frame + 1);
        m_window->key(Qt::Key_Z, Qt::ControlModifier);
    }
}

void TestThreads::editsResetsAndFilesDoNotWaitForAFrame() {
    QVERIFY(loadSlowScene());
    const QString other = m_window->write("other.json", smallScene());
    QElapsedTimer clock;
    const auto takes = [&](auto&& action) {
        m_window->key(Qt::Key_N);
        if (!simulation().isSimulating())
            return kPatience + 0LL;
        clock.start();
        action();
        return clock.elapsed();
    };
    QVERIFY(takes([&] { m_window->document().setParameter(*findParameter("cloth.ks"), 60); }) < kAtOnce);
    QVERIFY(takes([&] { m_window->key(Qt::Key_R); }) < kAtOnce);
    QVERIFY(takes([&] { m_window->document().setParameter(*findParameter("cloth.width"), 2); }) < kAtOnce);
    QVERIFY(takes([&] { m_window->key(Qt::Key_Z, Qt::ControlModifier); }) < kAtOnce);
    QVERIFY(takes([&] { m_window->document().open(other); }) < kAtOnce);
    QVERIFY(!simulation().isSimulating());
    // And the worker is free for the new scene.
    m_window->key(Qt::Key_N);
    TRY_COMPARE(m_window->frameCount(), 2);
}

void TestThreads::closingDoesNotWaitForAFrame() {
    QVERIFY(loadSlowScene());
    m_window->key(Qt::Key_Space);
    QVERIFY(simulation().isSimulating());
    QElapsedTimer clock;
    clock.start();
    QVERIFY((*m_window)->close());
    m_window.reset();
    QVERIFY2(clock.elapsed() < kAtOnce, QByteArray::number(clock.elapsed()));
}

CLOTHLAB_GUI_TEST_MAIN(TestThreads)
#include "tst_threads.moc"
