#include "app/render/sheet_normals.h"

#include "app/render/vector_math.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>

namespace clothlab::render {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kLeastArea = 1e-20F;
constexpr float kLeast = std::numeric_limits<float>::min();
constexpr float kLeastLengthSquared = 1e-30F;
constexpr float kLargest = std::numeric_limits<float>::max();

// Angle whose cosine is given, within 7e-5 rad (Abramowitz and Stegun 4.4.45): a weight needs no more, and
// std::acos would be most of the time of a large sheet.
inline float approximateAcos(float cosine) {
    const float x = std::min(std::abs(cosine), 1.0F);
    const float angle =
        std::sqrt(1 - x) * (1.5707288F + x * (-0.2121144F + x * (0.0742610F - x * 0.0187293F)));
    return cosine < 0 ? kPi - angle : angle;
}

// One row of points, by axis.
struct Row {
    const float* x;
    const float* y;
    const float* z;
    Row from(std::ptrdiff_t offset) const { return {x + offset, y + offset, z + offset}; }
};

struct MutableRow {
    float* x;
    float* y;
    float* z;
    MutableRow from(std::ptrdiff_t offset) const { return {x + offset, y + offset, z + offset}; }
};

Row rowOf(const FloatRows& rows, std::ptrdiff_t begin) {
    return {rows.x.data() + begin, rows.y.data() + begin, rows.z.data() + begin};
}

MutableRow rowOf(FloatRows& rows, std::ptrdiff_t begin) {
    return {rows.x.data() + begin, rows.y.data() + begin, rows.z.data() + begin};
}

// Arrays that a loop writes never overlap those that it reads, which compilers cannot know and need for
// vector code.
#ifdef __clang__
#define CLOTHLAB_NO_OVERLAP _Pragma("clang loop vectorize(assume_safety)")
#else
#define CLOTHLAB_NO_OVERLAP _Pragma("GCC ivdep")
#endif

// Unit normals and angles of `count` triangles a[i], b[i], c[i].
void measure(Row a, Row b, Row c, std::ptrdiff_t count, NormalScratch::Triangles& out) {
    const MutableRow normal = rowOf(out.normal, 0);
    float* const angleA = out.a.data();
    float* const angleB = out.b.data();
    float* const angleC = out.c.data();
    CLOTHLAB_NO_OVERLAP
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float abX = b.x[i] - a.x[i], abY = b.y[i] - a.y[i], abZ = b.z[i] - a.z[i];
        const float acX = c.x[i] - a.x[i], acY = c.y[i] - a.y[i], acZ = c.z[i] - a.z[i];
        const float bcX = c.x[i] - b.x[i], bcY = c.y[i] - b.y[i], bcZ = c.z[i] - b.z[i];
        const float nX = abY * acZ - abZ * acY;
        const float nY = abZ * acX - abX * acZ;
        const float nZ = abX * acY - abY * acX;
        const float abSquared = abX * abX + abY * abY + abZ * abZ;
        const float acSquared = acX * acX + acY * acY + acZ * acZ;
        const float bcSquared = bcX * bcX + bcY * bcY + bcZ * bcZ;
        const float doubleArea = std::sqrt(nX * nX + nY * nY + nZ * nZ);
        const float scale = 1 / std::max(doubleArea, kLeastArea);
        const float cosA =
            (abX * acX + abY * acY + abZ * acZ) / std::sqrt(std::max(abSquared * acSquared, kLeast));
        const float cosB =
            -(abX * bcX + abY * bcY + abZ * bcZ) / std::sqrt(std::max(abSquared * bcSquared, kLeast));
        const float counts = doubleArea > kLeastArea ? 1.0F : 0.0F;
        const float atA = approximateAcos(cosA);
        const float atB = approximateAcos(cosB);
        normal.x[i] = nX * scale;
        normal.y[i] = nY * scale;
        normal.z[i] = nZ * scale;
        angleA[i] = counts * atA;
        angleB[i] = counts * atB;
        angleC[i] = counts * std::max(0.0F, kPi - atA - atB);
    }
}

void addWeighted(const NormalScratch::Triangles& triangles, const std::vector<float>& weights,
                 std::ptrdiff_t count, MutableRow to) {
    const Row normal = rowOf(triangles.normal, 0);
    const float* const weight = weights.data();
    CLOTHLAB_NO_OVERLAP
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        to.x[i] += weight[i] * normal.x[i];
        to.y[i] += weight[i] * normal.y[i];
        to.z[i] += weight[i] * normal.z[i];
    }
}

void resizeScratch(NormalScratch& scratch, std::ptrdiff_t cells) {
    for (NormalScratch::Triangles* triangles : {&scratch.upper, &scratch.lower}) {
        triangles->normal.resize(static_cast<std::size_t>(cells));
        for (std::vector<float>* angles : {&triangles->a, &triangles->b, &triangles->c})
            angles->resize(static_cast<std::size_t>(cells));
    }
}

