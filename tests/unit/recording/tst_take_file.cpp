// Recordings as files: what is written is read, also what was appended, cut off or replaced.
#include "simcore/base/whole_file.h"
#include "simcore/solver/frame_runner.h"
#include "tests/support/recorded_run.h"
#include "tests/support/scene_text.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>
#include <sstream>

using namespace clothlab;
using test::TwoTakes;

namespace {

std::string textOf(const TakeFileReading& reading) {
    return test::toText(reading.diagnostics);
}

} // namespace

class TestTakeFile : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void whatIsWrittenIsRead_data();
    void whatIsWrittenIsRead();
    void statesRunOnWithTheSameHashes();
    void framesOfAParentAreFound();
    void cutOffFilesOpenUpToTheLastChunk();
    void filesMayBeAppendedTo();
    void laterChunksTakeThePlaceOfEarlierOnes();
    void aGapEndsATake();
    void aDamagedChunkIsSkipped();
    void aDamagedBlobIsNotUnpacked();
    void otherFilesAreRefused_data();
    void otherFilesAreRefused();
    void takesThatDescendFromThemselvesAreLeftOut();
    void sheetsDoNotChangeWithinATake();
    void cancellingLeavesTheFileAsItWas();
    void payloadsMayMoveToAFile();

private:
    std::string write(const std::string& bytes) {
        const std::string path = m_folder.filePath("file.clothtake").toStdString();
        const auto trouble = writeFileWhole(path, [&](std::ostream& out) { out << bytes; });
        return trouble ? std::string() : path;
    }
    QTemporaryDir m_folder;
};

void TestTakeFile::whatIsWrittenIsRead_data() {
    QTest::addColumn<double>("error");
    QTest::newRow("default") << kDefaultError;
    QTest::newRow("coarse") << 1e-3;
    QTest::newRow("lossless") << 0.0;
}

void TestTakeFile::whatIsWrittenIsRead() {
    QFETCH(double, error);
    const TwoTakes made = test::twoTakes(error);
    const std::string path = m_folder.filePath("whole.clothtake").toStdString();
    QCOMPARE(QString::fromStdString(writeTakeFile(path, made.contents).value_or("")), QString());
    const TakeFileReading reading = readTakeFile(path);
    QCOMPARE(QString::fromStdString(textOf(reading)), QString());
    QVERIFY(reading.contents && reading.finished);
    const TakeFileContents& read = *reading.contents;
    QVERIFY(read.meta == made.contents.meta);
    QCOMPARE(read.scenes.size(), made.contents.scenes.size());
    for (const auto& [id, scene] : made.contents.scenes)
        QVERIFY(*read.scenes.at(id) == *scene);
    QCOMPARE(int(read.takes.size()), 2);
    for (std::size_t t = 0; t < 2; ++t) {
        QVERIFY(read.takes[t].info == made.contents.takes[t].info);
        const auto& frames = t == 0 ? made.first : made.branch;
        const int first = read.takes[t].info.firstOwnFrame();
        QCOMPARE(read.takes[t].end(), first + int(frames.size()));
        for (int i = 0; i < int(frames.size()); ++i) {
            const FrameGroup* group = findGroup(read, read.takes[t].info.id, first + i);
            const auto positions = positionsOf(*group, first + i);
            QVERIFY(positions);
            const double off = test::greatestDifference(*positions, frames[std::size_t(i)]->state.position);
            QVERIFY2(off <= error, qPrintable(QString::number(off)));
            const FrameEntry& entry = group->frames[std::size_t(first + i - group->first)];
            QCOMPARE(entry.facts.stateHash, stateHash(frames[std::size_t(i)]->state));
            QCOMPARE(entry.facts.time, frames[std::size_t(i)]->time);
            QVERIFY(*read.scenes.at(entry.scene) == *frames[std::size_t(i)]->scene);
        }
    }
}

