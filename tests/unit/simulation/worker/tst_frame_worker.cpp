// No event loop and no Qt objects: this runs under ThreadSanitizer.
#include "app/simulation/frame_worker.h"

#include "tests/support/tiny_scene.h"

#include <QTest>

#include <deque>
#include <random>

using namespace clothlab;

namespace {

constexpr std::chrono::minutes kHang{2}; // longer than anything here takes on any machine

// Where the worker delivers to.
class Outbox {
public:
    std::function<void(FrameOutcome)> deliver() {
        return [this](FrameOutcome outcome) {
            const std::scoped_lock lock(m_mutex);
            m_outcomes.push_back(std::move(outcome));
            m_arrived.notify_all();
        };
    }

    std::optional<FrameOutcome> take() {
        std::unique_lock lock(m_mutex);
        if (!m_arrived.wait_for(lock, kHang, [this] { return !m_outcomes.empty(); }))
            return std::nullopt;
        FrameOutcome outcome = std::move(m_outcomes.front());
        m_outcomes.pop_front();
        return outcome;
    }

    std::size_t size() {
        const std::scoped_lock lock(m_mutex);
        return m_outcomes.size();
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_arrived;
    std::deque<FrameOutcome> m_outcomes;
};

std::shared_ptr<const Scene> share(Scene scene) {
    return std::make_shared<const Scene>(std::move(scene));
}

// One frame after that one.
FrameRequest nextFrame(std::uint64_t ticket, const std::shared_ptr<const Scene>& scene, FramePointer before,
                       int number) {
    return {ticket, [before = std::move(before)] { return before; }, {{scene, {}, {}}}, number};
}

// The one frame of an outcome; null if there is none.
FramePointer frameOf(const std::optional<FrameOutcome>& outcome) {
    return outcome && outcome->frames.size() == 1 ? outcome->frames.front() : nullptr;
}

// The same frame computed here.
ClothState stepped(const Scene& scene, ClothState state) {
    VerletSolver solver(scene);
    for (int i = 0; i < scene.simulation.stepsPerFrame; ++i)
        solver.step(state);
    return state;
}

// A frame of it takes hours, a step far less than a second.
Scene endlessScene() {
    Scene scene;
    scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = 150;
    scene.cloth.pinned = {{0, 0}};
    scene.cloth.thickness = 0;
    scene.simulation.stepsPerFrame = 100'000;
    scene.simulation.framesPerSecond = 1;
    return scene;
}

// Returns once the thread has had the time to begin: when another thread has run a whole frame.
void letOthersRun(const std::shared_ptr<const Scene>& tiny) {
    Outbox outbox;
    FrameWorker other(outbox.deliver());
    for (int i = 0; i < 20; ++i) {
        other.request(nextFrame(1, tiny, startFrame(tiny), 1));
        QVERIFY(outbox.take().has_value());
    }
}

} // namespace

class TestFrameWorker : public QObject {
    Q_OBJECT
private slots:
    void framesAreThoseOfTheSolver() {
        const auto scene = share(test::tinyScene());
        Outbox outbox;
        FrameWorker worker(outbox.deliver());
        FramePointer frame = startFrame(scene);
        for (int number = 1; number <= 20; ++number) {
            worker.request(nextFrame(std::uint64_t(100 + number), scene, frame, number));
            const auto outcome = outbox.take();
            QVERIFY(frameOf(outcome));
            QCOMPARE(outcome->ticket, std::uint64_t(100 + number));
            QCOMPARE(outcome->number, number);
            QVERIFY(!outcome->blowUp);
            QVERIFY(outcome->computedOn != std::this_thread::get_id());
            QVERIFY(frameOf(outcome)->state == stepped(*scene, frame->state));
            QCOMPARE(frameOf(outcome)->scene, scene);
            QVERIFY(std::abs(frameOf(outcome)->time - number / 1000.0) < 1e-12);
            QVERIFY(frameOf(outcome)->milliseconds >= 0);
            frame = frameOf(outcome);
        }
    }

    void correctionsAreCountedByFrame() {
        Scene soft = test::tinyScene();
        soft.cloth.ks = 1; // the strain limit alone carries it
        const auto scene = share(soft);
        Outbox outbox;
        FrameWorker worker(outbox.deliver());
        FramePointer frame = startFrame(scene);
        VerletSolver solver(soft);
        ClothState state = solver.start();
        std::int64_t all = 0;
        for (int number = 1; number <= 300; ++number) {
            std::int64_t expected = 0;
            for (int step = 0; step < soft.simulation.stepsPerFrame; ++step)
                expected += solver.step(state).strainLimitCorrections;
            worker.request(nextFrame(1, scene, frame, number));
            const auto outcome = outbox.take();
            QVERIFY(frameOf(outcome));
            QCOMPARE(frameOf(outcome)->strainLimitCorrections, expected);
            frame = frameOf(outcome);
            all += expected;
        }
        QVERIFY(all > 0);
    }

