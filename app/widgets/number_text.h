// How numbers are written in fields and tables: with a point, in any locale.
#pragma once

#include <QString>

namespace clothlab {

// The shortest text that gives the value to about 6 significant digits: 0.0111111, 2500000, 1.5e-7. Whole
// numbers below 1e9 are written out. Not finite: "inf", "-inf", "nan".
QString shortText(double value);

// The shortest text that reads back as exactly the same double.
QString exactText(double value);

// The value at `digits` significant decimal digits, to rid sums of steps of noise like 0.30000000000000004.
// 0 and what is not finite stay.
double roundedToDigits(double value, int digits);

} // namespace clothlab
