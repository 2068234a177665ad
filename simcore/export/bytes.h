// Numbers as bytes, in the order that a file wants, on any machine.
#pragma once

#include "simcore/base/vec3.h"

#include <bit>
#include <cstdint>
#include <string>

namespace clothlab {

inline void appendLittle(std::string& bytes, std::uint32_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(value >> shift & 0xFFU);
}

inline void appendLittle(std::string& bytes, float value) {
    appendLittle(bytes, std::bit_cast<std::uint32_t>(value));
}

// x, y, z, each rounded to the nearest float.
inline void appendLittle(std::string& bytes, const Vec3& v) {
    for (const double value : {v.x(), v.y(), v.z()})
        appendLittle(bytes, static_cast<float>(value));
}

inline void appendBig(std::string& bytes, std::uint32_t value) {
    for (unsigned shift = 32; shift > 0; shift -= 8)
        bytes += static_cast<char>(value >> (shift - 8) & 0xFFU);
}

inline void appendBig(std::string& bytes, float value) {
    appendBig(bytes, std::bit_cast<std::uint32_t>(value));
}

inline void appendBig(std::string& bytes, const Vec3& v) {
    for (const double value : {v.x(), v.y(), v.z()})
        appendBig(bytes, static_cast<float>(value));
}

} // namespace clothlab
