// Ranges of the numbers in a scene, and the words for them: the same when a file is read and when a scene
// is checked. Those of the parameters come from their table.
#pragma once

#include "simcore/scene/parameters.h"

#include <string>

namespace clothlab {

struct Range {
    double minimum = 0;
    double maximum = 0;
    bool whole = false;
    bool minimumExcluded = false;
    double leastButZero = 0;  // as of a Parameter
    bool powersOfTwo = false; // of whole numbers

    bool contains(double value) const; // false for NaN
    std::string words() const;         // "a whole number from 2 to 100"
};

Range rangeOf(const Parameter& parameter);

inline constexpr double kMaxCoordinate = 1e6; // m; beyond it a double is too coarse for the solver's offsets
inline constexpr Range kCoordinate{-kMaxCoordinate, kMaxCoordinate};
inline constexpr Range kLength{0, kMaxCoordinate, false, true};
inline constexpr Range kShare{0, 1};
inline constexpr Range kAzimuth{-360, 360};
inline constexpr Range kElevation{-90, 90};

inline constexpr std::size_t kMaxUniforms = 1000; // of all shaders together, and as many shaders
inline constexpr std::size_t kMaxFileNameBytes = 4096;
inline constexpr std::size_t kMaxNameBytes = 200; // of a shader or a uniform
inline constexpr std::size_t kFewestNumbers = 2;  // in the list that is a uniform's value
inline constexpr std::size_t kMostNumbers = 4;

// What is wrong with a number and what to write instead.
std::string outOfRange(double value);
std::string writeWithin(const Range& range);

} // namespace clothlab
