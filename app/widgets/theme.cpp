#include "app/widgets/theme.h"

#include <QApplication>
#include <QFile>
#include <QHash>
#include <QPalette>
#include <QRegularExpression>
#include <QStyleFactory>

// Q_INIT_RESOURCE declares a function, which has to be the global one.
static void initResourcesOfLibrary() {
    Q_INIT_RESOURCE(resources);
}

namespace clothlab {

namespace {

Theme g_theme = Theme::Dark;

QColor rgb(QRgb value) {
    return QColor::fromRgb(value);
}

ThemeColors darkColors() {
    ThemeColors c;
    c.window = rgb(0x26282B);
    c.panel = rgb(0x2E3135);
    c.field = rgb(0x1F2123);
    c.alternate = rgb(0x232628);
    c.hover = rgb(0x393D42);
    c.pressed = rgb(0x1A1C1E);
    c.border = rgb(0x41464C);
    c.separator = rgb(0x1B1D1F);
    c.text = rgb(0xE4E6E8);
    c.dimText = rgb(0x9AA0A6);
    c.disabledText = rgb(0x73797F);
    c.accent = rgb(0x4C9BE8);
    c.accentText = rgb(0x101214);
    c.highlight = rgb(0x2C5A8C);
    c.highlightText = rgb(0xFFFFFF);
    c.checked = rgb(0x2F4257);
    c.link = rgb(0x6FB1F0);
    c.toolTip = rgb(0x17191B);
    c.structural = rgb(0x3D9BE0);
    c.shearing = rgb(0xF2B83C);
    c.bending = rgb(0x2BC496);
    c.point = rgb(0xDDDDDD);
    c.pinned = rgb(0xCC79A7);
    c.selected = rgb(0xFFD23F);
    c.warning = rgb(0xF0B44C);
    c.error = rgb(0xFF7B72);
    return c;
}

ThemeColors lightColors() {
    ThemeColors c;
    c.window = rgb(0xE6E8EA);
    c.panel = rgb(0xF3F4F5);
    c.field = rgb(0xFFFFFF);
    c.alternate = rgb(0xF7F8F9);
    c.hover = rgb(0xDDE1E5);
    c.pressed = rgb(0xCBD0D6);
    c.border = rgb(0xBBC0C6);
    c.separator = rgb(0xCDD1D5);
    c.text = rgb(0x1E2124);
    c.dimText = rgb(0x5A6067);
    c.disabledText = rgb(0x8A9097);
    c.accent = rgb(0x1A69B8);
    c.accentText = rgb(0xFFFFFF);
    c.highlight = rgb(0x2368AE);
    c.highlightText = rgb(0xFFFFFF);
    c.checked = rgb(0xCFE0F2);
    c.link = rgb(0x175FA8);
    c.toolTip = rgb(0xFFFFFF);
    c.structural = rgb(0x0072B2);
    c.shearing = rgb(0xE69F00);
    c.bending = rgb(0x009E73);
    // On light surfaces light greys and yellows vanish, so these are darker than in the viewport.
    c.point = rgb(0x6B7177);
    c.pinned = rgb(0xA84A80);
    c.selected = rgb(0xA67C00);
    c.warning = rgb(0x8A5200);
    c.error = rgb(0xB3261E);
    return c;
}

// A style sheet can't compute, so the colours it names are filled in; "@theme" is the folder of the glyphs.
QHash<QString, QString> placeholders(Theme theme) {
    const ThemeColors& c = themeColors(theme);
    return {
        {"window", c.window.name()},
        {"panel", c.panel.name()},
        {"field", c.field.name()},
        {"alternate", c.alternate.name()},
        {"hover", c.hover.name()},
        {"pressed", c.pressed.name()},
        {"border", c.border.name()},
        {"separator", c.separator.name()},
        {"text", c.text.name()},
        {"dimText", c.dimText.name()},
        {"disabledText", c.disabledText.name()},
        {"accent", c.accent.name()},
        {"accentText", c.accentText.name()},
        {"highlight", c.highlight.name()},
        {"highlightText", c.highlightText.name()},
        {"checked", c.checked.name()},
        {"toolTip", c.toolTip.name()},
        {"error", c.error.name()},
        {"theme", theme == Theme::Dark ? QStringLiteral(":/theme/dark") : QStringLiteral(":/theme/light")},
    };
}

// What a palette says for each group alike. Roles of text are set by paletteFor().
void setSurfaces(QPalette& palette, const ThemeColors& c) {
    palette.setColor(QPalette::Window, c.window);
    palette.setColor(QPalette::Base, c.field);
    palette.setColor(QPalette::AlternateBase, c.alternate);
    palette.setColor(QPalette::Button, c.panel);
    palette.setColor(QPalette::ToolTipBase, c.toolTip);
    palette.setColor(QPalette::ToolTipText, c.text);
    palette.setColor(QPalette::PlaceholderText, c.dimText);
    palette.setColor(QPalette::BrightText, c.error);
    palette.setColor(QPalette::Link, c.link);
    palette.setColor(QPalette::LinkVisited, c.link);
    palette.setColor(QPalette::Highlight, c.highlight);
    palette.setColor(QPalette::HighlightedText, c.highlightText);
    // Bevels: Fusion derives outlines and grooves from these.
    palette.setColor(QPalette::Light, c.hover);
    palette.setColor(QPalette::Midlight, c.hover);
    palette.setColor(QPalette::Mid, c.border);
    palette.setColor(QPalette::Dark, c.separator);
    palette.setColor(QPalette::Shadow, c.separator.darker(130));
}

QPalette paletteFor(Theme theme) {
    const ThemeColors& c = themeColors(theme);
    QPalette palette;
    setSurfaces(palette, c);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        palette.setColor(role, c.text);
        palette.setColor(QPalette::Disabled, role, c.disabledText);
    }
    for (const auto role : {QPalette::PlaceholderText, QPalette::Link, QPalette::LinkVisited}) {
        palette.setColor(QPalette::Disabled, role, c.disabledText);
    }
    palette.setColor(QPalette::Disabled, QPalette::Base, c.window);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, c.border);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, c.text);
    return palette;
}

} // namespace

const ThemeColors& themeColors(Theme theme) {
    static const ThemeColors dark = darkColors();
    static const ThemeColors light = lightColors();
    return theme == Theme::Dark ? dark : light;
}

const ThemeColors& themeColors() {
    return themeColors(g_theme);
}

Theme currentTheme() {
    return g_theme;
}

QString themeStyleSheet(Theme theme) {
    initResources();
    QFile file(QStringLiteral(":/theme/style.qss"));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QString source = QString::fromUtf8(file.readAll());
    const QHash<QString, QString> values = placeholders(theme);
    static const QRegularExpression name(QStringLiteral("@([A-Za-z]+)"));
    QString sheet;
    qsizetype end = 0;
    for (auto it = name.globalMatch(source); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        Q_ASSERT_X(values.contains(match.captured(1)), "style.qss", qPrintable(match.captured()));
        sheet += QStringView(source).mid(end, match.capturedStart() - end);
        sheet += values.value(match.captured(1));
        end = match.capturedEnd();
    }
    return sheet + source.mid(end);
}

void applyTheme(QApplication& application, Theme theme) {
    g_theme = theme;
    // Once there is a style sheet, Fusion is below it.
    if (application.styleSheet().isEmpty()) {
        application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    }
    application.setPalette(paletteFor(theme));
    application.setStyleSheet(themeStyleSheet(theme));
}

void initResources() {
    static const bool done = [] {
        initResourcesOfLibrary();
        return true;
    }();
    Q_UNUSED(done);
}

} // namespace clothlab
