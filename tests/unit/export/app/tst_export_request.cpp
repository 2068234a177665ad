// What an export will write, before it does.
#include "app/export/export_request.h"
#include "tests/support/export_frames.h"
#include "tests/support/video.h"

#include <QtTest>

using namespace clothlab;

class TestExportRequest : public QObject {
    Q_OBJECT
private slots:
    void namesOfASequence() {
        QCOMPARE(sequencePath("/a/run.obj", 7, 10), "/a/run_0007.obj");
        QCOMPARE(sequencePath("/a/run.obj", 7, 10'000), "/a/run_0007.obj");
        QCOMPARE(sequencePath("/a/run.obj", 7, 10'001), "/a/run_00007.obj");
        QCOMPARE(sequencePath("/a.b/50% %d.obj", 0, 1), "/a.b/50% %d_0000.obj");
    }

    void filesThatAreWritten() {
        ExportRequest request;
        request.path = "/a/run.ply";
        request.kind = ExportKind::PlyFiles;
        request.frames = {2, 9, 3};
        QCOMPARE(filesOf(request), QStringList({"/a/run_0000.ply", "/a/run_0001.ply", "/a/run_0002.ply"}));
        request.kind = ExportKind::Mdd;
        request.path = "/a/run.MDD";
        QCOMPARE(filesOf(request), QStringList({"/a/run.MDD", "/a/run.obj"}));
        request.kind = ExportKind::Mp4;
        request.path = "/a/run.mp4";
        QCOMPARE(filesOf(request), QStringList{"/a/run.mp4"});
    }

    void videoIsInRealTime() {
        for (const auto& [recorded, step] :
             {std::pair(90, 3), {60, 1}, {24, 1}, {120, 4}, {61, 2}, {1000, 33}})
            QCOMPARE(videoStep(recorded), step);
    }

    // Within a third of what comes out.
    void sizesAreNearWhatComesOut_data() {
        QTest::addColumn<int>("kind");
        for (const ExportKind kind :
             {ExportKind::ObjFiles, ExportKind::PlyFiles, ExportKind::CsvFiles, ExportKind::Measures,
              ExportKind::Pc2, ExportKind::Mdd, ExportKind::Glb})
            QTest::newRow(qPrintable(title(kind))) << int(kind);
    }
    void sizesAreNearWhatComesOut() {
        QFETCH(int, kind);
        const QTemporaryDir folder;
        ExportRequest request;
        request.kind = ExportKind(kind);
        request.path = folder.filePath("run") + ending(request.kind);
        request.frames = {0, 19, 1};
        const auto frames = test::sampleFrames(20, 40, 30);
        const Sheet sheet = test::sheetOf(*frames.front());
        const FrameSource source{20, sheet,
                                 [&](int frame, std::string&) { return frames[std::size_t(frame)]; }};
        const std::atomic<bool> stop{false};
        const auto writer = makeWriter(request, nullptr, stop);
        QVERIFY(runExport(source, request.frames, *writer, stop).end == ExportEnd::Done);
        double bytes = 0;
        for (const QString& file : filesOf(request))
            bytes += double(QFileInfo(file).size());
        const double ratio = estimatedBytes(request, sheet.grid) / bytes;
        QVERIFY2(ratio > 2.0 / 3 && ratio < 1.5, qPrintable(QString::number(ratio)));
    }

    void videoNeedsFfmpeg() {
        const QTemporaryDir folder;
        const test::FakeFfmpeg none(folder.path(), {});
        QVERIFY(whyNot(ExportKind::Mp4).contains("apt install ffmpeg"));
        QVERIFY(!whyNot(ExportKind::WebM).isEmpty());
        QVERIFY(whyNot(ExportKind::PngFiles).isEmpty() && whyNot(ExportKind::Glb).isEmpty());
    }

    void everyKindHasItsRow() {
        for (int i = 0; i < kExportKinds; ++i) {
            const auto kind = ExportKind(i);
            QVERIFY(!title(kind).isEmpty() && !about(kind).isEmpty() && ending(kind).startsWith('.'));
            QCOMPARE(isVideo(kind), kind == ExportKind::Mp4 || kind == ExportKind::WebM);
            QCOMPARE(hasPictures(kind), isVideo(kind) || kind == ExportKind::PngFiles);
            QVERIFY(!(hasPictures(kind) && hasPlacement(kind)));
        }
        QVERIFY(!hasPlacement(ExportKind::Glb)); // which says itself what it is in
    }
};

QTEST_GUILESS_MAIN(TestExportRequest)
#include "tst_export_request.moc"