void TestTakeFile::statesRunOnWithTheSameHashes() {
    const TwoTakes made = test::twoTakes(kDefaultError);
    const TakeFileReading reading = readTakeFile(write(test::bytesOf(made.contents)));
    const RecordedTake& take = reading.contents->takes[0];
    QCOMPARE(int(take.checkpoints.size()), 4); // 0, 15, 30, 40
    const std::atomic<bool> never{false};
    for (const Checkpoint& checkpoint : take.checkpoints) {
        auto state = stateOf(checkpoint);
        QVERIFY(state && *state == made.first[std::size_t(checkpoint.frame)]->state);
        std::vector<std::shared_ptr<const Scene>> scenes;
        for (int f = checkpoint.frame + 1; f < take.end(); ++f) {
            const FrameGroup* group = findGroup(*reading.contents, 1, f);
            scenes.push_back(reading.contents->scenes.at(group->frames[std::size_t(f - group->first)].scene));
        }
        VerletSolver solver(*made.first[0]->scene);
        const RepeatResult result = repeatFrames(
            solver, *state, scenes, never, [&](std::size_t i, const ClothState& now, const FrameResult&) {
                return now == made.first[std::size_t(checkpoint.frame) + 1 + i]->state;
            });
        QCOMPARE(result.frames, scenes.size());
        QVERIFY(*state == made.first.back()->state);
    }
}

void TestTakeFile::framesOfAParentAreFound() {
    const TwoTakes made = test::twoTakes(kDefaultError);
    QCOMPARE(findGroup(made.contents, 2, 9), &made.contents.takes[0].groups[0]);
    QCOMPARE(findGroup(made.contents, 2, 10), &made.contents.takes[1].groups[0]);
    QVERIFY(findGroup(made.contents, 2, 31) == nullptr);
    QVERIFY(findGroup(made.contents, 3, 0) == nullptr);
}

void TestTakeFile::cutOffFilesOpenUpToTheLastChunk() {
    const TwoTakes made = test::twoTakes(kDefaultError);
    const std::string bytes = test::bytesOf(made.contents);
    const TakeFileReading whole = readTakeFile(write(bytes));
    // In the middle of the third group of the first take.
    const Payload& third = *whole.contents->takes[0].groups[2].payload;
    const std::size_t at = bytes.find(*third.read(0, third.length()));
    QVERIFY(at != std::string::npos);
    const TakeFileReading reading = readTakeFile(write(bytes.substr(0, at + 3)));
    QVERIFY(reading.contents && !reading.finished);
    QCOMPARE(reading.contents->takes[0].end(), 2 * kFramesPerGroup);
    QVERIFY2(textOf(reading).find("is cut off after frame 31 of take 'Take 1'") != std::string::npos,
             textOf(reading).c_str());
    QVERIFY(reading.end < reading.bytes);
}

void TestTakeFile::filesMayBeAppendedTo() {
    TwoTakes made = test::twoTakes(kDefaultError);
    const std::string path = write(test::bytesOf(made.contents));
    const TakeFileReading before = readTakeFile(path);
    QCOMPARE(before.end, before.bytes);
    const auto more = test::runOn(*made.first[20], 21, 25);
    TakeFileContents added;
    added.scenes = made.contents.scenes;
    test::addTake(added, {3, 1, 20, "third", false}, more, kDefaultError);
    std::ofstream out(path, std::ios::binary | std::ios::app);
    TakeFileWriter writer(out, before.end, before.chunks);
    writer.add(takeChunk(added.takes[0].info));
    for (const FrameGroup& group : added.takes[0].groups)
        writer.add(*chunkOf(group));
    writer.finish();
    out.close();
    const TakeFileReading after = readTakeFile(path);
    QCOMPARE(QString::fromStdString(textOf(after)), QString());
    QVERIFY(after.finished);
    QCOMPARE(int(after.contents->takes.size()), 3);
    QCOMPARE(after.contents->takes[2].end(), 26);
    QCOMPARE(after.bytes, writer.size());
    QCOMPARE(after.chunks.size(), before.chunks.size() + 2);
}

