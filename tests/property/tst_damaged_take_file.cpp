// Recordings cut off anywhere, and with any byte changed: never a crash, and never silently wrong. What is
// read is what was written, or something is said.
#include "tests/support/random.h"
#include "tests/support/recorded_run.h"
#include "tests/support/scene_text.h"
#include "tests/support/take_file_invariants.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

using namespace clothlab;
using test::TwoTakes;

namespace {

// All that a file says, read once from the whole one.
struct Truth {
    TakeFileReading reading;
    std::map<std::pair<TakeId, int>, PointArray> positions;
    std::map<std::pair<TakeId, int>, ClothState> states;

    explicit Truth(const std::string& path) : reading(readTakeFile(path)) {
        for (const RecordedTake& take : reading.contents->takes) {
            for (const FrameGroup& group : take.groups)
                for (int frame = group.first; frame < group.end(); ++frame)
                    positions[{take.info.id, frame}] = *positionsOf(group, frame);
            for (const Checkpoint& checkpoint : take.checkpoints)
                states[{take.info.id, checkpoint.frame}] = *stateOf(checkpoint);
        }
    }
};

struct Compared {
    std::string wrong;      // something that is not what was written, and nobody said so
    bool complete = true;   // all frames and states are there
    std::size_t frames = 0; // that are there and right
};

void compareFrames(const Truth& truth, const TakeFileContents& contents, const RecordedTake& take,
                   Compared& result) {
    for (const FrameGroup& group : take.groups) {
        GroupReader reader;
        for (int frame = group.first; frame < group.end(); ++frame) {
            const auto positions = reader.positionsOf(group, frame);
            const FrameEntry& entry = group.frames[std::size_t(frame - group.first)];
            const FrameGroup* before = findGroup(*truth.reading.contents, take.info.id, frame);
            const FrameEntry& original = before->frames[std::size_t(frame - before->first)];
            if (!(entry.facts == original.facts) ||
                !(*contents.scenes.at(entry.scene) == *truth.reading.contents->scenes.at(original.scene)))
                result.wrong = "facts of frame " + std::to_string(frame);
            if (!positions)
                result.complete = false;
            else if (!(*positions == truth.positions.at({take.info.id, frame})))
                result.wrong = "positions of frame " + std::to_string(frame);
            else
                ++result.frames;
        }
    }
}

Compared compare(const Truth& truth, const TakeFileReading& reading) {
    Compared result;
    std::size_t states = 0;
    if (reading.contents)
        for (const RecordedTake& take : reading.contents->takes) {
            const RecordedTake* original = findTake(*truth.reading.contents, take.info.id);
            if (original == nullptr || !(original->info == take.info))
                if (reading.diagnostics.empty())
                    result.wrong = "a take";
            compareFrames(truth, *reading.contents, take, result);
            for (const Checkpoint& checkpoint : take.checkpoints) {
                const auto state = stateOf(checkpoint);
                if (state && !(*state == truth.states.at({take.info.id, checkpoint.frame})))
                    result.wrong = "state of frame " + std::to_string(checkpoint.frame);
                states += state ? 1 : 0;
            }
            if (reading.diagnostics.empty() && !(reading.contents->meta == truth.reading.contents->meta))
                result.wrong = "what it says of itself";
        }
    result.complete &= result.frames == truth.positions.size() && states == truth.states.size();
    return result;
}

} // namespace

class TestDamagedTakeFile : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cutOffAnywhere();
    void anyByteChanged();
    void severalBytesChanged();
    void liesWithRightChecksums();

private:
    TakeFileReading read(const std::string& bytes) {
        std::ofstream(m_path, std::ios::binary | std::ios::trunc) << bytes;
        return readTakeFile(m_path);
    }
    QString check(const std::string& bytes, std::size_t* frames = nullptr);

    QTemporaryDir m_folder;
    std::string m_path, m_bytes;
    std::unique_ptr<Truth> m_truth;
};

void TestDamagedTakeFile::initTestCase() {
    QVERIFY(m_folder.isValid());
    m_path = m_folder.filePath("damaged.clothtake").toStdString();
    const std::string whole = m_folder.filePath("whole.clothtake").toStdString();
    QVERIFY(!writeTakeFile(whole, test::twoTakes(kDefaultError).contents));
    m_bytes = test::readText(whole);
    m_truth = std::make_unique<Truth>(whole);
    QVERIFY(m_truth->reading.diagnostics.empty());
    QCOMPARE(QString::fromStdString(compare(*m_truth, read(m_bytes)).wrong), QString());
    QVERIFY(compare(*m_truth, read(m_bytes)).complete);
}

