#include "app/cli/output_path.h"

#include <QTest>

using clothlab::cli::OutputPath;

class TestOutputPath : public QObject {
    Q_OBJECT
private slots:
    void names_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("sequence");
        QTest::addColumn<int>("frame");
        QTest::addColumn<QString>("name");
        QTest::newRow("plain") << "a.obj" << false << 7 << "a.obj";
        QTest::newRow("empty") << "" << false << 7 << "";
        QTest::newRow("%d") << "a_%d.obj" << true << 7 << "a_7.obj";
        QTest::newRow("%04d") << "a_%04d.obj" << true << 7 << "a_0007.obj";
        QTest::newRow("%04d of zero") << "a_%04d.obj" << true << 0 << "a_0000.obj";
        QTest::newRow("longer than its width") << "%02d.csv" << true << 12345 << "12345.csv";
        QTest::newRow("%01d") << "%01d" << true << 3 << "3";
        QTest::newRow("%09d") << "%09d" << true << 3 << "000000003";
        QTest::newRow("percent sign") << "100%%.obj" << false << 1 << "100%.obj";
        QTest::newRow("percent signs around") << "%%d%d%%.obj" << true << 5 << "%d5%.obj";
        QTest::newRow("folder") << "d%d/a.obj" << true << 2 << "d2/a.obj";
        QTest::newRow("no ASCII") << QStringLiteral("tücher/%d–ü.obj") << true << 2
                                  << QStringLiteral("tücher/2–ü.obj");
        QTest::newRow("markers of Qt") << "%%1%d%%2" << true << 4 << "%14%2";
    }
    void names() {
        QFETCH(QString, text);
        QFETCH(bool, sequence);
        QFETCH(int, frame);
        QFETCH(QString, name);
        const auto path = OutputPath::parse(text);
        QVERIFY(path.has_value());
        QCOMPARE(path->isSequence(), sequence);
        QCOMPARE(path->forFrame(frame), name);
        QCOMPARE(path->forFrame(frame + 1) == name, !sequence);
    }

    void whatIsRefused_data() {
        QTest::addColumn<QString>("text");
        for (const char* text :
             {"%", "a%", "%.obj", "%s.obj", "%x", "%4d.obj", "%-4d", "%+d", "%00d", "%010d", "%i", "%ld",
              "%d%d.obj", "%d_%04d.obj", "%%%", "% d", "%0", "%04", "%D"})
            QTest::newRow(text) << text;
    }
    void whatIsRefused() {
        QFETCH(QString, text);
        QVERIFY(!OutputPath::parse(text));
    }

    void framesSortAsTheirNames() {
        const auto path = OutputPath::parse("f%05d.obj");
        QVERIFY(path.has_value());
        for (int frame = 0; frame < 2000; ++frame)
            QVERIFY(path->forFrame(frame) < path->forFrame(frame + 1));
    }
};

QTEST_APPLESS_MAIN(TestOutputPath)
#include "tst_output_path.moc"
