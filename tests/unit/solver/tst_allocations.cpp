// A run allocates nothing from the second on, unless the sheet crowds more than ever before. This counts all
// calls of operator new and of aligned_alloc, which RowArrays uses (tests/CMakeLists.txt wraps it).
#include "simcore/solver/verlet_solver.h"
#include "tests/support/shipped_scene.h"

#include <QtTest>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> allocations{0}; // of all threads

void* counted(void* block) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    if (block == nullptr)
        throw std::bad_alloc();
    return block;
}

} // namespace

extern "C" {
// The names are the linker's.
// NOLINTNEXTLINE(bugprone-reserved-identifier)
void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
// NOLINTNEXTLINE(bugprone-reserved-identifier)
void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
    return counted(__real_aligned_alloc(alignment, size));
}
}

// The forms for arrays and those that do not throw call these.
void* operator new(std::size_t size) {
    return counted(std::malloc(size > 0 ? size : 1));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto multiple = std::size_t(alignment);
    return counted(__real_aligned_alloc(multiple, (size + multiple - 1) / multiple * multiple));
}
void operator delete(void* block) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    std::free(block);
}

using namespace clothlab;

namespace {

// Of the frames; -1 if the sheet blew up.
std::int64_t allocationsOf(VerletSolver& solver, ClothState& state, int frames) {
    const std::atomic<bool> stop = false;
    const int steps = solver.scene().simulation.stepsPerFrame;
    const std::int64_t before = allocations;
    for (int frame = 0; frame < frames; ++frame)
        if (solver.run(state, steps, stop).blowUp)
            return -1;
    return allocations - before;
}

} // namespace

class TestAllocations : public QObject {
    Q_OBJECT

private slots:
    void theCounterCounts();
    void noneWhileNothingCrowdsMore_data();
    void noneWhileNothingCrowdsMore();
    void noneWhenAllHappensAgain_data() { scenesOnThreads(); }
    void noneWhenAllHappensAgain();

private:
    void scenesOnThreads() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("threads");
        for (const char* file : {"pinned2", "sphere", "selfCollision"})
            for (const int threads : {1, 2})
                QTest::addRow("%s on %d", file, threads) << file << threads;
    }
};

void TestAllocations::theCounterCounts() {
    const std::int64_t before = allocations;
    const auto block = std::make_unique<double[]>(3);
    const auto aligned = std::make_unique<Barrier>(2);
    QCOMPARE(allocations - before, 2);
    const RowArrays rows(RowLayout(Grid{4, 4}), 1);
    QCOMPARE(allocations - before, 3);
}

// Frames until each has crowded as much as it will for as many as count: the sheet of sphere falls flat for
// the first 40, that of pinned2 swings and folds most in its first half second, that of selfCollision comes
// to rest.
void TestAllocations::noneWhileNothingCrowdsMore_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("threads");
    QTest::addColumn<int>("framesOnOne");
    QTest::addColumn<int>("framesBefore");
    QTest::addColumn<int>("frames");
    for (const int threads : {1, 2}) {
        QTest::addRow("pinned2 on %d", threads) << "pinned2" << threads << 0 << 35 << 50;
        QTest::addRow("falling on %d", threads) << "sphere" << threads << 0 << 1 << 39;
        QTest::addRow("at rest on %d", threads) << "selfCollision" << threads << 900 << 30 << 30;
    }
}

void TestAllocations::noneWhileNothingCrowdsMore() {
    QFETCH(QString, file);
    QFETCH(int, threads);
    QFETCH(int, framesOnOne);
    QFETCH(int, framesBefore);
    QFETCH(int, frames);
    const Scene scene = test::shippedScene(file.toStdString());
    QVERIFY2(scene != Scene{}, "the scene does not load");
    ClothState state = startState(scene);
    VerletSolver onOne(scene, {1}); // on a busy machine much faster than two
    QVERIFY(allocationsOf(onOne, state, framesOnOne) >= 0);
    VerletSolver solver(scene, {threads, 1});
    QCOMPARE(solver.threads(), threads);
    QVERIFY(allocationsOf(solver, state, framesBefore) > 0);
    QCOMPARE(allocationsOf(solver, state, frames), 0);
}

void TestAllocations::noneWhenAllHappensAgain() {
    QFETCH(QString, file);
    QFETCH(int, threads);
    const Scene scene = test::shippedScene(file.toStdString());
    QVERIFY2(scene != Scene{}, "the scene does not load");
    VerletSolver solver(scene, {threads, 1});
    ClothState state = startState(scene);
    const std::int64_t first = allocationsOf(solver, state, 90);
    qInfo("%d allocations in the first 90 frames", int(first));
    QVERIFY(first >= 0);
    state = startState(scene);
    QCOMPARE(allocationsOf(solver, state, 90), 0);
}

QTEST_APPLESS_MAIN(TestAllocations)
#include "tst_allocations.moc"
