#include "app/widgets/number_text.h"

#include <QRandomGenerator>
#include <QTest>

#include <bit>
#include <cmath>
#include <limits>

using namespace clothlab;

class TestNumberText : public QObject {
    Q_OBJECT

private slots:
    void isShort_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("zero") << 0.0 << "0";
        QTest::newRow("negative zero") << -0.0 << "0";
        QTest::newRow("whole") << 5000.0 << "5000";
        QTest::newRow("large whole") << 2500000.0 << "2500000";
        QTest::newRow("very large") << 1e12 << "1e12";
        QTest::newRow("third") << 1.0 / 3 << "0.333333";
        QTest::newRow("frame") << 1.0 / 90 << "0.0111111";
        QTest::newRow("no noise") << 0.1 + 0.2 << "0.3";
        QTest::newRow("six digits") << 12345.678 << "12345.7";
        QTest::newRow("large with decimals") << 1234567.8 << "1.23457e6";
        QTest::newRow("rounds up a digit") << 999999.9 << "1e6";
        QTest::newRow("small") << 0.00015 << "0.00015";
        QTest::newRow("very small") << 1.5e-7 << "1.5e-7";
        QTest::newRow("negative") << -0.25 << "-0.25";
        QTest::newRow("infinite") << -std::numeric_limits<double>::infinity() << "-inf";
        QTest::newRow("not a number") << std::nan("") << "nan";
    }

    void isShort() {
        QFETCH(double, value);
        QFETCH(QString, text);
        QCOMPARE(shortText(value), text);
    }

    void exactReadsBack() {
        QCOMPARE(exactText(0.1), QStringLiteral("0.1"));
        QCOMPARE(exactText(1.0 / 90), QStringLiteral("0.011111111111111112"));
        QCOMPARE(exactText(1e15), QStringLiteral("1e15"));
        QCOMPARE(exactText(-12.5), QStringLiteral("-12.5"));
        const quint32 seed = 20;
        QRandomGenerator random(seed);
        for (int i = 0; i < 20000; ++i) {
            const double value = std::bit_cast<double>(random.generate64());
            if (std::isfinite(value)) {
                QVERIFY2(exactText(value).toDouble() == value, qPrintable(exactText(value)));
            }
        }
    }

    void rounds() {
        QCOMPARE(roundedToDigits(0.1 + 0.2, 12), 0.3);
        QCOMPARE(roundedToDigits(123456, 3), 123000.0);
        QCOMPARE(roundedToDigits(-0.0012349, 4), -0.001235);
        QCOMPARE(roundedToDigits(0, 3), 0.0);
        QVERIFY(std::isinf(roundedToDigits(std::numeric_limits<double>::infinity(), 3)));
    }
};

QTEST_GUILESS_MAIN(TestNumberText)
#include "tst_number_text.moc"
