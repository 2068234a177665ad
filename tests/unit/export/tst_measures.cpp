// The CSV with a row for each frame.
#include "simcore/export/frame_writer.h"
#include "simcore/inspect/inspect.h"
#include "tests/support/export_frames.h"

#include <QtTest>

#include <sstream>

using namespace clothlab;

class TestMeasures : public QObject {
    Q_OBJECT
private slots:
    void aRowAFrame() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("a.csv").toStdString();
        const auto frames = test::sampleFrames(4);
        const Sheet sheet = test::sheetOf(*frames.front());
        const auto writer = makeMeasuresWriter(path);
        QVERIFY(!writer->begin(sheet, 100));
        for (const FramePointer& frame : frames)
            QVERIFY(!writer->add(frame));
        QVERIFY(!writer->finish());

        std::istringstream in(test::bytesOfFile(path));
        std::string line;
        std::getline(in, line);
        QCOMPARE(line, std::string("frame,time,kinetic_energy,potential_energy,max_strain_structural,"
                                   "max_strain_shearing,max_strain_bending,strain_limit_corrections"));
        for (int i = 0; i < 4; ++i) {
            const Frame& frame = *frames[std::size_t(i)];
            const auto strain = maxStrain(sheet, frame.state.position);
            const std::vector<double> expected{double(i),
                                               i / 90.0,
                                               kineticEnergy(*frame.scene, frame.state),
                                               potentialEnergy(*frame.scene, sheet, frame.state.position),
                                               strain[0],
                                               strain[1],
                                               strain[2],
                                               3.0 * i};
            std::getline(in, line);
            std::vector<double> row;
            for (const QString& cell : QString::fromStdString(line).split(','))
                row.push_back(cell.toDouble());
            QVERIFY2(row == expected, line.c_str());
            QVERIFY(strain[0] != strain[1] && strain[1] != strain[2]);
        }
        QVERIFY(!std::getline(in, line));
    }
};

QTEST_APPLESS_MAIN(TestMeasures)
#include "tst_measures.moc"
