// Also run under ThreadSanitizer, to which a write that is not seen in the next phase is a race.
#include "simcore/base/worker_team.h"

#include <QtTest>

#include <sys/resource.h>

#include <numeric>
#include <optional>

using namespace clothlab;

namespace {

// Processor time of all threads of this program, in ms.
double processorTime() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto milliseconds = [](const timeval& t) {
        return 1000.0 * double(t.tv_sec) + double(t.tv_usec) / 1000;
    };
    return milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
}

double processorTimeAsleep() {
    const double before = processorTime();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    return processorTime() - before;
}

constexpr double kNothing = 5; // ms, that falling asleep may take

} // namespace

class TestWorkerTeam : public QObject {
    Q_OBJECT

private slots:
    void eachMemberRunsOncePerRun_data() { sizes(); }
    void eachMemberRunsOncePerRun();
    void runReturnsAfterAllAreDone();
    void whatIsWrittenBeforeABarrierIsSeenBehindIt_data() { sizes(); }
    void whatIsWrittenBeforeABarrierIsSeenBehindIt();
    void aBarrierHoldsTheFastForTheSlow();
    void thousandsOfShortRuns_data() { sizes(); }
    void thousandsOfShortRuns();
    void endsAtAnyTime_data() { sizes(); }
    void endsAtAnyTime();
    void aSleepingTeamTakesNoTime_data() { sizes(); }
    void aSleepingTeamTakesNoTime();

private:
    void sizes() {
        QTest::addColumn<int>("members");
        for (const int members : {1, 2, 3, 8})
            QTest::addRow("%d", members) << members;
    }
};

// Plain counters: run() alone has to make them visible here.
void TestWorkerTeam::eachMemberRunsOncePerRun() {
    QFETCH(int, members);
    WorkerTeam team(members);
    QCOMPARE(team.members(), members);
    std::vector<int> times(std::size_t(members), 0);
    std::vector<std::thread::id> threads(times.size());
    for (int run = 1; run <= 100; ++run) {
        team.run([&](int member) {
            ++times.at(std::size_t(member));
            threads.at(std::size_t(member)) = std::this_thread::get_id();
        });
        QCOMPARE(times, std::vector<int>(times.size(), run));
        QVERIFY(threads[0] == std::this_thread::get_id());
        std::vector<std::thread::id> others = threads;
        std::ranges::sort(others);
        QVERIFY(std::ranges::adjacent_find(others) == others.end());
    }
}

void TestWorkerTeam::runReturnsAfterAllAreDone() {
    WorkerTeam team(3);
    for (int late = 0; late < 3; ++late) {
        std::vector<int> done(3, 0);
        team.run([&](int member) {
            if (member == late)
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
            done[std::size_t(member)] = 1;
        });
        QCOMPARE(done, std::vector<int>(3, 1));
    }
}

// Each adds up what all wrote in the round before. The two sides take turns, so one barrier a round is
// enough.
void TestWorkerTeam::whatIsWrittenBeforeABarrierIsSeenBehindIt() {
    QFETCH(int, members);
    constexpr int kRounds = 1000;
    WorkerTeam team(members);
    Barrier barrier(members);
    const auto size = std::size_t(members);
    std::array<std::vector<long>, 2> written{std::vector<long>(size, 0), std::vector<long>(size, 0)};
    std::vector<int> wrong(size, 0);
    team.run([&](int member) {
        for (int round = 0; round < kRounds; ++round) {
            std::vector<long>& side = written[std::size_t(round % 2)];
            side[std::size_t(member)] = round + member;
            barrier.wait();
            const long sum = std::accumulate(side.begin(), side.end(), 0L);
            const long expected = long(members) * round + long(members) * (members - 1) / 2;
            wrong[std::size_t(member)] += sum != expected ? 1 : 0;
        }
    });
    QCOMPARE(wrong, std::vector<int>(size, 0));
}

// Longer than anybody spins, so that the others give up their turn again and again.
void TestWorkerTeam::aBarrierHoldsTheFastForTheSlow() {
    WorkerTeam team(3);
    Barrier barrier(3);
    std::atomic<int> arrived = 0;
    std::atomic<int> tooEarly = 0;
    team.run([&](int member) {
        for (int round = 0; round < 6; ++round) {
            if (round % 3 == member)
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
            ++arrived;
            barrier.wait();
            tooEarly += arrived < 3 * (round + 1) ? 1 : 0;
            barrier.wait();
        }
    });
    QCOMPARE(tooEarly.load(), 0);
}

void TestWorkerTeam::thousandsOfShortRuns() {
    QFETCH(int, members);
    constexpr int kRuns = 5000;
    WorkerTeam team(members);
    std::vector<int> times(std::size_t(members), 0);
    const std::function<void(int)> job = [&](int member) { ++times[std::size_t(member)]; };
    for (int run = 0; run < kRuns; ++run)
        team.run(job);
    QCOMPARE(times, std::vector<int>(times.size(), kRuns));
}

// Before its threads have begun to wait, and right after they have worked.
void TestWorkerTeam::endsAtAnyTime() {
    QFETCH(int, members);
    for (int n = 0; n < 100; ++n) {
        const WorkerTeam unused(members);
    }
    std::atomic<int> times = 0;
    for (int n = 0; n < 100; ++n) {
        WorkerTeam team(members);
        for (int run = 0; run < n % 3 + 1; ++run)
            team.run([&](int) { ++times; });
    }
    QCOMPARE(times.load(), members * (34 * 1 + 33 * 2 + 33 * 3));
}

void TestWorkerTeam::aSleepingTeamTakesNoTime() {
    QFETCH(int, members);
    WorkerTeam team(members);
    std::this_thread::sleep_for(std::chrono::milliseconds(50)); // its threads have begun to wait
    const double unused = processorTimeAsleep();
    QVERIFY2(unused < kNothing, qPrintable(QString("%1 ms before the first run").arg(unused)));
    team.run([](int) {});
    const double after = processorTimeAsleep();
    QVERIFY2(after < kNothing, qPrintable(QString("%1 ms after a run").arg(after)));
}

QTEST_APPLESS_MAIN(TestWorkerTeam)
#include "tst_worker_team.moc"
