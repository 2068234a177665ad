// A recording is what its scenes give, or it is said where it is not.
#include "simcore/inspect/verify_takes.h"
#include "tests/support/recorded_run.h"

#include <QtTest>

using namespace clothlab;

namespace {

Verification verify(const TakeFileContents& contents) {
    const std::atomic<bool> never{false};
    return verifyTakes(contents, {}, never);
}

QString textOf(const Verification& result) {
    QStringList lines;
    for (const TakeDifference& difference : result.differences)
        lines << QString("%1:%2 ").arg(difference.take).arg(difference.frame) +
                     QString::fromStdString(difference.what);
    return lines.join('\n');
}

} // namespace

class TestVerifyTakes : public QObject {
    Q_OBJECT

private slots:
    void goodRecordingsAreTheSame() {
        for (const double error : {kDefaultError, 0.0}) {
            const Verification result = verify(test::twoTakes(error).contents);
            QCOMPARE(textOf(result), QString());
            QCOMPARE(result.frames, std::int64_t(41 + 21));
        }
    }
    void anotherHashIsFound() {
        test::TwoTakes made = test::twoTakes(kDefaultError);
        made.contents.takes[1].groups[0].frames[7].facts.stateHash ^= 1;
        const QString text = textOf(verify(made.contents));
        QVERIFY2(text.startsWith("2:17 ") && text.contains("hash") && !text.contains('\n'), qPrintable(text));
    }
    void anotherSceneIsFound() {
        test::TwoTakes made = test::twoTakes(kDefaultError);
        Scene other = *made.contents.scenes.at(2);
        other.simulation.gravity.x() += 1e-9;
        made.contents.scenes[2] = std::make_shared<const Scene>(other);
        const QString text = textOf(verify(made.contents));
        QVERIFY2(text.startsWith("1:12 ") && !text.contains('\n'), qPrintable(text));
    }
    void otherPositionsAreFound() {
        test::TwoTakes made = test::twoTakes(kDefaultError);
        const auto other = test::runOn(*made.first[0], 1, 40); // without the edit of frame 12
        TakeFileContents contents;
        contents.scenes = made.contents.scenes;
        test::addTake(contents, {1, 0, 0, "", false}, {other.begin() + 15, other.begin() + 31},
                      kDefaultError);
        made.contents.takes[0].groups[1].payload = contents.takes[0].groups[0].payload;
        for (std::size_t i = 0; i < 16; ++i)
            made.contents.takes[0].groups[1].frames[i].blob = contents.takes[0].groups[0].frames[i].blob;
        const QString text = textOf(verify(made.contents));
        QVERIFY2(text.startsWith("1:16 ") && text.contains("stated error"), qPrintable(text));
    }
    void anotherCheckpointIsFound() {
        test::TwoTakes made = test::twoTakes(kDefaultError);
        made.contents.takes[0].checkpoints[1].frame = 14;
        const QString text = textOf(verify(made.contents));
        QVERIFY2(text.startsWith("1:14 ") && text.contains("checkpoint"), qPrintable(text));
    }
    void stopsWhenTold() {
        const std::atomic<bool> stop{true};
        QVERIFY(verifyTakes(test::twoTakes(kDefaultError).contents, {}, stop).stopped);
    }
};

QTEST_APPLESS_MAIN(TestVerifyTakes)
#include "tst_verify_takes.moc"
