#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace clothlab::textures {

constexpr float kPi = std::numbers::pi_v<float>;

// Linear light, except in height fields, which use the red channel alone.
struct Colour {
    float r = 0.0f;
    float g = 0.0f;
    float b = 0.0f;

    Colour operator+(const Colour& o) const { return {r + o.r, g + o.g, b + o.b}; }
    Colour operator*(const Colour& o) const { return {r * o.r, g * o.g, b * o.b}; }
    Colour operator*(float f) const { return {r * f, g * f, b * f}; }
};

inline float fraction(float x) {
    return x - std::floor(x);
}

inline float mix(float a, float b, float t) {
    return a + (b - a) * t;
}

inline Colour mix(const Colour& a, const Colour& b, float t) {
    return a * (1.0f - t) + b * t;
}

inline float smoothStep(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

inline float toLinear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

inline float toEncoded(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

// Takes a colour as it is written on the web, 0xRRGGBB.
inline Colour fromHex(std::uint32_t hex) {
    const auto channel = [hex](int shift) {
        return toLinear(static_cast<float>((hex >> shift) & 255u) / 255.0f);
    };
    return {channel(16), channel(8), channel(0)};
}

inline int wrap(int i, int period) {
    const int rest = i % period;
    return rest < 0 ? rest + period : rest;
}

// Integers only, so that every machine draws the same pictures.
inline std::uint32_t hash(int x, int y, std::uint32_t seed) {
    std::uint32_t h = seed * 0x9E3779B9u + static_cast<std::uint32_t>(x) * 0x85EBCA6Bu;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du + static_cast<std::uint32_t>(y) * 0xC2B2AE35u;
    h = (h ^ (h >> 13)) * 0x297A2D39u;
    h = (h ^ (h >> 16)) * 0x7FEB352Du;
    return h ^ (h >> 15);
}

// From 0 to 1.
inline float hashUnit(int x, int y, std::uint32_t seed) {
    return static_cast<float>(hash(x, y, seed) >> 8) / 16777215.0f;
}

// Smooth noise from -1 to 1 with one knot per unit; repeats after the given number of units.
inline float tileNoise(float x, float y, int periodX, int periodY, std::uint32_t seed) {
    const float floorX = std::floor(x);
    const float floorY = std::floor(y);
    const int i = static_cast<int>(floorX);
    const int j = static_cast<int>(floorY);
    const float tx = smoothStep(0.0f, 1.0f, x - floorX);
    const float ty = smoothStep(0.0f, 1.0f, y - floorY);
    const auto knot = [=](int di, int dj) {
        return hashUnit(wrap(i + di, periodX), wrap(j + dj, periodY), seed);
    };
    return 2.0f * mix(mix(knot(0, 0), knot(1, 0), tx), mix(knot(0, 1), knot(1, 1), tx), ty) - 1.0f;
}

// Each takes a place in the unit square and repeats with period 1 in both directions.
Colour tartan(float u, float v);
Colour basketHeight(float u, float v);
Colour quiltHeight(float u, float v);
Colour print(float u, float v);
Colour damask(float u, float v);

// What one sees from the middle of the studio along a direction of any length; from 0 to 1.
Colour studio(float x, float y, float z);

} // namespace clothlab::textures
