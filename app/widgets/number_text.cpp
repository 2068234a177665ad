#include "app/widgets/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace clothlab {

namespace {

constexpr int kShortDigits = 6;

// Digits without the point and the power of ten of the first: 0.0125 is "125" and -2.
struct Decimal {
    bool negative = false;
    QString digits;
    int exponent = 0;
};

Decimal toDecimal(double value, int significant) {
    std::array<char, 64> buffer{};
    char* const end = buffer.data() + buffer.size();
    const auto result =
        significant > 0 ? std::to_chars(buffer.data(), end, std::abs(value), std::chars_format::scientific,
                                        significant - 1)
                        : std::to_chars(buffer.data(), end, std::abs(value), std::chars_format::scientific);
    const std::string text(buffer.data(), result.ptr);
    const std::size_t e = text.find('e');
    Decimal decimal;
    decimal.negative = std::signbit(value) && value != 0;
    decimal.exponent = std::stoi(text.substr(e + 1));
    decimal.digits = QString::fromStdString(text.substr(0, e)).remove(u'.');
    while (decimal.digits.size() > 1 && decimal.digits.endsWith(u'0')) {
        decimal.digits.chop(1);
    }
    return decimal;
}

QString layOut(const Decimal& decimal) {
    const qsizetype count = decimal.digits.size();
    const int e = decimal.exponent;
    QString text = decimal.digits;
    if (e < -4 || (e >= 9 && e > count + 3)) {
        text = decimal.digits.left(1) + (count > 1 ? u'.' + decimal.digits.mid(1) : QString()) + u'e' +
               QString::number(e);
    } else if (e < 0) {
        text = QStringLiteral("0.") + QString(-e - 1, u'0') + decimal.digits;
    } else if (e >= count - 1) {
        text = decimal.digits + QString(e - count + 1, u'0');
    } else {
        text.insert(e + 1, u'.');
    }
    return decimal.negative ? u'-' + text : text;
}

QString notFinite(double value) {
    return std::isnan(value) ? QStringLiteral("nan")
           : value > 0       ? QStringLiteral("inf")
                             : QStringLiteral("-inf");
}

} // namespace

QString shortText(double value) {
    if (!std::isfinite(value)) {
        return notFinite(value);
    }
    if (value == std::trunc(value) && std::abs(value) < 1e9) {
        return QString::number(qint64(value));
    }
    Decimal decimal = toDecimal(value, kShortDigits);
    if (decimal.exponent >= kShortDigits) {
        // Written out, zeros would stand for digits that were cut off.
        const Decimal mantissa{decimal.negative, decimal.digits, 0};
        return layOut(mantissa) + u'e' + QString::number(decimal.exponent);
    }
    return layOut(decimal);
}

QString exactText(double value) {
    return std::isfinite(value) ? layOut(toDecimal(value, 0)) : notFinite(value);
}

double roundedToDigits(double value, int digits) {
    if (value == 0 || !std::isfinite(value)) {
        return value;
    }
    std::array<char, 64> buffer{};
    const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                       std::chars_format::scientific, digits - 1);
    double rounded = value;
    std::from_chars(buffer.data(), written.ptr, rounded);
    return rounded;
}

} // namespace clothlab
