// What a recording says of itself: written and read, and what is not known is kept.
#include "simcore/recording/take_meta.h"

#include <QtTest>

using namespace clothlab;

class TestTakeMeta : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsRead() {
        TakeMeta meta;
        meta.version = "1.2.3";
        meta.error = 1e-4;
        meta.activeTake = 7;
        meta.shownFrame = 123;
        meta.markers = {{7, 0, "a \"quoted\"\nname, ü"}, {1, 99, ""}};
        meta.ranges = {{7, 3, 50}};
        meta.unknownKeys = R"({"camera": {"x": 1.50}, "later": [1, 2]})";
        const auto read = readMeta(writeMeta(meta));
        QVERIFY(read);
        QVERIFY(*read == meta);
        QCOMPARE(QString::fromStdString(writeMeta(*read)), QString::fromStdString(writeMeta(meta)));
    }
    void whatIsWrongIsLeftOut() {
        const auto read = readMeta(R"({"error": "small", "active_take": -1, "shown_frame": 1.5, "markers":
            [3, {"take": 1}, {"take": 2, "frame": 4, "name": 5}], "ranges": [{"take": 1, "in": 5, "out": 4}]})");
        QVERIFY(read);
        TakeMeta expected;
        expected.markers = {{2, 4, ""}};
        QVERIFY(*read == expected);
    }
    void otherTextIsRefused() {
        for (const char* text : {"", "[]", "{", "{\"a\": 1, \"a\": 2}", "3"})
            QVERIFY(!readMeta(text));
    }
};

QTEST_APPLESS_MAIN(TestTakeMeta)
#include "tst_take_meta.moc"