    void newParametersHoldFromTheNextFrame() {
        const auto scene = share(test::tinyScene());
        Scene changed = *scene;
        changed.cloth.ks = 100;
        changed.cloth.pinned = {{0, 0}};
        changed.cloth.density = 20;
        changed.simulation.stepsPerFrame = 5;
        changed.spheres.emplace_back();
        Scene finer = changed; // a start edit: the solver of before does not fit
        finer.cloth.numHeightPoints = 6;
        Scene wider = finer; // as many points, but other rest lengths
        wider.cloth.width = 2;

        Outbox outbox;
        FrameWorker worker(outbox.deliver());
        const FramePointer first = startFrame(scene);
        for (const Scene& each : {*scene, changed, finer, wider, *scene}) {
            const auto shared = share(each);
            const FramePointer from = each.cloth.numHeightPoints == 4 ? first : startFrame(shared);
            worker.request(nextFrame(1, shared, from, 1));
            const auto outcome = outbox.take();
            QVERIFY(frameOf(outcome));
            QVERIFY(frameOf(outcome)->state == stepped(each, from->state));
        }
    }

    void aBlowUpIsToldByPlace() {
        const Scene unstable = test::unstableScene();
        const auto scene = share(unstable);
        // Where it happens, by the solver on the spot.
        VerletSolver solver(unstable);
        ClothState state = solver.start();
        std::optional<BlowUp> blowUp;
        int frame = 1, step = 0;
        for (; !blowUp && frame < 1000; frame += blowUp ? 0 : 1)
            for (step = 1; step <= unstable.simulation.stepsPerFrame; ++step)
                if ((blowUp = solver.step(state).blowUp))
                    break;
        QVERIFY(blowUp.has_value());
        QVERIFY(frame > 1); // there are good frames before

        Outbox outbox;
        FrameWorker worker(outbox.deliver());
        FramePointer from = startFrame(scene);
        for (int number = 1; number < frame; ++number) {
            worker.request(nextFrame(1, scene, from, number));
            const auto outcome = outbox.take();
            QVERIFY(frameOf(outcome) && !outcome->blowUp);
            from = frameOf(outcome);
        }
        worker.request(nextFrame(9, scene, from, frame));
        const auto outcome = outbox.take();
        QVERIFY(outcome && outcome->blowUp);
        QVERIFY(outcome->frames.empty());
        QCOMPARE(outcome->ticket, 9U);
        QCOMPARE(outcome->blowUpFrame, frame);
        QCOMPARE(outcome->blowUpStep, step);
        QCOMPARE(outcome->blowUp->point, blowUp->point);
        QCOMPARE(outcome->blowUp->phase, blowUp->phase);
        QVERIFY(outcome->blowUpScene == scene);

        // And the worker goes on with what is stable.
        const auto tiny = share(test::tinyScene());
        worker.request(nextFrame(10, tiny, startFrame(tiny), 1));
        const auto after = outbox.take();
        QVERIFY(frameOf(after));
        QVERIFY(frameOf(after)->state == stepped(*tiny, startState(*tiny)));
    }

    // deliver() is called on the worker's thread, so nothing is begun while it is in there.
    void aRequestReplacesOneNotBegun() {
        const auto scene = share(test::tinyScene());
        Outbox outbox;
        FrameWorker* requests = nullptr;
        std::mutex handOver;
        handOver.lock();
        FrameWorker worker([&, deliver = outbox.deliver()](FrameOutcome outcome) {
            const std::scoped_lock lock(handOver); // not before the worker is known here
            if (outcome.ticket == 1)
                for (std::uint64_t ticket = 2; ticket <= 5; ++ticket)
                    requests->request(nextFrame(ticket, scene, startFrame(scene), 1));
            deliver(std::move(outcome));
        });
        requests = &worker;
        worker.request(nextFrame(1, scene, startFrame(scene), 1));
        handOver.unlock();
        QCOMPARE(outbox.take().value_or(FrameOutcome{}).ticket, 1U);
        QCOMPARE(outbox.take().value_or(FrameOutcome{}).ticket, 5U);
        QCOMPARE(outbox.size(), 0U);
    }

    void aCancelledRequestNotBegunIsForgotten() {
        const auto scene = share(test::tinyScene());
        Outbox outbox;
        FrameWorker* requests = nullptr;
        std::mutex handOver;
        handOver.lock();
        FrameWorker worker([&, deliver = outbox.deliver()](FrameOutcome outcome) {
            const std::scoped_lock lock(handOver);
            if (outcome.ticket == 1) {
                requests->request(nextFrame(2, scene, startFrame(scene), 1));
                requests->cancel();
            }
            deliver(std::move(outcome));
        });
        requests = &worker;
        worker.request(nextFrame(1, scene, startFrame(scene), 1));
        handOver.unlock();
        QCOMPARE(outbox.take().value_or(FrameOutcome{}).ticket, 1U);
        letOthersRun(scene); // time for the second to be computed, too
        QCOMPARE(outbox.size(), 0U);
        // cancel() says nothing of requests after it.
        worker.request(nextFrame(3, scene, startFrame(scene), 1));
        QCOMPARE(outbox.take().value_or(FrameOutcome{}).ticket, 3U);
        QCOMPARE(outbox.size(), 0U);
    }

