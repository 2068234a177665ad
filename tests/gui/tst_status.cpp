// The status bar and the Output panel: what is said is true, and stays.
#include "tests/gui/test_window.h"

#include "app/window/status_line.h"

#include <QDialog>
#include <QRegularExpression>
#include <QTextBrowser>

using namespace clothlab;

class TestStatus : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void itShowsFrameTimeSizeAndMemory();
    void itFollowsEveryFrame();
    void itFollowsTheSheet();
    void itIsTrueWhenTheRecordingBecomesShorter();
    void whatIsSaidStaysInOutput();
    void everyActionWithKeysIsInTheListOfKeys();
    void noTwoActionsShareAKey();

private:
    QStringList parts() {
        return (*m_window)->findChild<StatusLine*>()->text().simplified().split(QStringLiteral(" · "));
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestStatus::init() {
    m_window = std::make_unique<TestWindow>();
    QVERIFY(m_window->load(smallScene()));
}

void TestStatus::itShowsFrameTimeSizeAndMemory() {
    QVERIFY(m_window->simulateTo(45));
    const QStringList shown = parts();
    QCOMPARE(shown.size(), 6);
    QCOMPARE(shown[0], QStringLiteral("frame 45"));
    QCOMPARE(shown[1], QStringLiteral("0.500 s")); // 45 of 90 a second
    QCOMPARE(shown[2], QString::number(m_window->simulation().shownFrame()->milliseconds, 'f', 1) +
                           QStringLiteral(" ms/frame"));
    QCOMPARE(shown[3], QStringLiteral("36 points"));
    QCOMPARE(shown[4], QStringLiteral("158 springs"));
    // 46 frames of 36 points, six numbers of 8 bytes each, and a little more.
    const double kibibytes = shown[5].section(' ', 0, 0).toDouble();
    QVERIFY2(shown[5].endsWith("KiB") && kibibytes > 46 * 36 * 48 / 1024.0 && kibibytes < 100,
             qPrintable(shown[5]));
}

void TestStatus::itFollowsEveryFrame() {
    QVERIFY(m_window->simulateTo(3));
    for (const int frame : {0, 2, 1, 3}) {
        m_window->simulation().showFrame(frame);
        QCOMPARE(parts()[0], QStringLiteral("frame %1").arg(frame));
    }
    m_window->simulation().showFrame(0);
    QCOMPARE(parts()[2], QStringLiteral("start"));
}

void TestStatus::itFollowsTheSheet() {
    m_window->typeInto(m_window->field("cloth.num_height_points"), "40");
    m_window->key(Qt::Key_Return);
    QCOMPARE(parts()[3], QStringLiteral("240 points"));
    m_window->document().newScene();
    QCOMPARE(parts()[3].remove(QChar(0x202F)).remove(' '), QStringLiteral("2500points"));
}

// Whoever listens to the recording finds a frame in it that is shown, at every moment.
void TestStatus::itIsTrueWhenTheRecordingBecomesShorter() {
    Simulation& simulation = m_window->simulation();
    bool inside = true;
    connect(&simulation, &Simulation::recordingChanged, this,
            [&] { inside &= simulation.currentFrame() < simulation.recording().frameCount(); });
    connect(&simulation, &Simulation::notice, this,
            [&] { inside &= simulation.currentFrame() < simulation.recording().frameCount(); });
    connect(&simulation, &Simulation::blowUpChanged, this,
            [&] { inside &= simulation.currentFrame() < simulation.recording().frameCount(); });
    QVERIFY(m_window->simulateTo(9));
    m_window->key(Qt::Key_R);
    QVERIFY(inside);
    QCOMPARE(parts()[0], QStringLiteral("frame 0"));

    QVERIFY(m_window->simulateTo(9));
    simulation.showFrame(2);
    m_window->typeInto(m_window->field("cloth.ks"), "900");
    m_window->key(Qt::Key_Return);
    simulation.showFrame(9); // stale
    m_window->key(Qt::Key_Space);
    m_window->key(Qt::Key_Space);
    QVERIFY(inside);
    disconnect(&simulation, nullptr, this, nullptr);
}

void TestStatus::whatIsSaidStaysInOutput() {
    (*m_window)->say("first line\nsecond line");
    QCOMPARE((*m_window)->statusBar()->currentMessage(), QStringLiteral("first line"));
    (*m_window)->showProblem("something went wrong");
    QCOMPARE((*m_window)->messageBar().text(), QStringLiteral("something went wrong"));
    for (const char* text : {"first line", "second line", "something went wrong"})
        QVERIFY(m_window->output().contains(text));
    // With the time.
    QVERIFY(QRegularExpression(R"(\d\d:\d\d:\d\d  first line)").match(m_window->output()).hasMatch());
}

void TestStatus::everyActionWithKeysIsInTheListOfKeys() {
    m_window->key(Qt::Key_F1);
    auto* dialog = (*m_window)->findChild<QDialog*>();
    auto* text = dialog ? dialog->findChild<QTextBrowser*>() : nullptr;
    QVERIFY(text && text->isVisible());
    const QString keys = text->toPlainText();
    int listed = 0;
    for (const QAction* action : (*m_window)->QWidget::actions())
        for (const QKeySequence& key : action->shortcuts()) {
            QVERIFY2(keys.contains(key.toString(QKeySequence::NativeText)), qPrintable(action->text()));
            ++listed;
        }
    QVERIFY(listed > 30);
    for (const char* key : {"Space", "Ctrl+Z", "Ctrl+Shift+Z", "Home"})
        QVERIFY2(keys.contains(key), key);
}

void TestStatus::noTwoActionsShareAKey() {
    QStringList seen;
    for (const QAction* action : (*m_window)->QWidget::actions())
        for (const QKeySequence& key : action->shortcuts()) {
            QVERIFY2(!seen.contains(key.toString()), qPrintable(key.toString()));
            seen << key.toString();
        }
    QVERIFY(seen.size() > 25);
}

CLOTHLAB_GUI_TEST_MAIN(TestStatus)
#include "tst_status.moc"
