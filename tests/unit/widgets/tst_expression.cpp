#include "app/widgets/expression.h"

#include <QTest>

#include <cmath>
#include <numbers>

using clothlab::evaluateExpression;
using clothlab::ExpressionResult;

class TestExpression : public QObject {
    Q_OBJECT

private slots:
    void givesTheValue_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("integer") << "42" << 42.0;
        QTest::newRow("nearest double") << "0.1" << 0.1;
        QTest::newRow("17 digits") << "0.30000000000000004" << 0.30000000000000004;
        QTest::newRow("comma") << "0,25" << 0.25;
        QTest::newRow("no leading zero") << ".5" << 0.5;
        QTest::newRow("no decimals") << "5." << 5.0;
        QTest::newRow("exponent") << "1e-3" << 1e-3;
        QTest::newRow("large exponent") << "2.5E+7" << 2.5e7;
        QTest::newRow("sign") << "-3" << -3.0;
        QTest::newRow("signs") << "--3" << 3.0;
        QTest::newRow("plus sign") << "+3" << 3.0;
        QTest::newRow("fraction") << "1/90" << 1.0 / 90;
        QTest::newRow("pi") << "2*pi" << 2 * std::numbers::pi;
        QTest::newRow("e") << "e" << std::numbers::e;
        QTest::newRow("any case") << "2*PI" << 2 * std::numbers::pi;
        QTest::newRow("greek") << QStringLiteral("2*π") << 2 * std::numbers::pi;
        QTest::newRow("typographic minus") << QStringLiteral("−2") << -2.0;
        QTest::newRow("sum from the left") << "10-4-3" << 3.0;
        QTest::newRow("quotient from the left") << "16/4/2" << 2.0;
        QTest::newRow("product before sum") << "2+3*4" << 14.0;
        QTest::newRow("parentheses") << "(2+3)*4" << 20.0;
        QTest::newRow("power before product") << "2*3^2" << 18.0;
        QTest::newRow("power from the right") << "2^3^2" << 512.0;
        QTest::newRow("power before sign") << "-2^2" << -4.0;
        QTest::newRow("negative exponent") << "2^-1" << 0.5;
        QTest::newRow("product with a sign") << "2*-3" << -6.0;
        QTest::newRow("root") << "sqrt(2)/2" << std::sqrt(2.0) / 2;
        QTest::newRow("spaces") << "  1 +\t2 " << 3.0;
        QTest::newRow("e after a number is an exponent") << "2e3" << 2000.0;
        QTest::newRow("nested as deep as allowed") << QString(63, u'(') + "1" + QString(63, u')') << 1.0;
    }

    void givesTheValue() {
        QFETCH(QString, text);
        QFETCH(double, value);
        const ExpressionResult result = evaluateExpression(text);
        QVERIFY2(result.ok(), qPrintable(result.error));
        QVERIFY2(result.value == value, qPrintable(QString::number(result.value, 'g', 17)));
    }

    void saysWhatIsWrong_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("part");
        QTest::newRow("empty") << ""
                               << "missing";
        QTest::newRow("spaces only") << "   "
                                     << "missing";
        QTest::newRow("word") << "heavy"
                              << "heavy";
        QTest::newRow("operator at the end") << "2+"
                                             << "missing at the end";
        QTest::newRow("operator at the start") << "*2"
                                               << "*";
        QTest::newRow("two points") << "1.2.3"
                                    << ".";
        QTest::newRow("thousands and decimals") << "1,000.5"
                                                << ".";
        QTest::newRow("two numbers") << "1 2"
                                     << "2";
        QTest::newRow("open parenthesis") << "(1+2"
                                          << ")";
        QTest::newRow("closing parenthesis") << "1+2)"
                                             << ")";
        QTest::newRow("root without parentheses") << "sqrt 2"
                                                  << "2";
        QTest::newRow("bare root") << "sqrt+2"
                                   << "parentheses";
        QTest::newRow("point alone") << "."
                                     << ".";
        QTest::newRow("exponent without digits") << "2e"
                                                 << "e";
        QTest::newRow("division by zero") << "1/0"
                                          << "finite";
        QTest::newRow("zero by zero") << "0/0"
                                      << "finite";
        QTest::newRow("root of a negative") << "sqrt(-1)"
                                            << "finite";
        QTest::newRow("overflow") << "10^400"
                                  << "finite";
        QTest::newRow("number too large") << "1e999"
                                          << "too large";
        QTest::newRow("infinity is no name") << "inf"
                                             << "inf";
        QTest::newRow("foreign letter") << QStringLiteral("2µ") << QStringLiteral("µ");
        QTest::newRow("one too deep") << QString(64, u'(') + "1" + QString(64, u')') << "deep";
        QTest::newRow("very deep") << QString(900, u'(') << "deep";
        QTest::newRow("many signs") << QString(900, u'-') + "1"
                                    << "deep";
        QTest::newRow("very long") << QString(100000, u'1') << "long";
    }

    void saysWhatIsWrong() {
        QFETCH(QString, text);
        QFETCH(QString, part);
        const ExpressionResult result = evaluateExpression(text);
        QVERIFY(!result.ok());
        QCOMPARE(result.value, 0.0);
        QVERIFY2(result.error.contains(part), qPrintable(result.error));
    }
};

QTEST_GUILESS_MAIN(TestExpression)
#include "tst_expression.moc"