// What is wrong with how the file was read; empty if nothing is.
QString TestDamagedTakeFile::check(const std::string& bytes, std::size_t* frames) {
    const TakeFileReading reading = read(bytes);
    if (const std::string broken = test::brokenTakeFileInvariant(reading); !broken.empty())
        return QString::fromStdString(broken);
    const Compared compared = compare(*m_truth, reading);
    if (frames != nullptr)
        *frames = compared.frames;
    if (!compared.wrong.empty())
        return QString::fromStdString("wrong: " + compared.wrong);
    return {};
}

void TestDamagedTakeFile::cutOffAnywhere() {
    SplitMix64 random(20'240'501);
    for (int trial = 0; trial < 1000; ++trial) {
        const auto length = std::size_t(random.integer(0, int(m_bytes.size()) - 1));
        const QString wrong = check(m_bytes.substr(0, length));
        QVERIFY2(wrong.isEmpty(), qPrintable(QString("%1 bytes: %2").arg(length).arg(wrong)));
        const TakeFileReading reading = readTakeFile(m_path);
        QVERIFY2(!reading.finished && !reading.diagnostics.empty(), qPrintable(QString::number(length)));
        // All whole chunks count.
        if (reading.contents)
            QVERIFY(reading.end <= length && reading.end > kFileHeaderBytes);
    }
}

void TestDamagedTakeFile::anyByteChanged() {
    SplitMix64 random(20'240'502);
    std::size_t fewest = m_truth->positions.size();
    int opened = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const auto at = std::size_t(random.integer(0, int(m_bytes.size()) - 1));
        std::string damaged = m_bytes;
        damaged[at] = char(damaged[at] ^ (1U << unsigned(random.integer(0, 7))));
        std::size_t frames = 0;
        const QString wrong = check(damaged, &frames);
        QVERIFY2(wrong.isEmpty(), qPrintable(QString("byte %1: %2").arg(at).arg(wrong)));
        opened += frames > 0 ? 1 : 0;
        if (frames > 0)
            fewest = std::min(fewest, frames);
    }
    QVERIFY(opened > 950); // but for the file's header
    QVERIFY(fewest >= 1);
}

void TestDamagedTakeFile::severalBytesChanged() {
    SplitMix64 random(20'240'503);
    for (int trial = 0; trial < 300; ++trial) {
        std::string damaged = m_bytes;
        for (int i = random.integer(2, 40); i > 0; --i) {
            const auto at = std::size_t(random.integer(0, int(damaged.size()) - 1));
            switch (random.integer(0, 3)) {
            case 0:
                damaged.erase(at, std::size_t(random.integer(1, 300)));
                break;
            case 1:
                damaged.insert(at, damaged.substr(damaged.size() / 3, std::size_t(random.integer(1, 300))));
                break;
            default:
                damaged[at] = char(random.integer(-128, 127));
            }
        }
        const QString wrong = check(damaged);
        QVERIFY2(wrong.isEmpty(), qPrintable(QString("trial %1: %2").arg(trial).arg(wrong)));
    }
}

// Then anything may be read, but nothing that breaks a promise.
void TestDamagedTakeFile::liesWithRightChecksums() {
    SplitMix64 random(20'240'504);
    QVERIFY(test::withRightChecksums(m_bytes) == m_bytes);
    for (int trial = 0; trial < 1000; ++trial) {
        std::string damaged = m_bytes;
        for (int i = random.integer(1, 5); i > 0; --i)
            damaged[std::size_t(random.integer(0, int(damaged.size()) - 1))] =
                char(random.integer(-128, 127));
        const std::string broken = test::brokenTakeFileInvariant(read(test::withRightChecksums(damaged)));
        QVERIFY2(broken.empty(),
                 qPrintable(QString("trial %1: ").arg(trial) + QString::fromStdString(broken)));
    }
}

QTEST_APPLESS_MAIN(TestDamagedTakeFile)
#include "tst_damaged_take_file.moc"
