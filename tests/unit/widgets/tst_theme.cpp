#include "app/widgets/theme.h"

#include <QApplication>
#include <QPalette>
#include <QRegularExpression>
#include <QTest>

#include <cmath>

using namespace clothlab;

namespace {

constexpr double kText = 4.5; // WCAG 2.1, level AA
constexpr double kGraphics = 3.0;
constexpr double kDisabled = 2.5;

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a) + 0.05;
    const double lb = luminance(b) + 0.05;
    return la > lb ? la / lb : lb / la;
}

struct Pair {
    const char* name;
    QColor ThemeColors::*front;
    QColor ThemeColors::*back;
    double least;
};

using C = ThemeColors;

const Pair kPairs[] = {
    {"text on window", &C::text, &C::window, kText},
    {"text on panel", &C::text, &C::panel, kText},
    {"text on field", &C::text, &C::field, kText},
    {"text on every other row", &C::text, &C::alternate, kText},
    {"text on hover", &C::text, &C::hover, kText},
    {"text on pressed", &C::text, &C::pressed, kText},
    {"text on checked", &C::text, &C::checked, kText},
    {"text on tooltip", &C::text, &C::toolTip, kText},
    {"dim text on window", &C::dimText, &C::window, kText},
    {"dim text on panel", &C::dimText, &C::panel, kText},
    {"dim text on field", &C::dimText, &C::field, kText},
    {"dim text on every other row", &C::dimText, &C::alternate, kText},
    {"selected text", &C::highlightText, &C::highlight, kText},
    {"text on accent", &C::accentText, &C::accent, kText},
    {"link on window", &C::link, &C::window, kText},
    {"link on panel", &C::link, &C::panel, kText},
    {"link on field", &C::link, &C::field, kText},
    {"warning on window", &C::warning, &C::window, kText},
    {"warning on panel", &C::warning, &C::panel, kText},
    {"warning on field", &C::warning, &C::field, kText},
    {"error on window", &C::error, &C::window, kText},
    {"error on panel", &C::error, &C::panel, kText},
    {"error on field", &C::error, &C::field, kText},
    {"disabled text on window", &C::disabledText, &C::window, kDisabled},
    {"disabled text on panel", &C::disabledText, &C::panel, kDisabled},
    {"accent on window", &C::accent, &C::window, kGraphics},
    {"accent on panel", &C::accent, &C::panel, kGraphics},
    {"accent on field", &C::accent, &C::field, kGraphics},
    {"checked icon", &C::accent, &C::checked, kGraphics},
    {"point on panel", &C::point, &C::panel, kGraphics},
    {"pinned on panel", &C::pinned, &C::panel, kGraphics},
    {"selected on panel", &C::selected, &C::panel, kGraphics},
    {"structural on panel", &C::structural, &C::panel, kGraphics},
    {"bending on panel", &C::bending, &C::panel, kGraphics},
};

} // namespace

class TestTheme : public QObject {
    Q_OBJECT

private slots:
    void contrastIsMeasuredRight() {
        QVERIFY(qAbs(contrast(Qt::white, Qt::black) - 21) < 1e-9);
        QVERIFY(qAbs(contrast(QColor(0x77, 0x77, 0x77), Qt::white) - 4.48) < 0.01);
    }

    void isReadable_data() {
        QTest::addColumn<int>("theme");
        QTest::newRow("dark") << int(Theme::Dark);
        QTest::newRow("light") << int(Theme::Light);
    }

    void isReadable() {
        QFETCH(int, theme);
        const ThemeColors& colors = themeColors(Theme(theme));
        for (const Pair& pair : kPairs) {
            const double found = contrast(colors.*pair.front, colors.*pair.back);
            QVERIFY2(found >= pair.least, qPrintable(QStringLiteral("%1: %2 : 1").arg(pair.name).arg(found)));
        }
    }

