#include "textures.h"

#include <array>

namespace clothlab::textures {
namespace {

struct Point {
    float x = 0.0f;
    float y = 0.0f;
};

// How much of a shape covers a place, from its signed depth inside the shape; the soft edge spares the
// samples.
float covered(float depth, float edge) {
    return smoothStep(-edge, edge, depth);
}

// Depth inside a flower with a number of round petals.
float flower(Point p, float radius, float petals, float turn, float roundness) {
    const float angle = std::atan2(p.y, p.x) + turn;
    const float lobe = std::pow(std::abs(std::cos(0.5f * petals * angle)), roundness);
    return radius * (0.55f + 0.45f * lobe) - std::sqrt(p.x * p.x + p.y * p.y);
}

float disc(Point p, Point centre, float radius) {
    return radius - std::hypot(p.x - centre.x, p.y - centre.y);
}

// Turns a place about the origin into the nearest of equal sectors, so that the sector's middle lies along x.
Point intoSector(Point p, float sectors, float turn) {
    const float sector = 2.0f * kPi / sectors;
    const float radius = std::sqrt(p.x * p.x + p.y * p.y);
    const float angle = std::atan2(p.y, p.x) + turn;
    const float rest = angle - sector * std::floor(angle / sector + 0.5f);
    return {radius * std::cos(rest), radius * std::sin(rest)};
}

// Depth inside a leaf from one point to another, which bends sideways and is widest where `belly` says.
float leaf(Point p, Point from, Point to, float width, float bend, float belly) {
    const float dx = to.x - from.x;
    const float dy = to.y - from.y;
    const float length = std::sqrt(dx * dx + dy * dy);
    const float along = ((p.x - from.x) * dx + (p.y - from.y) * dy) / (length * length);
    if (along <= 0.0f || along >= 1.0f)
        return -1.0f;
    const float side = ((p.y - from.y) * dx - (p.x - from.x) * dy) / length;
    const float middle = bend * 4.0f * along * (1.0f - along);
    return width * std::sin(kPi * std::pow(along, belly)) - std::abs(side - middle);
}

struct Palette {
    Colour ground, outer, inner, heart, leaves, dots;
};

void lay(Colour& below, const Colour& above, float depth) {
    below = mix(below, above, covered(depth, 0.004f));
}

// A round medallion: flower, ring of dots, wreath of leaves. It touches its neighbours at radius 1/sqrt(2).
void layMedallion(Colour& colour, Point p, const Palette& palette, float petals) {
    const float radius = std::sqrt(p.x * p.x + p.y * p.y);
    lay(colour, palette.ground, 0.672f - radius);
    lay(colour, palette.dots, 0.0075f - std::abs(radius - 0.642f));
    const Point wreath = intoSector(p, 2.0f * petals, 0.0f);
    const Point slanted{wreath.x, std::abs(wreath.y)};
    lay(colour, palette.leaves, leaf(slanted, {0.475f, 0.008f}, {0.608f, 0.058f}, 0.021f, 0.008f, 0.8f));
    lay(colour, palette.dots, disc(wreath, {0.592f, 0.0f}, 0.014f));
    const Point between = intoSector(p, petals, kPi / petals);
    lay(colour, palette.outer, flower(p, 0.43f, petals, 0.0f, 0.55f));
    const Point petal = intoSector(p, petals, 0.0f);
    lay(colour, palette.ground, leaf(petal, {0.25f, 0.0f}, {0.4f, 0.0f}, 0.016f, 0.0f, 1.25f));
    lay(colour, palette.dots, disc(between, {0.43f, 0.0f}, 0.02f));
    lay(colour, palette.inner, flower(p, 0.26f, petals, kPi / petals, 0.6f));
    lay(colour, palette.ground, disc(p, {}, 0.128f));
    lay(colour, palette.heart, disc(p, {}, 0.108f));
    lay(colour, palette.outer, disc(intoSector(p, petals, 0.0f), {0.07f, 0.0f}, 0.015f));
    lay(colour, palette.outer, disc(p, {}, 0.026f));
}

// The four-pointed gaps between the medallions.
void layStar(Colour& colour, Point p, const Colour& leaves, const Colour& heart) {
    const Point tip = intoSector(p, 4.0f, 0.0f);
    const Point slant = intoSector(p, 4.0f, kPi / 4.0f);
    lay(colour, leaves, leaf(tip, {0.07f, 0.0f}, {0.3f, 0.0f}, 0.042f, 0.0f, 0.7f));
    lay(colour, leaves, leaf(slant, {0.07f, 0.0f}, {0.19f, 0.0f}, 0.03f, 0.0f, 0.8f));
    lay(colour, heart, flower(p, 0.075f, 8.0f, 0.0f, 0.6f));
}

Point centred(float x, float y) {
    return {2.0f * fraction(0.5f * x + 0.5f) - 1.0f, 2.0f * fraction(0.5f * y + 0.5f) - 1.0f};
}

} // namespace

Colour print(float u, float v) {
    static const Colour kIvory = fromHex(0xF2E8D5);
    static const Colour kTeal = fromHex(0x21555C);
    static const Colour kTerracotta = fromHex(0xC25B3F);
    static const Colour kMustard = fromHex(0xDCA94B);
    static const Colour kBlush = fromHex(0xE9BFA6);
    static const Colour kSage = fromHex(0x8FA98C);
    static const Palette kLight{kIvory, kTerracotta, kBlush, kMustard, kSage, kTeal};
    static const Palette kDark{kTeal, kIvory, kMustard, kTerracotta, kSage, kBlush};
    const float x = 4.0f * u;
    const float y = 4.0f * v;
    Colour colour = kMustard;
    layMedallion(colour, centred(x, y), kLight, 10.0f);
    layMedallion(colour, centred(x + 1.0f, y + 1.0f), kDark, 8.0f);
    layStar(colour, centred(x + 1.0f, y), kTeal, kIvory);
    layStar(colour, centred(x, y + 1.0f), kTeal, kIvory);
    // A trace of the cloth it is printed on.
    const float weave = std::sin(512.0f * kPi * u) * std::sin(512.0f * kPi * v);
    return colour * (0.95f + 0.05f * weave);
}

namespace {

constexpr float kOgeeWidth = 2.0f / 3.0f;

struct Blade {
    Point from, to;
    float width = 0.0f;
    float bend = 0.0f;
    float belly = 1.0f;
};

// The right half of a palmette in its ogee, back to front, y upwards.
constexpr std::array<Blade, 12> kPalmette{{{{0.0f, -0.3f}, {0.0f, -0.84f}, 0.026f, 0.0f, 0.5f},
                                           {{0.0f, -0.68f}, {0.13f, -0.57f}, 0.026f, -0.02f, 1.2f},
                                           {{0.0f, -0.56f}, {0.27f, -0.4f}, 0.044f, -0.045f, 1.3f},
                                           {{0.0f, -0.43f}, {0.43f, -0.17f}, 0.06f, -0.085f, 1.4f},
                                           {{0.03f, -0.16f}, {0.52f, 0.1f}, 0.08f, -0.06f, 2.0f},
                                           {{0.02f, -0.1f}, {0.37f, 0.35f}, 0.085f, -0.03f, 2.2f},
                                           {{0.01f, -0.05f}, {0.18f, 0.53f}, 0.085f, -0.015f, 2.3f},
                                           {{0.0f, 0.0f}, {0.0f, 0.7f}, 0.1f, 0.0f, 2.0f},
                                           {{0.0f, -0.4f}, {0.26f, 0.04f}, 0.05f, -0.08f, 1.3f},
                                           {{0.0f, -0.4f}, {0.2f, 0.17f}, 0.055f, -0.07f, 1.4f},
                                           {{0.0f, -0.42f}, {0.0f, 0.3f}, 0.135f, 0.0f, 1.0f},
                                           {{0.0f, -0.36f}, {0.0f, 0.2f}, 0.095f, 0.0f, 1.0f}}};

// How much gold covers a place: every blade cuts a dark outline into those behind it and has a dark vein.
float palmette(Point p) {
    float gold = 0.0f;
    for (const Blade& blade : kPalmette) {
        const float depth = leaf(p, blade.from, blade.to, blade.width, blade.bend, blade.belly);
        if (depth <= -0.02f)
            continue;
        gold = mix(gold, 0.0f, covered(depth + 0.012f, 0.003f));
        gold = mix(gold, 1.0f, covered(depth, 0.003f));
        const float vein = leaf(p, blade.from, blade.to, 0.2f * blade.width, blade.bend, blade.belly);
        gold = mix(gold, 0.0f, covered(vein, 0.003f));
    }
    // Seeds in the fruit.
    const float inside = leaf(p, {0.0f, -0.36f}, {0.0f, 0.2f}, 0.095f, 0.0f, 1.0f);
    if (inside > 0.012f) {
        const float seeds = std::cos(kPi * (p.x + p.y) / 0.036f) * std::cos(kPi * (p.x - p.y) / 0.036f);
        gold = std::max(gold, 1.0f) * smoothStep(-0.15f, 0.15f, std::abs(seeds) - 0.35f);
    }
    return gold;
}

float ogeeEdge(float y) {
    return 0.5f * kOgeeWidth * (1.0f + std::cos(kPi * y));
}

float distanceToEdge(Point p) {
    const float slope = 0.5f * kOgeeWidth * kPi * std::sin(kPi * p.y);
    return std::abs(p.x - ogeeEdge(p.y)) / std::sqrt(1.0f + slope * slope);
}

// The curved lattice between the palmettes: two lines with pearls between them.
float lattice(Point p) {
    float gold = covered(0.009f - std::abs(distanceToEdge(p) - 0.042f), 0.003f);
    const float nearest = std::floor(p.y * 14.0f + 0.5f);
    for (int k = -1; k <= 1; ++k) {
        const float y = (nearest + static_cast<float>(k)) / 14.0f;
        gold = std::max(gold, covered(disc(p, {ogeeEdge(y), y}, 0.021f), 0.003f));
    }
    return gold;
}

// A rosette hides where the lattice's lines meet.
float rosette(Point p, float below) {
    float gold = mix(below, 0.0f, covered(disc(p, {}, 0.125f), 0.003f));
    gold = mix(gold, 1.0f, covered(flower(p, 0.11f, 8.0f, 0.0f, 0.6f), 0.003f));
    gold = mix(gold, 0.0f, covered(disc(p, {}, 0.045f), 0.003f));
    return mix(gold, 1.0f, covered(disc(p, {}, 0.028f), 0.003f));
}

} // namespace

Colour damask(float u, float v) {
    static const Colour kGround = fromHex(0x1D4B4A);
    static const Colour kGold = fromHex(0xCDAE72);
    const float x = 6.0f * u;
    const float y = -4.0f * v;
    // Every other column hangs half a repeat lower, which the lattice itself decides.
    Point p = centred(x, y);
    if (std::abs(p.x) > 0.5f * (1.0f + std::cos(kPi * p.y)))
        p = centred(x + 1.0f, y + 1.0f);
    p = {kOgeeWidth * std::abs(p.x), p.y};
    const float clear = covered(distanceToEdge(p) - 0.066f, 0.003f);
    float gold = std::max(palmette(p) * clear, lattice(p));
    const Point joint = centred(x + 1.0f, y);
    gold = rosette({kOgeeWidth * joint.x, joint.y}, gold);
    const Point otherJoint = centred(x, y + 1.0f);
    gold = rosette({kOgeeWidth * otherJoint.x, otherJoint.y}, gold);
    // Gold floats in a fine satin, the ground is ribbed.
    const float satin = 0.95f + 0.07f * std::sin(2.0f * kPi * (128.0f * u + 256.0f * v));
    const float rib = 0.95f + 0.09f * std::sin(2.0f * kPi * 256.0f * v);
    return mix(kGround * rib, kGold * satin, gold);
}

} // namespace clothlab::textures
