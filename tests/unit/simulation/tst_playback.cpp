#include "app/simulation/playback.h"

#include "tests/support/random.h"

#include <QTest>

#include <cmath>

using namespace clothlab;

namespace {

constexpr double kFrame = 1000.0 / 90; // ms

Playback::Played recorded(int frames, std::optional<InOutPoints> range = {}) {
    return {frames - 1, frames - 1, range, [](int frame) { return frame / 90.0; }, 1.0 / 90};
}

// Plays by a clock that calls when it is asked to, or late.
struct Player {
    Playback playback;
    Playback::Played played;
    double now = 1234; // ms
    int frame = 0;
    bool ended = false;
    bool records = false;
    std::vector<int> shown;
    std::vector<double> times;

    explicit Player(Playback::Played what) : played(std::move(what)) {}

    void set(double speed, bool realTime, Repeat repeat) {
        playback.setSettings({speed, realTime, repeat}, now);
    }
    bool begin(Direction direction, int from) {
        frame = from;
        const auto start = playback.begin(direction, from, played, now);
        if (!start)
            return false;
        if (*start != frame)
            show(*start);
        return true;
    }
    void show(int next) {
        frame = next;
        shown.push_back(frame);
        times.push_back(now);
    }
    double step() {
        const Playback::Step step = playback.step(frame, played, now);
        if (step.frame != frame)
            show(step.frame);
        ended = step.ended;
        records = step.records;
        return step.due;
    }
    // As many calls; each late by up to that many ms.
    void run(int calls, double mostLate = 0, SplitMix64* random = nullptr) {
        for (int i = 0; i < calls && !ended; ++i) {
            const double due = step();
            if (records) { // the worker takes no time
                now = std::max(now, due);
                ++played.lastFrame;
                played.endOfRun = played.lastFrame;
                continue;
            }
            now = std::max(now, due) + (random ? random->real(0, mostLate) : 0);
        }
    }
};

} // namespace

class TestPlayback : public QObject {
    Q_OBJECT
private slots:
    void everyFrameIsShownWhenItIsDue_data() {
        QTest::addColumn<double>("speed");
        for (const double speed : kSpeeds)
            QTest::addRow("%g", speed) << speed;
    }
    void everyFrameIsShownWhenItIsDue() {
        QFETCH(double, speed);
        for (const bool realTime : {false, true}) {
            Player player(recorded(50));
            player.set(speed, realTime, Repeat::Loop);
            QVERIFY(player.begin(Direction::Forward, 3));
            const double start = player.now;
            player.run(40);
            for (std::size_t i = 0; i < 40; ++i) {
                QCOMPARE(player.shown[i], 4 + int(i));
                QVERIFY(std::abs(player.times[i] - start - double(i) * kFrame / speed) < 0.6);
            }
        }
    }

    void timesOfFramesCountNotTheirNumbers() {
        Playback::Played changed = recorded(21);
        changed.time = [](int frame) { return frame < 10 ? frame / 90.0 : 9 / 90.0 + (frame - 9) / 10.0; };
        Player player(changed);
        player.set(2, true, Repeat::Loop);
        QVERIFY(player.begin(Direction::Forward, 0));
        const double start = player.now;
        player.run(20);
        for (std::size_t i = 0; i < player.shown.size() && player.shown[i] > 0; ++i) {
            const double at = (changed.time(player.shown[i]) - changed.time(1)) * 1000 / 2;
            QVERIFY2(std::abs(player.times[i] - start - at) < 0.6, qPrintable(QString::number(i)));
        }
    }

