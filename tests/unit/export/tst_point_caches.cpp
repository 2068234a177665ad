// PC2 and MDD byte by byte, and the mesh beside them.
#include "simcore/export/frame_writer.h"
#include "tests/support/export_frames.h"

#include <QtTest>

#include <sstream>

using namespace clothlab;
using test::ByteReader;
using test::bytesOfFile;
using test::sampleFrames;

class TestPointCaches : public QObject {
    Q_OBJECT
private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void pc2_data() { counts(); }
    void pc2() {
        QFETCH(int, count);
        QFETCH(int, expected);
        const auto frames = sampleFrames(count);
        write("a.pc2", frames, expected);
        ByteReader bytes(bytesOfFile(in("a.pc2")));
        QCOMPARE(bytes.text(12), std::string("POINTCACHE2\0", 12));
        QCOMPARE(bytes.little(), 1U);
        QCOMPARE(bytes.little(), 20U);
        QVERIFY(test::sameFloat(bytes.littleFloat(), 0.0F));
        QVERIFY(test::sameFloat(bytes.littleFloat(), 1.0F));
        QCOMPARE(bytes.little(), std::uint32_t(count));
        QCOMPARE(bytes.at(), std::size_t(32));
        for (const FramePointer& frame : frames)
            for (int i = 0; i < 20; ++i)
                for (const double value : frame->state.position.at(i))
                    QVERIFY(test::sameFloat(bytes.littleFloat(), float(value)));
        QVERIFY(bytes.atEnd());
    }

    void mdd_data() { counts(); }
    void mdd() {
        QFETCH(int, count);
        QFETCH(int, expected);
        const auto frames = sampleFrames(count);
        write("a.mdd", frames, expected);
        ByteReader bytes(bytesOfFile(in("a.mdd")));
        QCOMPARE(bytes.big(), std::uint32_t(count));
        QCOMPARE(bytes.big(), 20U);
        for (int frame = 0; frame < count; ++frame)
            QVERIFY(test::sameFloat(bytes.bigFloat(), float(frame / 90.0)));
        for (const FramePointer& frame : frames)
            for (int i = 0; i < 20; ++i)
                for (const double value : frame->state.position.at(i))
                    QVERIFY(test::sameFloat(bytes.bigFloat(), float(value)));
        QVERIFY(bytes.atEnd());
    }

    void axisAndScale() {
        const auto frames = sampleFrames(2);
        write("a.pc2", frames, 2, {{UpAxis::Z, 100}, true});
        write("a.mdd", frames, 2, {{UpAxis::Z, 100}, true});
        ByteReader pc2(bytesOfFile(in("a.pc2")), 32);
        ByteReader mdd(bytesOfFile(in("a.mdd")), 8 + 2 * 4);
        for (const FramePointer& frame : frames)
            for (int i = 0; i < 20; ++i) {
                const Vec3 p = frame->state.position.at(i);
                for (const double value : {100 * p.x(), -100 * p.z(), 100 * p.y()}) {
                    QVERIFY(test::sameFloat(pc2.littleFloat(), float(value)));
                    QVERIFY(test::sameFloat(mdd.bigFloat(), float(value)));
                }
            }
        QVERIFY(pc2.atEnd() && mdd.atEnd());
    }

    // The times that were not needed leave no gap, even if there is more after them than is moved at once.
    void manyFewerFramesThanAnnounced() {
        const auto frames = sampleFrames(3, 200, 170);
        write("a.mdd", frames, 1'000'000);
        ByteReader bytes(bytesOfFile(in("a.mdd")));
        QCOMPARE(bytes.big(), 3U);
        QCOMPARE(bytes.big(), 34'000U);
        bytes.text(3 * std::size_t(4));
        for (const FramePointer& frame : frames)
            for (int i = 0; i < 34'000; ++i)
                for (const double value : frame->state.position.at(i))
                    if (const float number = bytes.bigFloat(); number != float(value))
                        QFAIL("a point moved");
        QVERIFY(bytes.atEnd());
    }

    void theFirstFrameIsBesideIt() {
        const auto frames = sampleFrames(3);
        const ExportSettings settings{{UpAxis::Z, 100}, true};
        std::ostringstream obj;
        writeObj(obj, *frames.front(), settings.placement);
        for (const char* name : {"a.pc2", "b.MDD"}) {
            const std::string mesh = meshBesidePath(in(name));
            QCOMPARE(mesh, in(std::string(1, name[0]) + ".obj"));
            write(name, frames, 3, settings);
            QVERIFY(bytesOfFile(mesh) == obj.str());
        }
    }

    void trouble_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("pc2") << "a.pc2";
        QTest::newRow("mdd") << "a.mdd";
    }
    // With its mesh: both or none, and words about the right one.
    void trouble() {
        QFETCH(QString, name);
        const auto frames = sampleFrames(2, 30, 30);
        {
            const test::FileSizeLimit limit(8000);
            const auto writer = makeFrameWriter(*exportFormat(name.toStdString()), in(name.toStdString()));
            QVERIFY(!writer->begin(test::sheetOf(*frames[0]), 2));
            const auto trouble = writer->add(frames[0]);
            QVERIFY(trouble && trouble->starts_with(in(name.toStdString()) + ": its mesh " + in("a.obj: ")));
        }
        QVERIFY(QDir(m_folder->path()).isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden));
        const auto writer = makeFrameWriter(*exportFormat(name.toStdString()), in(name.toStdString()));
        QVERIFY(!writer->begin(test::sheetOf(*frames[0]), 2) && !writer->add(frames[0]));
        QVERIFY(!QFile::exists(m_folder->filePath("a.obj")));
    }

private:
    static void counts() {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("expected");
        QTest::newRow("as announced") << 5 << 5;
        QTest::newRow("fewer") << 3 << 500;
        QTest::newRow("one") << 1 << 1;
    }
    std::string in(const std::string& name) const {
        return m_folder->filePath(QString::fromStdString(name)).toStdString();
    }
    void write(const std::string& name, const std::vector<FramePointer>& frames, int expected,
               const ExportSettings& settings = {}) const {
        const auto writer = makeFrameWriter(*exportFormat(name), in(name), settings);
        QVERIFY(!writer->begin(test::sheetOf(*frames.front()), expected));
        for (const FramePointer& frame : frames)
            QVERIFY(!writer->add(frame));
        QVERIFY(!writer->finish());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(TestPointCaches)
#include "tst_point_caches.moc"
