#include "textures.h"

#include <array>

namespace clothlab::textures {
namespace {

constexpr int kTwillThreads = 128;
constexpr int kSett = 64;

// Half of a sett; the other half is its mirror image, as weavers do.
Colour yarnColour(int thread) {
    static const Colour kIndigo = fromHex(0x26365E);
    static const Colour kSlate = fromHex(0x587893);
    static const Colour kCream = fromHex(0xEEE5D0);
    static const Colour kRust = fromHex(0xB4513A);
    const int place = wrap(thread, kSett);
    const int fromCentre = place < kSett / 2 ? place : kSett - 1 - place;
    constexpr std::array<int, 6> kEnds{8, 10, 13, 21, 22, 30};
    const std::array<Colour, 7> colours{kIndigo, kCream, kIndigo, kSlate, kIndigo, kCream, kRust};
    std::size_t band = 0;
    while (band < kEnds.size() && fromCentre >= kEnds[band]) {
        ++band;
    }
    return colours[band];
}

// Light on one thread: round across, dipping where it goes under, with the twist of its fibres.
float yarnLight(float across, float alongFloat, float along, int thread, std::uint32_t seed) {
    const float side = 2.0f * across - 1.0f;
    const float dip = 2.0f * alongFloat - 1.0f;
    const float round = std::sqrt(1.0f - 0.9f * side * side);
    const float body = (0.3f + 0.7f * round) * (1.0f - 0.4f * dip * dip * dip * dip) - 0.1f * side;
    const float twist = 0.07f * std::sin(2.0f * kPi * (along + 0.45f * side));
    const float fibre = 0.07f * tileNoise(along * 1.0f, static_cast<float>(thread) + 0.5f, kTwillThreads,
                                          kTwillThreads, seed);
    const float lot = 0.14f * (hashUnit(thread, 3, seed) - 0.5f);
    return 1.12f * body * (1.0f + twist + fibre + lot);
}

} // namespace

Colour tartan(float u, float v) {
    const float x = u * kTwillThreads;
    const float y = v * kTwillThreads;
    const int column = static_cast<int>(std::floor(x));
    const int row = static_cast<int>(std::floor(y));
    const float fx = x - std::floor(x);
    const float fy = y - std::floor(y);
    // Two over, two under, one step further with every row.
    const int phase = wrap(column + row, 4);
    if (phase < 2)
        return yarnColour(column) * yarnLight(fx, 0.5f * (static_cast<float>(phase) + fy), y, column, 11u);
    return yarnColour(row) * yarnLight(fy, 0.5f * (static_cast<float>(phase - 2) + fx), x, row, 12u);
}

namespace {

constexpr int kBasketThreads = 40;

// Height of a round thread of a weave in which pairs go over pairs.
float threadHeight(float across, float along, int thread, float sign) {
    const float side = (2.0f * fraction(across) - 1.0f) / 0.97f;
    const float wave = std::sin(0.5f * kPi * along);
    const float rise = wave * (1.5f - 0.5f * wave * wave) * sign * ((thread >> 1) % 2 == 0 ? 1.0f : -1.0f);
    const float round = std::sqrt(std::max(0.0f, 1.0f - side * side));
    const float twist = std::sin(2.0f * kPi * (along + 0.35f * side));
    const float slub = tileNoise(along * 0.5f, static_cast<float>(thread) + 0.5f, kBasketThreads / 2,
                                 kBasketThreads, sign > 0.0f ? 21u : 22u);
    return 0.42f * rise + (0.62f + 0.03f * slub) * round + 0.03f * twist * round;
}

float smoothMax(float a, float b, float width) {
    const float h = std::max(width - std::abs(a - b), 0.0f) / width;
    return std::max(a, b) + 0.25f * h * h * width;
}

} // namespace

Colour basketHeight(float u, float v) {
    const float x = u * kBasketThreads;
    const float y = v * kBasketThreads;
    const float warp = threadHeight(x, y, static_cast<int>(std::floor(x)), 1.0f);
    const float weft = threadHeight(y, x, static_cast<int>(std::floor(y)), -1.0f);
    return {smoothMax(std::max(warp, 0.0f), std::max(weft, 0.0f), 0.08f), 0.0f, 0.0f};
}

Colour quiltHeight(float u, float v) {
    constexpr float kDiamonds = 4.0f;
    const float a = kPi * kDiamonds * (u + v);
    const float b = kPi * kDiamonds * (u - v);
    // A soft absolute value: the seams are grooves, not cuts.
    const auto bulge = [](float s) { return std::sqrt(s * s + 0.014f) - 0.1183f; };
    const float pillow = std::sqrt(bulge(std::sin(a)) * bulge(std::sin(b)) + 0.004f);
    // In the middle of every diamond lies a blossom of four petals around a dimple.
    const float p = fraction(a / kPi) - 0.5f;
    const float q = fraction(b / kPi) - 0.5f;
    const float radius = std::sqrt(p * p + q * q);
    const float angle = std::atan2(q, p);
    const float petals = 0.25f + 0.1f * std::cos(4.0f * angle);
    const float rim = std::exp(-std::pow((radius - petals) / 0.055f, 2.0f));
    const float dimple = std::exp(-std::pow(radius / 0.08f, 2.0f));
    return {pillow - 0.12f * rim - 0.2f * dimple, 0.0f, 0.0f};
}

} // namespace clothlab::textures
