// Random numbers that are the same on every platform, for tests that print their seed.
#pragma once

#include <cstdint>

namespace clothlab {

// Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators".
class SplitMix64 {
public:
    explicit SplitMix64(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t next() {
        m_state += 0x9E3779B97F4A7C15U;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }

    // In [0, 1).
    double unit() { return double(next() >> 11U) * 0x1p-53; }
    // In [low, high).
    double real(double low, double high) { return low + (high - low) * unit(); }
    // From low to high, both included.
    int integer(int low, int high) { return low + int(next() % std::uint64_t(high - low + 1)); }
    bool chance(double probability) { return unit() < probability; }

private:
    std::uint64_t m_state;
};

} // namespace clothlab
