// The two looks of the window: colours by name, and what makes Qt's own widgets wear them.
#pragma once

#include <QColor>
#include <QString>

class QApplication;

namespace clothlab {

enum class Theme { Dark, Light };

// Every colour the program paints with. Text colours keep a contrast of at least 4.5 : 1 on the surfaces
// named beside them; disabled text, which nobody needs to read, keeps 2.5 : 1.
struct ThemeColors {
    QColor window;       // behind and between panels, menu bar, tool bars, status bar
    QColor panel;        // docks, menus, buttons
    QColor field;        // number fields, tables, lists, text
    QColor alternate;    // every other row of a table
    QColor hover;        // a button or a row under the pointer
    QColor pressed;      // a button held down
    QColor border;       // around fields and buttons
    QColor separator;    // between panels, under headers
    QColor text;         // on all of the above
    QColor dimText;      // units, hints, placeholders: on window, panel and field
    QColor disabledText; // on window, panel and field
    QColor accent;       // focus, slider, checked icon, the dot of a changed value
    QColor accentText;   // on accent
    QColor highlight;    // selected rows and selected text
    QColor highlightText;
    QColor checked; // behind a tool button that is on
    QColor link;    // on window, panel and field
    QColor toolTip; // behind a tooltip; its text is `text`

    QColor structural; // one colour a type of spring, everywhere
    QColor shearing;
    QColor bending;
    QColor point;
    QColor pinned;
    QColor selected;

    QColor warning; // readable as text on window, panel and field
    QColor error;   // readable as text on window, panel and field
};

// Colours of the theme that was applied last (dark before any).
const ThemeColors& themeColors();

// Colours of either theme. The viewport is dark in both, so that the cloth stays the brightest thing on the
// screen; what is drawn there takes themeColors(Theme::Dark).
const ThemeColors& themeColors(Theme theme);

// Gives the application the Fusion style, the palette and the style sheet of `theme`. May be called at any
// time; widgets that are shown repaint, and icons of themedIcon() follow. Links in rich text keep the colour
// they had when the text was set, as always in Qt.
void applyTheme(QApplication& application, Theme theme);

// The theme that was applied last, Dark before any.
Theme currentTheme();

// The style sheet with every colour filled in. It never holds a placeholder that no colour answers to.
QString themeStyleSheet(Theme theme);

// Makes the files of resources/ readable under ":/". Harmless when called again. applyTheme() and
// themedIcon() call it; call it before reading ":/..." by other means.
void initResources();

} // namespace clothlab
