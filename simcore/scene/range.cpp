#include "simcore/scene/range.h"

#include "simcore/scene/json_text.h"

#include <cmath>

namespace clothlab {

bool Range::contains(double value) const {
    return value >= minimum && value <= maximum && !(minimumExcluded && value == minimum) &&
           (!whole || value == std::floor(value));
}

std::string Range::words() const {
    const std::string limit = json::numberText(maximum);
    if (minimumExcluded)
        return "a number above " + json::numberText(minimum) + " and up to " + limit;
    return (whole ? "a whole number from " : "a number from ") + json::numberText(minimum) + " to " + limit;
}

Range rangeOf(const Parameter& parameter) {
    return {parameter.minimum, parameter.maximum, parameter.kind != Parameter::Kind::Real};
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