    void shearingStandsOutInTheDark() {
        // Its orange is the same everywhere by decree and can't reach 3 : 1 on white.
        const ThemeColors& dark = themeColors(Theme::Dark);
        QVERIFY(contrast(dark.shearing, dark.panel) >= kGraphics);
        const ThemeColors& light = themeColors(Theme::Light);
        QVERIFY(contrast(light.shearing, light.panel) >= 2);
    }

    void lightKeepsTheColorsOfSprings() {
        const ThemeColors& light = themeColors(Theme::Light);
        QCOMPARE(light.structural, QColor(0x00, 0x72, 0xB2));
        QCOMPARE(light.shearing, QColor(0xE6, 0x9F, 0x00));
        QCOMPARE(light.bending, QColor(0x00, 0x9E, 0x73));
    }

    void everyColorIsSet() {
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            const ThemeColors& c = themeColors(theme);
            for (const QColor& color :
                 {c.window,     c.panel,     c.field,         c.alternate, c.hover,        c.pressed,
                  c.border,     c.separator, c.text,          c.dimText,   c.disabledText, c.accent,
                  c.accentText, c.highlight, c.highlightText, c.checked,   c.link,         c.toolTip,
                  c.structural, c.shearing,  c.bending,       c.point,     c.pinned,       c.selected,
                  c.warning,    c.error}) {
                QVERIFY(color.isValid());
                QCOMPARE(color.alpha(), 255);
            }
        }
    }

    void styleSheetIsFilledIn() {
        const QString dark = themeStyleSheet(Theme::Dark);
        const QString light = themeStyleSheet(Theme::Light);
        QVERIFY(dark.contains(themeColors(Theme::Dark).accent.name()));
        QVERIFY(!dark.contains(u'@'));
        QVERIFY(!light.contains(u'@'));
        QVERIFY(dark != light);
    }

    void styleSheetFindsItsFiles() {
        static const QRegularExpression url(QStringLiteral("url\\(([^)]*)\\)"));
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            int count = 0;
            for (auto it = url.globalMatch(themeStyleSheet(theme)); it.hasNext(); ++count) {
                const QString file = it.next().captured(1);
                QVERIFY2(QFile::exists(file), qPrintable(file));
            }
            QVERIFY(count > 10);
        }
    }

    void styleSheetIsUnderstood() {
        QVERIFY(!parseComplaint(QStringLiteral("QWidget { color: ")).isEmpty()); // it would be noticed
        QCOMPARE(parseComplaint(themeStyleSheet(Theme::Dark)), QString());
    }

    void appliesAndSwitches() {
        applyTheme(*qApp, Theme::Light);
        QCOMPARE(currentTheme(), Theme::Light);
        QCOMPARE(QApplication::palette().color(QPalette::Window), themeColors(Theme::Light).window);
        applyTheme(*qApp, Theme::Dark);
        QCOMPARE(currentTheme(), Theme::Dark);
        const QPalette palette = QApplication::palette();
        const ThemeColors& dark = themeColors();
        QCOMPARE(palette.color(QPalette::Window), dark.window);
        QCOMPARE(palette.color(QPalette::Text), dark.text);
        QCOMPARE(palette.color(QPalette::Inactive, QPalette::Text), dark.text);
        QCOMPARE(palette.color(QPalette::Disabled, QPalette::WindowText), dark.disabledText);
        QCOMPARE(palette.color(QPalette::PlaceholderText), dark.dimText);
        QCOMPARE(palette.color(QPalette::ToolTipBase), dark.toolTip);
        QCOMPARE(palette.color(QPalette::Link), dark.link);
    }

private:
    // What Qt says of a style sheet it can't parse.
    static QString parseComplaint(const QString& sheet) {
        static QString complaint;
        complaint.clear();
        const auto previous = qInstallMessageHandler(
            [](QtMsgType, const QMessageLogContext&, const QString& text) { complaint += text; });
        QWidget widget;
        widget.setStyleSheet(sheet);
        widget.ensurePolished();
        qInstallMessageHandler(previous);
        return complaint;
    }
};

QTEST_MAIN(TestTheme)
#include "tst_theme.moc"
