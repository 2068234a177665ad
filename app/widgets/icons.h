// The icons of the program: line drawings of resources/icons, coloured by the theme.
#pragma once

#include <QIcon>
#include <QString>
#include <QStringList>

namespace clothlab {

// The icon drawn by resources/icons/<name>.svg, crisp at any size and device pixel ratio. It is dim when
// disabled, takes the accent when checked, and follows applyTheme() wherever a widget draws it anew (a
// pixmap taken from it does not). Icons of springs show the colour of their type when checked, "record" a red
// dot; "warning" and "error" always wear their colour. An unknown name gives a null icon and a message in
// the log.
QIcon themedIcon(const QString& name);

// Names themedIcon() knows, sorted.
QStringList iconNames();

} // namespace clothlab
