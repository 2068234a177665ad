#include "simcore/scene/range.h"

#include "simcore/scene/json_text.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace clothlab {
namespace {

std::string powersWithin(double minimum, double maximum) {
    std::string words;
    for (double power = minimum; power <= maximum; power *= 2) {
        const bool isLast = power * 2 > maximum;
        words += (words.empty() ? "" : isLast ? " or " : ", ") + json::numberText(power);
    }
    return words;
}

} // namespace

bool Range::contains(double value) const {
    const bool inside = value >= minimum && value <= maximum && !(minimumExcluded && value == minimum) &&
                        (!whole || value == std::floor(value));
    if (!inside || (std::abs(value) < leastButZero && value != 0))
        return false;
    return !powersOfTwo || std::has_single_bit(static_cast<std::uint64_t>(value));
}

std::string Range::words() const {
    if (powersOfTwo)
        return powersWithin(minimum, maximum);
    const std::string limit = json::numberText(maximum);
    if (minimumExcluded)
        return "a number above " + json::numberText(minimum) + " and up to " + limit;
    const std::string kind = whole ? "a whole number from " : "a number from ";
    if (leastButZero > 0)
        return "0 or " + kind + json::numberText(leastButZero) + " to " + limit;
    return kind + json::numberText(minimum) + " to " + limit;
}

Range rangeOf(const Parameter& parameter) {
    return {parameter.minimum,      parameter.maximum,    parameter.kind != Parameter::Kind::Real, false,
            parameter.leastButZero, parameter.powersOfTwo};
}

std::string outOfRange(double value) {
    if (!std::isfinite(value))
        return "is not a finite number";
    return "must not be " + json::numberText(value);
}

std::string writeWithin(const Range& range) {
    return "give " + range.words();
}

} // namespace clothlab
