// What the fuzzer starts from and what it once found, as an ordinary test.
#include "tests/support/take_file_invariants.h"

#include <QTest>

#include <filesystem>

class TestFuzzCorpusTake : public QObject {
    Q_OBJECT
private slots:
    void everyFileKeepsTheInvariants_data() {
        QTest::addColumn<QString>("path");
        for (const auto& entry :
             std::filesystem::directory_iterator(CLOTHLAB_SOURCE_DIR "/tests/fuzz/corpus_take"))
            QTest::newRow(entry.path().filename().c_str()) << QString::fromStdString(entry.path().string());
    }
    void everyFileKeepsTheInvariants() {
        QFETCH(QString, path);
        const auto reading = clothlab::readTakeFile(path.toStdString());
        QCOMPARE(QString::fromStdString(clothlab::test::brokenTakeFileInvariant(reading)), QString());
    }
};

QTEST_APPLESS_MAIN(TestFuzzCorpusTake)
#include "tst_fuzz_corpus_take.moc"
