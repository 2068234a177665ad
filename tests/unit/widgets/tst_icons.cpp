#include "app/widgets/icons.h"
#include "app/widgets/theme.h"

#include <QApplication>
#include <QPainter>
#include <QTest>

using namespace clothlab;

namespace {

QImage picture(const QIcon& icon, int size, qreal ratio, QIcon::Mode mode = QIcon::Normal,
               QIcon::State state = QIcon::Off) {
    return icon.pixmap(QSize(size, size), ratio, mode, state)
        .toImage()
        .convertToFormat(QImage::Format_ARGB32);
}

int painted(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += qAlpha(image.pixel(x, y)) > 128 ? 1 : 0;
        }
    }
    return count;
}

bool hasColor(const QImage& image, const QColor& color) {
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixel(x, y) == color.rgba()) {
                return true;
            }
        }
    }
    return false;
}

// Big enough that lines have pixels of the pure colour.
QImage large(const QString& name, QIcon::Mode mode, QIcon::State state) {
    return picture(themedIcon(name), 80, 1, mode, state);
}

} // namespace

class TestIcons : public QObject {
    Q_OBJECT

private slots:
    void init() { applyTheme(*qApp, Theme::Dark); }

    void isThere_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"new",
                                 "open",
                                 "save",
                                 "save-as",
                                 "undo",
                                 "redo",
                                 "play",
                                 "pause",
                                 "step-back",
                                 "step-forward",
                                 "first",
                                 "last",
                                 "reset",
                                 "record",
                                 "home",
                                 "frame-all",
                                 "frame-selection",
                                 "screenshot",
                                 "select",
                                 "pin",
                                 "structural",
                                 "shearing",
                                 "bending",
                                 "wireframe",
                                 "shaded",
                                 "panels",
                                 "theme",
                                 "help",
                                 "warning",
                                 "error",
                                 "info",
                                 "close",
                                 "plus",
                                 "minus",
                                 "folder",
                                 "cloth-app"}) {
            QTest::newRow(name) << QString::fromLatin1(name);
        }
    }

    void isThere() {
        QFETCH(QString, name);
        QVERIFY(iconNames().contains(name));
        const QIcon icon = themedIcon(name);
        QVERIFY(!icon.isNull());
        for (const int ratio : {1, 2}) {
            const QImage image = picture(icon, 20, ratio);
            QCOMPARE(image.size(), QSize(20, 20) * ratio);
            QCOMPARE(image.devicePixelRatio(), qreal(ratio));
            QVERIFY2(painted(image) > 8 * ratio * ratio, qPrintable(QString::number(painted(image))));
        }
    }

    // Nothing may touch the edge, where it would be cut off.
    void isWithinItsFrame() {
        for (const QString& name : iconNames()) {
            if (name == QLatin1String("cloth-app")) {
                continue;
            }
            const QImage image = large(name, QIcon::Normal, QIcon::Off);
            for (int i = 0; i < image.width(); ++i) {
                const int last = image.width() - 1;
                QVERIFY2(qAlpha(image.pixel(i, 0)) == 0 && qAlpha(image.pixel(i, last)) == 0 &&
                             qAlpha(image.pixel(0, i)) == 0 && qAlpha(image.pixel(last, i)) == 0,
                         qPrintable(name));
            }
        }
    }

    void areAllDifferent() {
        QList<QImage> seen;
        for (const QString& name : iconNames()) {
            const QImage image = large(name, QIcon::Normal, QIcon::Off);
            QVERIFY2(!seen.contains(image), qPrintable(name));
            seen.append(image);
        }
        QVERIFY(seen.size() >= 36);
    }

    void isSharpAtTwiceTheRatio() {
        const QIcon icon = themedIcon(QStringLiteral("help"));
        const QImage enlarged =
            picture(icon, 20, 1).scaled(40, 40, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        QVERIFY(picture(icon, 20, 2) != enlarged);
        QImage twice = picture(icon, 20, 2);
        twice.setDevicePixelRatio(1);
        QCOMPARE(twice, picture(icon, 40, 1));
    }

    void wearsTheTheme() {
        const ThemeColors& dark = themeColors(Theme::Dark);
        const ThemeColors& light = themeColors(Theme::Light);
        QVERIFY(hasColor(large("save", QIcon::Normal, QIcon::Off), dark.text));
        QVERIFY(hasColor(large("save", QIcon::Disabled, QIcon::Off), dark.disabledText));
        QVERIFY(!hasColor(large("save", QIcon::Disabled, QIcon::Off), dark.text));
        QVERIFY(hasColor(large("save", QIcon::Normal, QIcon::On), dark.accent));
        QVERIFY(hasColor(large("warning", QIcon::Normal, QIcon::Off), dark.warning));
        QVERIFY(hasColor(large("error", QIcon::Normal, QIcon::Off), dark.error));

        const QIcon before = themedIcon(QStringLiteral("save"));
        QVERIFY(hasColor(picture(before, 80, 1), dark.text));
        applyTheme(*qApp, Theme::Light);
        QVERIFY(hasColor(picture(before, 80, 1), light.text));
        QVERIFY(!hasColor(picture(before, 80, 1), dark.text));
    }

    void springsShowTheirColorWhenChecked() {
        const ThemeColors& dark = themeColors();
        const std::pair<const char*, QColor> springs[] = {
            {"structural", dark.structural}, {"shearing", dark.shearing}, {"bending", dark.bending}};
        for (const auto& [name, color] : springs) {
            QVERIFY2(hasColor(large(name, QIcon::Normal, QIcon::On), color), name);
            QVERIFY2(!hasColor(large(name, QIcon::Normal, QIcon::Off), color), name);
        }
        QVERIFY(hasColor(large("record", QIcon::Normal, QIcon::On), dark.error));
        QVERIFY(!hasColor(large("record", QIcon::Normal, QIcon::Off), dark.error));
    }

    void paintsWhereItIsTold() {
        QImage image(60, 60, QImage::Format_ARGB32);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        themedIcon(QStringLiteral("save")).paint(&painter, QRect(30, 30, 20, 20));
        painter.end();
        QVERIFY(painted(image.copy(30, 30, 20, 20)) > 20);
        QCOMPARE(painted(image.copy(30, 30, 20, 20)), painted(image));
    }

    void unknownNameIsNull() {
        QTest::ignoreMessage(QtWarningMsg, "No icon is called \"unheard-of\"");
        QVERIFY(themedIcon(QStringLiteral("unheard-of")).isNull());
    }
};

QTEST_MAIN(TestIcons)
#include "tst_icons.moc"