// A group that grows is written again; a take is renamed, and one removed.
void TestTakeFile::laterChunksTakeThePlaceOfEarlierOnes() {
    TwoTakes made = test::twoTakes(kDefaultError);
    FrameGroup start = made.contents.takes[0].groups[0];
    trimGroup(start, 3);
    std::ostringstream out;
    TakeFileWriter writer(out);
    for (const auto& [id, scene] : made.contents.scenes)
        writer.add(sceneChunk(id, *scene));
    writer.add(takeChunk(made.contents.takes[0].info));
    writer.add(takeChunk(made.contents.takes[1].info));
    writer.add(*chunkOf(start));
    for (const RecordedTake& take : made.contents.takes)
        for (const FrameGroup& group : take.groups)
            writer.add(*chunkOf(group));
    writer.add(takeChunk({1, 0, 0, "renamed", true}));
    writer.add(removedTakeChunk(2));
    const TakeFileReading reading = readTakeFile(write(out.str()));
    QCOMPARE(int(reading.contents->takes.size()), 1);
    QCOMPARE(reading.contents->takes[0].info.name, std::string("renamed"));
    QVERIFY(reading.contents->takes[0].info.hidden);
    QCOMPARE(reading.contents->takes[0].end(), 41);
    // The other way round, the short one counts, and what follows it is out of reach.
    writer.add(*chunkOf(start));
    const TakeFileReading shorter = readTakeFile(write(out.str()));
    QCOMPARE(shorter.contents->takes[0].end(), 3);
    for (int f = 0; f < 3; ++f)
        QVERIFY(test::greatestDifference(*positionsOf(shorter.contents->takes[0].groups[0], f),
                                         made.first[std::size_t(f)]->state.position) <= kDefaultError);
    QVERIFY2(textOf(shorter).find("frame 3 of take 'renamed' is missing") != std::string::npos,
             textOf(shorter).c_str());
}

void TestTakeFile::aGapEndsATake() {
    TwoTakes made = test::twoTakes(kDefaultError);
    made.contents.takes[0].groups.erase(made.contents.takes[0].groups.begin() + 1);
    const TakeFileReading reading = readTakeFile(write(test::bytesOf(made.contents)));
    QCOMPARE(reading.contents->takes[0].end(), kFramesPerGroup);
    QVERIFY2(textOf(reading).find("frame 16 of take 'Take 1' is missing or damaged; 9 frames after it") !=
                 std::string::npos,
             textOf(reading).c_str());
    for (const Checkpoint& checkpoint : reading.contents->takes[0].checkpoints)
        QVERIFY(checkpoint.frame < kFramesPerGroup);
    QCOMPARE(int(reading.contents->takes.size()), 2); // it branched off before
}

void TestTakeFile::aDamagedChunkIsSkipped() {
    const TwoTakes made = test::twoTakes(kDefaultError);
    const std::string bytes = test::bytesOf(made.contents);
    for (const bool withIndex : {true, false}) {
        std::string damaged = withIndex ? bytes : bytes.substr(0, bytes.size() - 10);
        const std::string needle = takeChunk(made.contents.takes[1].info).head;
        damaged[damaged.find(needle) + needle.size() - 1] ^= 1;
        const TakeFileReading reading = readTakeFile(write(damaged));
        QVERIFY(reading.contents);
        QCOMPARE(reading.contents->takes[0].end(), 41);
        QCOMPARE(int(reading.contents->takes.size()), 1);
        QVERIFY2(textOf(reading).find("is damaged") != std::string::npos, textOf(reading).c_str());
        QVERIFY2(textOf(reading).find("take 2") != std::string::npos, textOf(reading).c_str());
    }
}

void TestTakeFile::aDamagedBlobIsNotUnpacked() {
    const TwoTakes made = test::twoTakes(kDefaultError);
    std::string bytes = test::bytesOf(made.contents);
    const FrameGroup& group = made.contents.takes[0].groups[0];
    const Blob& blob = group.frames[8].blob;
    const std::size_t at = bytes.find(*group.payload->read(0, group.payload->length()));
    bytes[at + std::size_t(blob.offset) + 5] ^= 0x10;
    const TakeFileReading reading = readTakeFile(write(bytes));
    const FrameGroup& read = reading.contents->takes[0].groups[0];
    QVERIFY(positionsOf(read, 0));
    QVERIFY(!positionsOf(read, 8));
    QVERIFY(!positionsOf(read, 4)); // lies between 0 and 8
    GroupReader reader;
    QVERIFY(!reader.positionsOf(read, 8));
    QVERIFY(reader.positionsOf(reading.contents->takes[0].groups[1], 16));
}