// What the cells between two rows of points give to the normals of both.
void addCells(Row above, Row below, std::ptrdiff_t cells, NormalScratch& scratch, MutableRow sumAbove,
              MutableRow sumBelow) {
    measure(above, below, above.from(1), cells, scratch.upper);
    measure(above.from(1), below, below.from(1), cells, scratch.lower);
    addWeighted(scratch.upper, scratch.upper.a, cells, sumAbove);
    addWeighted(scratch.upper, scratch.upper.b, cells, sumBelow);
    addWeighted(scratch.upper, scratch.upper.c, cells, sumAbove.from(1));
    addWeighted(scratch.lower, scratch.lower.a, cells, sumAbove.from(1));
    addWeighted(scratch.lower, scratch.lower.b, cells, sumBelow);
    addWeighted(scratch.lower, scratch.lower.c, cells, sumBelow.from(1));
}

// Each to unit length, or (0, 1, 0) where it has no direction.
void normalize(MutableRow row, std::ptrdiff_t count) {
    CLOTHLAB_NO_OVERLAP
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const float x = row.x[i], y = row.y[i], z = row.z[i];
        const float lengthSquared = x * x + y * y + z * z;
        const bool good = (lengthSquared > kLeastLengthSquared) & (lengthSquared <= kLargest);
        const float scale = 1 / std::sqrt(lengthSquared);
        row.x[i] = good ? x * scale : 0;
        row.y[i] = good ? y * scale : 1;
        row.z[i] = good ? z * scale : 0;
    }
}

// Of the points between the first and the last of a row, with the neighbours on both sides; at the ends with
// the one.
Vec3 alongRow(Row p, std::ptrdiff_t x, std::ptrdiff_t width) {
    const std::ptrdiff_t after = std::min(x + 1, width - 1);
    const std::ptrdiff_t before = std::max(x - 1, std::ptrdiff_t{0});
    return {p.x[after] - p.x[before], p.y[after] - p.y[before], p.z[after] - p.z[before]};
}

void setTangent(Row p, Row n, std::ptrdiff_t x, std::ptrdiff_t width, MutableRow t) {
    const Vec3 normal{n.x[x], n.y[x], n.z[x]};
    const Vec3 along = alongRow(p, x, width);
    const Vec3 tangent = normalizedOr(along - dot(along, normal) * normal, anyPerpendicular(normal));
    t.x[x] = tangent[0];
    t.y[x] = tangent[1];
    t.z[x] = tangent[2];
}

void tangentsOfRow(Row p, Row n, std::ptrdiff_t width, MutableRow t) {
    int bad = 0;
    CLOTHLAB_NO_OVERLAP
    for (std::ptrdiff_t x = 1; x < width - 1; ++x) {
        const float aX = p.x[x + 1] - p.x[x - 1], aY = p.y[x + 1] - p.y[x - 1], aZ = p.z[x + 1] - p.z[x - 1];
        const float part = aX * n.x[x] + aY * n.y[x] + aZ * n.z[x];
        const float bX = aX - part * n.x[x], bY = aY - part * n.y[x], bZ = aZ - part * n.z[x];
        const float lengthSquared = bX * bX + bY * bY + bZ * bZ;
        const float scale = 1 / std::sqrt(lengthSquared);
        t.x[x] = bX * scale;
        t.y[x] = bY * scale;
        t.z[x] = bZ * scale;
        bad += ((lengthSquared > kLeastLengthSquared) & (lengthSquared <= kLargest)) ? 0 : 1;
    }
    // The ends, and where a direction is missing, which is rare.
    for (const std::ptrdiff_t x : {std::ptrdiff_t{0}, width - 1})
        setTangent(p, n, x, width, t);
    for (std::ptrdiff_t x = 1; bad > 0 && x + 1 < width; ++x)
        setTangent(p, n, x, width, t);
}

} // namespace

void computeDirections(const FloatRows& positions, int width, int height, NormalScratch& scratch,
                       FloatRows& normals, FloatRows& tangents) {
    const std::ptrdiff_t stride = width;
    const std::ptrdiff_t cells = stride - 1;
    resizeScratch(scratch, cells);
    for (std::vector<float>* axis : {&normals.x, &normals.y, &normals.z})
        std::fill_n(axis->begin(), stride, 0.0F);
    for (int y = 0; y < height; ++y) {
        const Row here = rowOf(positions, y * stride);
        const MutableRow normal = rowOf(normals, y * stride);
        if (y + 1 < height) {
            for (std::vector<float>* axis : {&normals.x, &normals.y, &normals.z})
                std::fill_n(axis->begin() + (y + 1) * stride, stride, 0.0F);
            addCells(here, here.from(stride), cells, scratch, normal, normal.from(stride));
        }
        normalize(normal, stride);
        tangentsOfRow(here, {normal.x, normal.y, normal.z}, stride, rowOf(tangents, y * stride));
    }
}

} // namespace clothlab::render