    // However late the clock is, in either direction, at any speed.
    void inRealTimeWhatIsShownIsTheFrameOfThatMoment() {
        SplitMix64 random(7);
        for (int round = 0; round < 400; ++round) {
            Player player(recorded(100'000));
            const double speed = kSpeeds[std::size_t(random.integer(0, 6))];
            const bool forward = random.integer(0, 1) == 1;
            player.set(speed, true, random.integer(0, 1) == 1 ? Repeat::Loop : Repeat::PingPong);
            const int from = 50'000;
            QVERIFY(player.begin(forward ? Direction::Forward : Direction::Backward, from));
            const double start = player.now;
            player.run(100, random.real(0, 200), &random);
            QVERIFY(player.shown.size() > 50);
            for (std::size_t i = 0; i < player.shown.size(); ++i) {
                const double moved = 1 + (player.times[i] - start) * speed / kFrame; // at once to the next
                const double off = std::abs(player.shown[i] - from) - moved;
                QVERIFY2(std::abs(off) <= 1 + 0.5 * speed / kFrame, qPrintable(QString::number(off)));
            }
        }
    }

    void everyFrameLeavesNoneOut() {
        SplitMix64 random(8);
        for (int round = 0; round < 200; ++round) {
            const int last = random.integer(1, 40);
            Player player(recorded(last + 1));
            const bool forward = random.integer(0, 1) == 1;
            const bool pingPong = random.integer(0, 1) == 1;
            player.set(kSpeeds[std::size_t(random.integer(0, 6))], false,
                       pingPong ? Repeat::PingPong : Repeat::Loop);
            QVERIFY(
                player.begin(forward ? Direction::Forward : Direction::Backward, random.integer(0, last)));
            player.run(150, 60, &random);
            for (std::size_t i = 1; i < player.shown.size(); ++i) {
                const int step = std::abs(player.shown[i] - player.shown[i - 1]);
                QVERIFY2(step == 1 || (!pingPong && step == last), qPrintable(QString::number(step)));
            }
            QVERIFY(player.shown.size() >= 149);
        }
    }

    void loopsStayInTheirRangeAndRecordNothing() {
        SplitMix64 random(9);
        for (int round = 0; round < 300; ++round) {
            const int last = random.integer(5, 60);
            const int in = random.integer(0, last - 1);
            const int out = random.integer(0, 3) == 0 ? kOpenEnd : random.integer(in + 1, last + 20);
            Player player(recorded(last + 1, InOutPoints{in, out}));
            player.played.endOfRun = random.integer(0, last); // what is stale is recorded, too
            player.set(kSpeeds[std::size_t(random.integer(0, 6))], random.integer(0, 1) == 1,
                       random.integer(0, 1) == 1 ? Repeat::Loop : Repeat::PingPong);
            QVERIFY(player.begin(random.integer(0, 1) == 1 ? Direction::Forward : Direction::Backward,
                                 random.integer(0, last)));
            player.run(200, 100, &random);
            QVERIFY(!player.ended);
            QCOMPARE(player.played.lastFrame, last);
            for (const int frame : player.shown)
                QVERIFY(frame >= in && frame <= std::min(out, last));
            const auto [least, most] = std::ranges::minmax(player.shown);
            if (!player.playback.settings().realTime)
                QVERIFY(least == in && most == std::min(out, last));
        }
    }

    void pingPongTurnsRoundAtBothEnds() {
        Player player(recorded(20, InOutPoints{4, 7}));
        player.set(1, false, Repeat::PingPong);
        QVERIFY(player.begin(Direction::Forward, 5));
        player.run(9);
        QCOMPARE(player.shown, (std::vector<int>{6, 7, 6, 5, 4, 5, 6, 7, 6}));
        QVERIFY(player.begin(Direction::Forward, 7)); // at its end already
        player.shown.clear();
        player.run(2);
        QCOMPARE(player.shown, (std::vector<int>{6, 5}));
    }

    void onceForwardGoesOnWithNewFramesAndShowsNoStaleOne() {
        for (const bool realTime : {false, true}) {
            Player player(recorded(20));
            player.played.endOfRun = 12;
            player.set(1, realTime, Repeat::Once);
            QVERIFY(player.begin(Direction::Forward, 17)); // stale
            QCOMPARE(player.frame, 12);
            QVERIFY(player.playback.records());
            const double due = player.step();
            QVERIFY(player.records);
            QCOMPARE(due, player.now); // at once
            player.now += 500;         // the worker takes its time
            player.played.lastFrame = player.played.endOfRun = 13;
            player.step();
            QCOMPARE(player.frame, 13);
            QVERIFY(player.records);
            player.run(100);
            for (std::size_t i = 2; i < player.shown.size(); ++i)
                QCOMPARE(player.shown[i], player.shown[i - 1] + 1);
            // Of what was late one frame is made up for, no more: then new ones come at their own pace.
            const double spent = player.times.back() - player.times[1];
            QVERIFY(std::abs(spent - double(player.shown.size() - 3) * kFrame) < 1);
        }
    }

    // Late or not, in real time or not.
    void newFramesAreNeverLeftOut() {
        SplitMix64 random(10);
        for (const double speed : kSpeeds) {
            Player player(recorded(3));
            player.set(speed, true, Repeat::Once);
            QVERIFY(player.begin(Direction::Forward, 2));
            for (int i = 0; i < 50; ++i) {
                player.step();
                QVERIFY(player.records);
                player.now += random.real(0, 100);
                player.played.endOfRun = ++player.played.lastFrame;
                if (!player.playback.isDue(player.now))
                    player.now += kFrame / speed;
                player.step();
                QCOMPARE(player.frame, 3 + i);
            }
        }
    }

    void onceForwardStopsAtTheOutPointIfItBeganBeforeIt() {
        Player player(recorded(20, InOutPoints{3, 10}));
        player.set(1, false, Repeat::Once);
        QVERIFY(player.begin(Direction::Forward, 1));
        player.run(100);
        QVERIFY(player.ended);
        QCOMPARE(player.frame, 10);
        QCOMPARE(player.shown.size(), 9U);

        player.ended = false;
        QVERIFY(player.begin(Direction::Forward, 10)); // and on from there
        player.run(40);
        QVERIFY(!player.ended && player.frame > 20);

        Player beyond(recorded(5, InOutPoints{0, 10})); // which is not recorded yet
        beyond.set(4, true, Repeat::Once);
        QVERIFY(beyond.begin(Direction::Forward, 4));
        beyond.run(100);
        QVERIFY(beyond.ended);
        QCOMPARE(beyond.frame, 10);
        QCOMPARE(beyond.played.lastFrame, 10);
    }

    void backwardGoesToTheStartOrTheInPoint() {
        for (const bool realTime : {false, true}) {
            Player player(recorded(20, InOutPoints{6, 12}));
            player.set(1, realTime, Repeat::Once);
            QVERIFY(player.begin(Direction::Backward, 15));
            player.run(100);
            QVERIFY(player.ended);
            QCOMPARE(player.frame, 6);
            player.ended = false;
            QVERIFY(player.begin(Direction::Backward, 5)); // before the in point
            player.run(100);
            QVERIFY(player.ended);
            QCOMPARE(player.frame, 0);
            QCOMPARE(player.played.lastFrame, 19);
        }
    }

    void backwardFromItsEndBeginsAtTheOther() {
        Player player(recorded(20));
        player.set(1, false, Repeat::Once);
        QVERIFY(player.begin(Direction::Backward, 0));
        QCOMPARE(player.frame, 19);
        player.run(2);
        QCOMPARE(player.shown, (std::vector<int>{19, 18}));
        QCOMPARE(player.times[1] - player.times[0], kFrame);

        player.played.range = InOutPoints{6, 12};
        QVERIFY(player.begin(Direction::Backward, 6));
        QCOMPARE(player.frame, 12);
        Player nothing(recorded(1));
        QVERIFY(!nothing.begin(Direction::Backward, 0));
        nothing.set(1, false, Repeat::Loop);
        QVERIFY(!nothing.begin(Direction::Forward, 0));
        Player notThere(recorded(5, InOutPoints{7, 9}));
        notThere.set(1, false, Repeat::Loop);
        QVERIFY(!notThere.begin(Direction::Forward, 2));
    }

    void anotherSpeedCountsAtOnce() {
        Player player(recorded(100));
        player.set(0.125, false, Repeat::Loop);
        QVERIFY(player.begin(Direction::Forward, 0));
        const double due = player.step();
        player.now += (due - player.now) / 2;
        const double left = due - player.now;
        player.set(8, false, Repeat::Loop);
        QVERIFY(std::abs(player.step() - player.now - left / 64) < 1e-9);
    }

    // A machine that slept, or a file whose times say nothing.
    void oddTimesNeitherHangNorStop() {
        Playback::Played odd = recorded(1000);
        odd.time = [](int frame) { return frame % 3 == 0 ? std::nan("") : 1e-300 * frame; };
        Player player(odd);
        player.set(8, true, Repeat::Loop);
        QVERIFY(player.begin(Direction::Forward, 0));
        player.step();
        player.now += 1e12;
        player.step();
        player.run(50);
        QVERIFY(!player.ended);
    }

    void speedsGoUpAndDownInSteps() {
        QCOMPARE(fasterThan(1), 2.0);
        QCOMPARE(fasterThan(8), 8.0);
        QCOMPARE(slowerThan(1), 0.5);
        QCOMPARE(slowerThan(0.125), 0.125);
        QCOMPARE(slowerThan(3), 2.0);
        QCOMPARE(fasterThan(3), 4.0);
    }
};

QTEST_GUILESS_MAIN(TestPlayback)
#include "tst_playback.moc"
