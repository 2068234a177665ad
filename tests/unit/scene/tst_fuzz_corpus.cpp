// What the fuzzer starts from and what it once found, as an ordinary test.
#include "tests/support/scene_invariants.h"
#include "tests/support/scene_text.h"

#include <QTest>

#include <filesystem>

class TestFuzzCorpus : public QObject {
    Q_OBJECT
private slots:
    void everyFileKeepsTheInvariants_data() {
        QTest::addColumn<QString>("path");
        for (const auto& entry :
             std::filesystem::directory_iterator(CLOTHLAB_SOURCE_DIR "/tests/fuzz/corpus_scene"))
            QTest::newRow(entry.path().filename().c_str()) << QString::fromStdString(entry.path().string());
    }
    void everyFileKeepsTheInvariants() {
        QFETCH(QString, path);
        const std::string text = clothlab::test::readText(path.toStdString());
        QCOMPARE(QString::fromStdString(clothlab::test::brokenInvariant(text)), QString());
    }
};

QTEST_APPLESS_MAIN(TestFuzzCorpus)
#include "tst_fuzz_corpus.moc"
