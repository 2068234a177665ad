// 64-bit numbers as the planes of their bytes, each compressed or as it is. docs/clothtake.md has the format.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace clothlab {

void appendPlanes(std::string& out, const std::vector<std::uint64_t>& numbers);

// Fills numbers, and takes the bytes they came from off the front. False if they cannot be such planes.
bool readPlanes(std::string_view& bytes, std::vector<std::uint64_t>& numbers);

// The difference of two numbers modulo 2^64, as one that is small if they are near each other.
constexpr std::uint64_t foldedDifference(std::uint64_t a, std::uint64_t b) {
    const std::uint64_t d = a - b;
    return d << 1U ^ (0U - (d >> 63U));
}
constexpr std::uint64_t unfoldedSum(std::uint64_t folded, std::uint64_t b) {
    return b + (folded >> 1U ^ (0U - (folded & 1U)));
}

} // namespace clothlab
