// Arithmetic as people type it into a number field.
#pragma once

#include <QString>

namespace clothlab {

struct ExpressionResult {
    double value = 0; // finite when ok()
    QString error;    // what is wrong, in words for the user; empty when all is well

    bool ok() const { return error.isEmpty(); }
};

// The value of `text`: numbers with a point or a comma as decimal separator and an optional exponent
// (1e-3), + - * / ^ ( ), sqrt(x), pi and e. As in mathematics ^ binds tighter than a sign and goes from right
// to left: -2^2 is -4, 2^3^2 is 512. Spaces mean nothing; the case of names neither. A number alone is the
// nearest double to what is written. Empty text, anything that is not understood, parentheses nested deeper
// than 64 and results that are not finite (1/0, sqrt(-1)) are errors.
ExpressionResult evaluateExpression(const QString& text);

} // namespace clothlab