void TestTakeFile::otherFilesAreRefused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("words");
    const TwoTakes made = test::twoTakes(kDefaultError);
    const std::string good = test::bytesOf(made.contents).substr(0, kFileHeaderBytes);
    const auto row = [](const char* name, const std::string& bytes, const char* words) {
        QTest::newRow(name) << QByteArray(bytes.data(), qsizetype(bytes.size())) << QString(words);
    };
    row("empty", "", "cut off");
    row("a scene", "{\"cloth\": {}, \"sphere\": {}, \"plane\": {}}", "is no recording");
    row("cut off", good.substr(0, 11), "cut off");
    row("nothing in it", good, "holds no frame");
    std::string damaged = good;
    damaged[8] ^= 4;
    row("damaged", damaged, "damaged header");
}

void TestTakeFile::otherFilesAreRefused() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, words);
    const TakeFileReading reading = readTakeFile(write(bytes.toStdString()));
    QVERIFY(!reading.contents && hasErrors(reading.diagnostics));
    QVERIFY2(textOf(reading).find(words.toStdString()) != std::string::npos, textOf(reading).c_str());
}

void TestTakeFile::takesThatDescendFromThemselvesAreLeftOut() {
    TwoTakes made = test::twoTakes(kDefaultError);
    TakeFileContents& contents = made.contents;
    contents.takes[1].info.parent = 3;
    contents.takes.push_back({{3, 2, 5, "third", false}, {}, {}});
    const TakeFileReading reading = readTakeFile(write(test::bytesOf(contents)));
    QCOMPARE(int(reading.contents->takes.size()), 1);
    QVERIFY(textOf(reading).find("take 'softer' branches off a frame that is not there") !=
            std::string::npos);
}

void TestTakeFile::sheetsDoNotChangeWithinATake() {
    TwoTakes made = test::twoTakes(kDefaultError);
    Scene other = *made.contents.scenes.at(2);
    other.cloth.width = 2;
    made.contents.scenes[2] = std::make_shared<const Scene>(other);
    const TakeFileReading reading = readTakeFile(write(test::bytesOf(made.contents)));
    QCOMPARE(reading.contents->takes[0].end(), 12); // from there on scene 2
    QVERIFY(!reading.diagnostics.empty());
}

void TestTakeFile::cancellingLeavesTheFileAsItWas() {
    const TwoTakes made = test::twoTakes(kDefaultError);
    const std::string path = write("before");
    int calls = 0;
    const auto trouble =
        writeTakeFile(path, made.contents, [&](double share) { return share < 0 || ++calls < 3; });
    QVERIFY(trouble && trouble->empty());
    QCOMPARE(test::readText(path), std::string("before"));
    double last = 0;
    QVERIFY(!writeTakeFile(path, made.contents, [&](double share) {
        const bool grows = share >= last && share <= 1;
        last = share;
        return grows;
    }));
    QCOMPARE(last, 1.0);
}

void TestTakeFile::payloadsMayMoveToAFile() {
    const TwoTakes made = test::twoTakes(kDefaultError);
    const FrameGroup& group = made.contents.takes[0].groups[0];
    const Chunk chunk = *chunkOf(group);
    std::ostringstream out;
    TakeFileWriter writer(out);
    const std::uint64_t at = writer.add(chunk);
    const auto before = positionsOf(group, 5);
    QCOMPARE(group.payload->release(), std::size_t(0)); // it is nowhere else
    group.payload->placeInFile(SharedFile::open(write(out.str())).file, at + payloadOffset(chunk));
    QCOMPARE(group.payload->release(), chunk.payload.size());
    QCOMPARE(group.payload->bytesInMemory(), std::size_t(0));
    QVERIFY(*positionsOf(group, 5) == *before);
    QCOMPARE(chunkOf(group)->payload, chunk.payload);
}

QTEST_APPLESS_MAIN(TestTakeFile)
#include "tst_take_file.moc"
