// Numbers as text that reads back as the same bits, whatever the locale.
#pragma once

#include "simcore/base/vec3.h"

#include <array>
#include <charconv>
#include <ostream>

namespace clothlab {

// The shortest such text. Value: double, float or an integer.
template <typename Value>
struct Number {
    Value value;
};
template <typename Value>
Number(Value) -> Number<Value>;

template <typename Value>
std::ostream& operator<<(std::ostream& out, Number<Value> number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number.value).ptr;
    return out.write(text.data(), end - text.data());
}

inline void writeVector(std::ostream& out, const Vec3& v, char separator) {
    out << Number{v.x()} << separator << Number{v.y()} << separator << Number{v.z()};
}

} // namespace clothlab
