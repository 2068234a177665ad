// A photographer's studio as seen from its middle: soft boxes, a paper backdrop, a polished floor.

#include "textures.h"

#include <array>

namespace clothlab::textures {
namespace {

struct Vec {
    float x = 0.0f;
    float y = 0.0f;
    float z = 0.0f;

    Vec operator+(const Vec& o) const { return {x + o.x, y + o.y, z + o.z}; }
    Vec operator-(const Vec& o) const { return {x - o.x, y - o.y, z - o.z}; }
    Vec operator*(float f) const { return {x * f, y * f, z * f}; }
};

float dot(const Vec& a, const Vec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec cross(const Vec& a, const Vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec unit(const Vec& a) {
    return a * (1.0f / std::sqrt(dot(a, a)));
}

// The room in metres; the viewer is at the origin.
constexpr float kFloor = -1.5f;
constexpr float kCeiling = 3.2f;
constexpr float kSideWall = 5.0f;
constexpr float kEndWall = 6.0f;
constexpr float kPaperHalfWidth = 3.0f;
constexpr float kPaperTop = 2.5f;
constexpr float kPaperFront = -2.6f;

// Seen directly, a soft box would burn out to white and lose its colour.
constexpr float kFaceLevel = 0.42f;

// A soft box: a bright rectangle in a black frame, turned towards the viewer.
struct SoftBox {
    Vec centre, normal, right, up;
    float halfWidth = 0.0f;
    float halfHeight = 0.0f;
    Colour light;
    bool onStand = false;
};

SoftBox softBox(const Vec& centre, float halfWidth, float halfHeight, const Colour& light, bool onStand) {
    const Vec normal = unit(centre * -1.0f);
    const Vec right = unit(cross(onStand ? Vec{0.0f, 1.0f, 0.0f} : Vec{0.0f, 0.0f, -1.0f}, normal));
    return {centre, normal, right, cross(normal, right), halfWidth, halfHeight, light, onStand};
}

const std::array<SoftBox, 5>& softBoxes() {
    static const std::array<SoftBox, 5> kBoxes{
        softBox({3.3f, 1.5f, -2.3f}, 1.15f, 1.45f, Colour{1.0f, 0.8f, 0.56f} * 7.5f, true),
        softBox({-3.7f, 1.0f, -0.9f}, 1.25f, 1.25f, Colour{0.52f, 0.73f, 1.0f} * 5.0f, true),
        softBox({-1.9f, 0.6f, 4.2f}, 0.24f, 1.75f, Colour{0.95f, 0.97f, 1.0f} * 5.5f, true),
        softBox({2.9f, 0.5f, 3.4f}, 0.2f, 1.6f, Colour{1.0f, 0.9f, 0.76f} * 4.5f, true),
        softBox({0.3f, 2.75f, 0.5f}, 0.95f, 0.95f, Colour{1.0f, 0.97f, 0.92f} * 4.6f, false)};
    return kBoxes;
}

// Brightest in the middle, where the lamp is behind the cloth.
Colour boxFace(const SoftBox& box, float s, float t) {
    const float hot = 1.15f - 0.5f * (s * s + t * t) + 0.12f * std::exp(-3.0f * (s * s + t * t));
    return box.light * hot;
}

// Lays the soft box over what is behind it. `blur` widens its edges, in metres; `level` dims its face.
void laySoftBox(Colour& behind, const SoftBox& box, const Vec& from, const Vec& ray, float limit, float blur,
                float level) {
    const float facing = dot(ray, box.normal);
    if (facing >= -1e-4f)
        return;
    const float distance = dot(box.centre - from, box.normal) / facing;
    if (distance <= 0.0f || distance >= limit)
        return;
    const Vec hit = from + ray * distance - box.centre;
    const float s = dot(hit, box.right);
    const float t = dot(hit, box.up);
    const auto cover = [&](float margin) {
        return smoothStep(-blur, blur, box.halfWidth + margin - std::abs(s)) *
               smoothStep(-blur, blur, box.halfHeight + margin - std::abs(t));
    };
    behind = mix(behind, {0.006f, 0.006f, 0.007f}, cover(0.06f));
    behind = mix(behind, boxFace(box, s / box.halfWidth, t / box.halfHeight) * level, cover(0.0f));
}

// The stands are thin upright poles, so only their distance in plan counts.
void layStand(Colour& behind, const SoftBox& box, const Vec& ray) {
    const float flat = ray.x * ray.x + ray.z * ray.z;
    const float along = (ray.x * box.centre.x + ray.z * box.centre.z) / std::max(flat, 1e-6f);
    const float height = along * ray.y;
    if (along <= 0.0f || height < kFloor || height > box.centre.y - box.halfHeight)
        return;
    const float side = (ray.x * box.centre.z - ray.z * box.centre.x) / std::sqrt(flat);
    const float shine = std::exp(-std::pow((side - 0.008f) / 0.008f, 2.0f));
    const float cover = smoothStep(-0.005f, 0.005f, 0.028f - std::abs(side));
    behind = mix(behind, Colour{0.02f, 0.02f, 0.022f} + Colour{0.25f, 0.25f, 0.25f} * shine, cover);
}

// Light that arrives at a place with a normal, from a grid of points on every soft box.
Colour arriving(const Vec& place, const Vec& normal) {
    constexpr int kGrid = 3;
    Colour sum{0.10f, 0.105f, 0.115f};
    for (const SoftBox& box : softBoxes()) {
        const float area = 4.0f * box.halfWidth * box.halfHeight / (kGrid * kGrid);
        for (int k = 0; k < kGrid * kGrid; ++k) {
            const int column = k % kGrid - 1;
            const int row = k / kGrid - 1;
            const float s = static_cast<float>(column) / 1.5f * box.halfWidth;
            const float t = static_cast<float>(row) / 1.5f * box.halfHeight;
            const Vec way = box.centre + box.right * s + box.up * t - place;
            const float squared = std::max(dot(way, way), 0.05f);
            const float cosines = std::max(dot(way, normal), 0.0f) * std::max(-dot(way, box.normal), 0.0f);
            sum = sum + box.light * (area * cosines / (kPi * squared * squared));
        }
    }
    return sum;
}

// Corners get less light than the middle of a wall.
float openness(const Vec& p) {
    const auto near = [](float distance) { return 1.0f - 0.55f * std::exp(-distance / 0.55f); };
    const float sides = near(kSideWall - std::abs(p.x));
    const float ends = near(kEndWall - std::abs(p.z));
    const float floorAndCeiling = near(p.y - kFloor) * near(kCeiling - p.y);
    // A surface is close to itself; that factor is taken out again.
    return sides * ends * floorAndCeiling / 0.45f;
}

// Boards along z, each with its own tone and grain; the joints are dark lines.
Colour boards(float x, float z) {
    constexpr float kWidth = 0.24f;
    constexpr float kLength = 2.1f;
    const int row = static_cast<int>(std::floor(x / kWidth));
    const float shifted = z / kLength + hashUnit(row, 0, 41u);
    const int board = static_cast<int>(std::floor(shifted));
    const float tone = hashUnit(row, board, 42u);
    const float ends = static_cast<float>(board) * 7.3f + static_cast<float>(row) * 3.7f;
    const float bend = 0.25f * tileNoise(z * 1.1f + ends, x * 2.0f, 4096, 4096, 43u);
    const float rings = tileNoise(x * 22.0f + bend * 9.0f, z * 0.6f + ends, 4096, 4096, 44u);
    const float fine = tileNoise(x * 95.0f, z * 3.0f + ends, 4096, 4096, 45u);
    const float gapX = (0.5f - std::abs(fraction(x / kWidth) - 0.5f)) * kWidth;
    const float gapZ = (0.5f - std::abs(fraction(shifted) - 0.5f)) * kLength;
    const float joint = smoothStep(0.0f, 0.008f, std::min(gapX, gapZ));
    const Colour wood =
        mix(fromHex(0x6B4A33), fromHex(0x9C7350), 0.15f + 0.5f * tone + 0.2f * rings + 0.08f * fine);
    return wood * mix(0.25f, 1.0f, joint);
}

struct Surface {
    Colour colour;
    Vec normal;
    float gloss = 0.0f;
};

// The backdrop hangs down the end wall and rolls out over the floor in one soft curve.
Surface paper(const Vec& p, const Vec& wallNormal) {
    const float turn = wallNormal.y > 0.5f ? 0.5f - 0.5f * smoothStep(0.0f, 1.6f, p.z + kEndWall)
                                           : 0.5f + 0.5f * smoothStep(0.0f, 1.6f, p.y - kFloor);
    const Vec normal = unit({0.0f, std::cos(0.5f * kPi * turn), std::sin(0.5f * kPi * turn)});
    const float cloud = 0.03f * tileNoise(p.x * 0.9f, (p.y - p.z) * 0.9f, 4096, 4096, 51u);
    return {fromHex(0xA39A90) * (1.0f + cloud), normal, 0.0f};
}

bool onPaper(const Vec& p, const Vec& normal) {
    if (std::abs(p.x) > kPaperHalfWidth)
        return false;
    return (normal.z > 0.5f && p.y < kPaperTop) || (normal.y > 0.5f && p.z < kPaperFront);
}

// Plaster above a painted dado with upright panels.
Surface wall(const Vec& p, const Vec& normal) {
    const float along = std::abs(normal.x) > 0.5f ? p.z : p.x;
    const float above = p.y - kFloor;
    const float plaster = 0.05f * tileNoise(along * 2.5f, p.y * 2.5f, 4096, 4096, 61u) +
                          0.03f * tileNoise(along * 9.0f, p.y * 9.0f, 4096, 4096, 62u);
    Colour colour = mix(fromHex(0x3E4650), fromHex(0x6C7075), smoothStep(1.095f, 1.105f, above));
    const float panel = 0.5f - std::abs(fraction(along / 1.25f) - 0.5f);
    const float frame = std::min(1.25f * panel - 0.1f, std::min(above - 0.28f, 0.98f - above));
    colour = colour * (1.0f - 0.45f * std::exp(-std::pow(frame / 0.018f, 2.0f)));
    const float rail = std::exp(-std::pow((above - 1.1f) / 0.03f, 2.0f));
    const float skirting = smoothStep(0.16f, 0.14f, above);
    colour = mix(colour, fromHex(0x8A8780), std::max(0.8f * rail, 0.5f * skirting));
    return {colour * (1.0f + plaster), normal, 0.0f};
}

// Dark, with beams across the room.
Surface ceiling(const Vec& p, const Vec& normal) {
    const float beam = 0.5f - std::abs(fraction(p.z / 1.5f) - 0.5f);
    const float onBeam = smoothStep(0.095f, 0.1f, beam);
    return {mix(fromHex(0x2A2622), fromHex(0x4A4B4D), onBeam) * mix(1.0f, 0.75f + beam * 0.5f, onBeam),
            normal, 0.0f};
}

Surface surfaceAt(const Vec& p, const Vec& normal) {
    if (onPaper(p, normal))
        return paper(p, normal);
    if (normal.y > 0.5f) {
        return {boards(p.x, p.z), normal, 1.0f};
    }
    return normal.y < -0.5f ? ceiling(p, normal) : wall(p, normal);
}

// The inside of a box has one wall per axis that a ray can leave through; the nearest is hit.
float leaveRoom(const Vec& from, const Vec& ray, Vec& normal) {
    const auto reach = [](float at, float step, float low, float high) {
        return std::abs(step) < 1e-6f ? 1e9f : ((step > 0.0f ? high : low) - at) / step;
    };
    const float x = reach(from.x, ray.x, -kSideWall, kSideWall);
    const float y = reach(from.y, ray.y, kFloor, kCeiling);
    const float z = reach(from.z, ray.z, -kEndWall, kEndWall);
    if (y <= x && y <= z) {
        normal = {0.0f, ray.y > 0.0f ? -1.0f : 1.0f, 0.0f};
        return y;
    }
    normal =
        x <= z ? Vec{ray.x > 0.0f ? -1.0f : 1.0f, 0.0f, 0.0f} : Vec{0.0f, 0.0f, ray.z > 0.0f ? -1.0f : 1.0f};
    return std::min(x, z);
}

Colour matte(const Vec& place, const Surface& surface) {
    return surface.colour * arriving(place, surface.normal) * openness(place);
}

// What polish adds to the floor: the walls as they are, the soft boxes with blurred edges.
Colour mirrored(const Vec& place, const Vec& ray) {
    const Vec up{ray.x, -ray.y, ray.z};
    Vec normal;
    const float distance = leaveRoom(place, up, normal);
    const Vec far = place + up * distance;
    Colour colour = matte(far, surfaceAt(far, normal));
    for (const SoftBox& box : softBoxes()) {
        laySoftBox(colour, box, place, up, distance, 0.22f, 1.0f);
    }
    const float fresnel = 0.05f + 0.6f * std::pow(1.0f + ray.y, 4.0f);
    return colour * fresnel;
}

// Film's soft shoulder: highlights run into white instead of being cut off.
Colour developed(const Colour& light) {
    const auto curve = [](float c) { return 1.0f - std::exp(-1.3f * c); };
    return {curve(light.r), curve(light.g), curve(light.b)};
}

} // namespace

Colour studio(float x, float y, float z) {
    const Vec ray = unit({x, y, z});
    Vec normal;
    const float distance = leaveRoom({}, ray, normal);
    const Vec place = ray * distance;
    const Surface surface = surfaceAt(place, normal);
    Colour colour = matte(place, surface);
    if (surface.gloss > 0.0f)
        colour = colour + mirrored(place, ray) * surface.gloss;
    for (const SoftBox& box : softBoxes()) {
        if (box.onStand)
            layStand(colour, box, ray);
        laySoftBox(colour, box, {}, ray, distance, 0.012f, kFaceLevel);
    }
    return developed(colour);
}

} // namespace clothlab::textures
