// What all writers of frames have in common: whole files or none, words for trouble, sequences, last frames.
#include "simcore/export/frame_writer.h"
#include "tests/support/export_frames.h"

#include <QtTest>

using namespace clothlab;
using test::bytesOfFile;
using test::sampleFrames;

namespace {

using Trouble = std::optional<std::string>;

// begin() and add() without finish().
Trouble put(FrameWriter& writer, const std::vector<FramePointer>& frames) {
    if (auto trouble = writer.begin(test::sheetOf(*frames.front()), int(frames.size())))
        return trouble;
    for (const FramePointer& frame : frames)
        if (auto trouble = writer.add(frame))
            return trouble;
    return std::nullopt;
}

} // namespace

class TestFrameWriters : public QObject {
    Q_OBJECT
private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void nothingIsThereBeforeTheEnd_data() { formats(); }
    void nothingIsThereBeforeTheEnd() {
        const auto writer = make();
        QVERIFY(!put(*writer, sampleFrames(3)));
        for (const QString& name : files())
            QVERIFY2(name.startsWith(".clothlab-"), qPrintable(name));
        QVERIFY(!writer->finish());
        QCOMPARE(files(), expected());
    }

    void whatIsDroppedIsGone_data() { formats(); }
    void whatIsDroppedIsGone() {
        QFile before(in("run." + ending()));
        QVERIFY(before.open(QFile::WriteOnly) && before.write("before") == 6);
        before.close();
        QVERIFY(!put(*make(), sampleFrames(3)));
        QCOMPARE(files(), QStringList{"run." + ending()});
        QCOMPARE(bytesOfFile(path()), std::string("before"));
    }

    void aDiskThatFillsUp_data() { formats(); }
    void aDiskThatFillsUp() {
        const auto writer = make();
        {
            const test::FileSizeLimit limit(ending() == "measures.csv" ? 100 : 20'000);
            Trouble trouble = put(*writer, sampleFrames(9, 40, 40));
            if (!trouble)
                trouble = writer->finish();
            QVERIFY(trouble.has_value());
            QVERIFY2(trouble->starts_with(path() + ": ") && trouble->find("disk") != std::string::npos,
                     trouble->c_str());
            QCOMPARE(writer->finish(), trouble); // and says it again
            QCOMPARE(writer->add(sampleFrames(1).front()), trouble);
        }
        QCOMPARE(files(), QStringList());
    }

    void aFolderThatIsNotThere_data() { formats(); }
    void aFolderThatIsNotThere() {
        const auto writer = make("none/run.");
        Trouble trouble = put(*writer, sampleFrames(2));
        if (!trouble)
            trouble = writer->finish();
        QVERIFY(trouble.has_value());
        QVERIFY2(trouble->starts_with(path("none/run.") + ": ") &&
                     trouble->find("no such file") != std::string::npos,
                 trouble->c_str());
        QCOMPARE(files(), QStringList());
    }

    void wrongCallsAreTold_data() { formats(); }
    void wrongCallsAreTold() {
        const auto frames = sampleFrames(3);
        const auto tells = [&](const Trouble& trouble, const char* words) {
            return trouble && trouble->starts_with(path() + ": ") &&
                   trouble->find(words) != std::string::npos;
        };
        QVERIFY(tells(make()->add(frames[0]), "points"));
        QVERIFY(tells(make()->finish(), "no frame"));
        auto writer = make();
        QVERIFY(!put(*writer, {frames[0], frames[1]}));
        QVERIFY(tells(writer->add(frames[2]), "more frames"));
        writer = make();
        QVERIFY(!writer->begin(test::sheetOf(*frames[0]), 5));
        QVERIFY(tells(writer->add(sampleFrames(1, 4, 5 + 1)[0]), "points"));
        QCOMPARE(files(), QStringList());
        writer = make();
        QVERIFY(!put(*writer, frames));
        QVERIFY(!writer->finish());
        QVERIFY(tells(writer->finish(), "finished"));
        QCOMPARE(files(), expected());
    }

    void theLastFrameAlone() {
        for (const char* name : {"a.obj", "a.ply", "a.csv"}) {
            const auto format = *exportFormat(name);
            const auto frames = sampleFrames(3);
            const auto writer = makeFrameWriter(format, in(name).toStdString(), {{UpAxis::Z, 2}, true});
            QVERIFY(!put(*writer, frames));
            QVERIFY(!writer->finish());
            QVERIFY(!exportFrame(*frames.back(), format, in("b").toStdString(), {UpAxis::Z, 2}));
            QVERIFY(bytesOfFile(in(name).toStdString()) == bytesOfFile(in("b").toStdString()));
        }
    }

    void aSequenceKeepsWhatItHas() {
        const auto frames = sampleFrames(3);
        const auto pathOf = [&](int frame) { return in(QString("f%1.ply").arg(frame)).toStdString(); };
        auto writer = makeSequenceWriter(ExportFormat::Ply, pathOf, {UpAxis::Z, 2});
        QVERIFY(!put(*writer, frames));
        writer.reset();
        QCOMPARE(files(), QStringList({"f0.ply", "f1.ply", "f2.ply"}));
        for (int i = 0; i < 3; ++i) {
            QVERIFY(!exportFrame(*frames[std::size_t(i)], ExportFormat::Ply, in("b").toStdString(),
                                 {UpAxis::Z, 2}));
            QVERIFY(bytesOfFile(pathOf(i)) == bytesOfFile(in("b").toStdString()));
        }
        QVERIFY(QDir(m_folder->path()).mkdir("g1.ply"));
        const auto other = [&](int frame) { return in(QString("g%1.ply").arg(frame)).toStdString(); };
        const Trouble trouble = put(*makeSequenceWriter(ExportFormat::Ply, other), frames);
        QVERIFY(trouble && trouble->starts_with(other(1) + ": is a folder"));
        QVERIFY(QFile::exists(in("g0.ply")) && !QFile::exists(in("g2.ply")));
    }

private:
    static void formats() {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"obj", "ply", "csv", "pc2", "mdd", "glb", "measures.csv"})
            QTest::newRow(ending) << ending;
    }
    static QString ending() { return *static_cast<QString*>(QTest::qData("ending", qMetaTypeId<QString>())); }
    QStringList expected() const { return QStringList{"run." + ending()}; }

    QString in(const QString& name) const { return m_folder->filePath(name); }
    std::string path(const QString& name = "run.") const { return in(name + ending()).toStdString(); }
    // Without a mesh beside it.
    std::unique_ptr<FrameWriter> make(const QString& name = "run.") const {
        if (ending() == "measures.csv")
            return makeMeasuresWriter(path(name));
        return makeFrameWriter(*exportFormat(path(name)), path(name), {{}, false});
    }
    QStringList files() const {
        return QDir(m_folder->path())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(TestFrameWriters)
#include "tst_frame_writers.moc"