    void aFrameAtHandIsAbandoned() {
        const auto tiny = share(test::tinyScene());
        const auto endless = share(endlessScene());
        Outbox outbox;
        FrameWorker worker(outbox.deliver());
        worker.request(nextFrame(1, endless, startFrame(endless), 1));
        letOthersRun(tiny);
        worker.cancel();
        worker.request(nextFrame(2, tiny, startFrame(tiny), 1)); // its turn comes within a step
        const auto outcome = outbox.take();
        QVERIFY(outcome.has_value());
        QCOMPARE(outcome->ticket, 2U);
    }

    // A run that was recorded, with other parameters in its middle, from its start to its end.
    void framesOneAfterTheOther() {
        const auto scene = share(test::tinyScene());
        Scene soft = *scene;
        soft.cloth.ks = 100;
        const auto changed = share(soft);
        std::vector<ClothState> states{startState(*scene)};
        FrameRequest request = nextFrame(1, scene, startFrame(scene), 1);
        request.frames.clear();
        for (int i = 1; i <= 12; ++i) {
            const auto& with = i < 6 ? scene : changed;
            states.push_back(stepped(*with, states.back()));
            request.frames.push_back({with, 100.0 + i, stateHash(states.back())});
        }
        Outbox outbox;
        FrameWorker worker(outbox.deliver());
        worker.request(request);
        const auto outcome = outbox.take();
        QVERIFY(outcome && outcome->frames.size() == 12 && outcome->number == 1 && !outcome->differs);
        for (std::size_t i = 1; i <= 12; ++i) {
            QVERIFY(outcome->frames[i - 1]->state == states[i]);
            QCOMPARE(outcome->frames[i - 1]->scene, i < 6 ? scene : changed);
            QCOMPARE(outcome->frames[i - 1]->milliseconds, 100.0 + double(i));
        }
        ++*request.frames.back().stateHash; // as if it had been recorded by another program
        worker.request(request);
        const auto other = outbox.take();
        QVERIFY(other && other->differs);
        request.before = [] { return FramePointer(); };
        worker.request(request);
        const auto nothing = outbox.take();
        QVERIFY(nothing && nothing->frames.empty() && !nothing->blowUp);
    }

    void cancellingNothingIsNothing() {
        const auto scene = share(test::tinyScene());
        Outbox outbox;
        FrameWorker worker(outbox.deliver());
        worker.cancel();
        worker.cancel();
        worker.request(nextFrame(1, scene, startFrame(scene), 1));
        QVERIFY(outbox.take().has_value());
        worker.cancel();
        worker.request(nextFrame(2, scene, startFrame(scene), 1));
        QCOMPARE(outbox.take().value_or(FrameOutcome{}).ticket, 2U);
    }

    // Without its stop flag this would take hours, and the time limit of the test ends it.
    void destroyingStopsWithinAStep() {
        const auto tiny = share(test::tinyScene());
        const auto endless = share(endlessScene());
        Outbox outbox;
        {
            FrameWorker worker(outbox.deliver());
            worker.request(nextFrame(1, endless, startFrame(endless), 1));
            letOthersRun(tiny);
        }
        QCOMPARE(outbox.size(), 0U);
        {
            FrameWorker worker(outbox.deliver()); // perhaps before it has begun
            worker.request(nextFrame(1, endless, startFrame(endless), 1));
        }
        { const FrameWorker idle(outbox.deliver()); }
        QCOMPARE(outbox.size(), 0U);
    }

    void hammeringLosesNothing_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 8; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void hammeringLosesNothing() {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        const auto scene = share(test::tinyScene());
        Scene other = *scene;
        other.cloth.ks = 300;
        const std::array scenes{scene, share(other)};
        const FramePointer start = startFrame(scene);
        const std::array expected{stepped(*scenes[0], start->state), stepped(*scenes[1], start->state)};

        Outbox outbox;
        std::uint64_t ticket = 0;
        {
            FrameWorker worker(outbox.deliver());
            for (int i = 0; i < 2000; ++i) {
                const auto dice = random() % 8;
                if (dice == 0)
                    worker.cancel();
                else if (dice == 1)
                    std::this_thread::yield();
                else
                    ++ticket, worker.request(nextFrame(ticket, scenes[ticket % 2], start, 1));
            }
            ++ticket; // the last one nobody cancels: it must come
            worker.request(nextFrame(ticket, scenes[ticket % 2], start, 1));
            for (std::uint64_t last = 0; last != ticket;) {
                const auto outcome = outbox.take();
                QVERIFY(frameOf(outcome));
                QVERIFY(outcome->ticket > last); // in order, none twice
                last = outcome->ticket;
                QVERIFY(frameOf(outcome)->state == expected[last % 2]);
            }
            worker.request(nextFrame(ticket + 1, scene, start, 1)); // under way or not when the worker goes
        }
        QVERIFY(outbox.size() <= 1);
    }
};

QTEST_APPLESS_MAIN(TestFrameWorker)
#include "tst_frame_worker.moc"
