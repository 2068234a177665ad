// What is left when the program is killed at any moment, while it records and while it saves. The test runs
// itself as the program to be killed.
#include "test_window.h"

#include "simcore/recording/take_file.h"

#include <QElapsedTimer>
#include <QProcess>

#include <fcntl.h>
#include <random>
#include <unistd.h>

using namespace clothlab;

namespace {

constexpr int kMostLost = 1000; // ms of recording

// Says how many frames are recorded, and when, in a way that survives being killed.
void tell(int fd, const QElapsedTimer& clock, int frames) {
    const QByteArray line = QByteArray::number(clock.msecsSinceReference() + clock.elapsed()) + ' ' +
                            QByteArray::number(frames) + '\n';
    if (write(fd, line.constData(), std::size_t(line.size())) != line.size())
        qFatal("the log cannot be written");
}

// Plays, and saves again and again if told to, until it is killed.
int recordUntilKilled(const QString& folder, bool saving) {
    MainWindow window(std::make_unique<QSettings>(folder + "/settings.ini", QSettings::IniFormat), {},
                      folder + "/recovery");
    window.show();
    window.document().setScene(smallScene(), {});
    const int log = open(qPrintable(folder + "/log"), O_WRONLY | O_CREAT | O_APPEND, 0600);
    QElapsedTimer clock;
    clock.start();
    Simulation& simulation = window.simulation();
    QObject::connect(&simulation, &Simulation::frameShown, &window,
                     [&] { tell(log, clock, simulation.recording().frameCount()); });
    simulation.play();
    if (!saving)
        return QApplication::exec();
    while (true)
        window.files().saveTo(folder + "/run.clothtake");
}

// Frames that were recorded a second before the last thing that was heard.
int framesToExpect(const QByteArray& log) {
    const QByteArrayList lines = log.split('\n');
    qint64 last = 0;
    for (const QByteArray& line : lines)
        if (line.contains(' '))
            last = std::max(last, line.split(' ')[0].toLongLong());
    int frames = 1;
    for (qsizetype i = 0; i + 1 < lines.size(); ++i) // the last may be cut off
        if (const QByteArrayList words = lines[i].split(' '); words[0].toLongLong() <= last - kMostLost)
            frames = words[1].toInt();
    return frames;
}

} // namespace

class TestCrash : public QObject {
    Q_OBJECT
private slots:
    void whatWasRecordedIsOffered_data() {
        QTest::addColumn<bool>("saving");
        QTest::newRow("while it records") << false;
        QTest::newRow("while it saves") << true;
    }
    void whatWasRecordedIsOffered() {
        QFETCH(bool, saving);
        std::mt19937 random(saving ? 5 : 3);
        const int times = qEnvironmentVariableIsSet("CLOTHLAB_LONG") ? 100 : 5;
        for (int i = 0; i < times; ++i) {
            killOnce(saving, int(random() % 2500));
            if (QTest::currentTestFailed())
                return;
        }
    }

private:
    static void killOnce(bool saving, int after) {
        const QTemporaryDir folder;
        QProcess program;
        program.setProcessChannelMode(QProcess::ForwardedChannels);
        program.start(QApplication::applicationFilePath(),
                      {"--record-until-killed", folder.path(), saving ? "saving" : "recording"});
        QVERIFY(program.waitForStarted(kPatience));
        QFile log(folder.filePath("log"));
        TRY_VERIFY(log.size() > 0 && program.state() == QProcess::Running);
        QTest::qWait(after);
        program.kill();
        QVERIFY(program.waitForFinished(kPatience));
        QVERIFY(log.open(QIODevice::ReadOnly));
        const int expected = framesToExpect(log.readAll());

        const QString saved = folder.filePath("run.clothtake");
        if (QFile::exists(saved)) {
            const TakeFileReading reading = readTakeFile(saved.toStdString());
            QVERIFY(reading.contents && reading.finished && reading.diagnostics.empty());
        }
        MainWindow window(std::make_unique<QSettings>(folder.filePath("settings.ini"), QSettings::IniFormat),
                          {}, folder.filePath("recovery"));
        window.show();
        // Opening a scene, as the command line does, must not hide what is offered.
        window.document().setScene(Scene{}, {});
        if (expected == 1 && window.messageBar().text().isEmpty())
            return; // killed before there was anything to lose
        auto* open = window.findChild<QAction*>("openRecovered");
        QVERIFY2(open, qPrintable(QString::number(expected)));
        open->trigger();
        const Recording& recording = window.simulation().recording();
        QVERIFY2(recording.frameCount() >= expected,
                 qPrintable(QString("%1 of %2").arg(recording.frameCount()).arg(expected)));
        QCOMPARE(window.document().scene(), smallScene());
        QVERIFY(window.document().isModified());
        window.simulation().showFrame(recording.lastFrame());
        TRY_VERIFY(window.simulation().shownFrame()->exact);
        QCOMPARE(stateHash(window.simulation().shownFrame()->state),
                 factsOf(*recording.take(), recording.lastFrame())->stateHash);
        // Once it is in the journal of this window, the old one goes.
        TRY_COMPARE(QDir(folder.filePath("recovery")).entryList({"*.clothtake"}).size(), 1);
    }
};

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--record-until-killed")
        return recordUntilKilled(arguments.value(2), arguments.value(3) == "saving");
    TestCrash test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_crash.moc"
