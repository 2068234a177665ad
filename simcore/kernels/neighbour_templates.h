// The kernels of self-collision, written once for any lanes; see lanes.h for what they may call.
#pragma once

#include "simcore/kernels/vector_row.h"

namespace clothlab {
namespace { // a copy for each file, see lanes.h

template <typename L>
class NeighbourTemplates {
    using V = typename L::Vector;
    using M = typename L::Mask;
    using Row = VectorRow<L>;

    static constexpr int kVectors = RowLayout::kLanes / L::kCount; // of a block
    static constexpr double kLaneNumbers[RowLayout::kLanes] = {0, 1, 2, 3, 4, 5, 6, 7};

public:
    static double farthestSquared(const RowLayout& layout, RowRange rows, ConstPointRows position,
                                  ConstPointRows there, const std::array<double, 3>& by) {
        const Row common{L::all(by[0]), L::all(by[1]), L::all(by[2])};
        const V lanes = L::load(kLaneNumbers);
        V farthest = L::all(0);
        for (int y = rows.begin; y < rows.end; ++y)
            for (int x = 0; x < layout.width; x += L::kCount) {
                const int slot = layout.slot(x, y);
                const Row moved = Row::load(position, slot) - Row::load(there, slot) - common;
                const V distanceSquared = moved.lengthSquared();
                const M isPoint = L::less(lanes, L::all(layout.width - x));
                const M farther = L::both(isPoint, L::less(farthest, distanceSquared));
                farthest = L::choose(farther, distanceSquared, farthest);
            }
        double each[L::kCount];
        L::store(each, farthest);
        double result = 0;
        for (const double lane : each)
            result = lane > result ? lane : result;
        return result;
    }

    static std::size_t adjacentPairs(const RowLayout& layout, RowRange rows, ConstPointRows position,
                                     double distance, SlotPair* pairs) {
        const V distanceSquared = L::all(distance * distance);
        const int offsets[4] = {1, layout.stride - 1, layout.stride, layout.stride + 1};
        std::size_t count = 0;
        for (int y = rows.begin; y < rows.end; ++y)
            for (int x = 0; x < layout.width; x += L::kCount) {
                const int a = layout.slot(x, y);
                const Row from = Row::load(position, a);
                unsigned all = 0; // bit 4 * lane + n: with the nth offset
                for (int n = 0; n < 4; ++n) {
                    const M near = isNear(from, Row::load(position, a + offsets[n]), distanceSquared);
                    all |= fourApart(L::bits(near)) << unsigned(n);
                }
                if (all != 0)
                    for (all &= adjacencyInSheet(layout, x, y); all != 0; all &= all - 1) {
                        const int bit = firstLane(all);
                        pairs[count++] = {std::uint32_t(a + bit / 4),
                                          std::uint32_t(a + bit / 4 + offsets[bit % 4])};
                    }
            }
        return count;
    }

    static std::size_t listedPairs(const RowLayout& layout, RowRange rows, const BlockLists& lists,
                                   ConstPointRows position, double distance, NearBlock* scratch,
                                   SlotPair* pairs) {
        const V distanceSquared = L::all(distance * distance);
        std::size_t count = 0, block = 0;
        std::uint32_t k = 0;
        for (int y = rows.begin; y < rows.end; ++y)
            for (int x = 0; x < layout.width; x += RowLayout::kLanes) {
                const std::uint32_t end = lists.end[block++];
                if (k == end)
                    continue;
                const int first = layout.slot(x, y);
                Row from[kVectors];
                for (int v = 0; v < kVectors; ++v)
                    from[v] = Row::load(position, first + v * L::kCount);
                std::size_t found = 0;
                for (; k < end; ++k) {
                    const NearBlock listed = lists.listed[k];
                    const Row place{L::all(position.x[listed.slot]), L::all(position.y[listed.slot]),
                                    L::all(position.z[listed.slot])};
                    unsigned lanes = 0;
                    for (int v = 0; v < kVectors; ++v)
                        lanes |= L::bits(isNear(from[v], place, distanceSquared)) << unsigned(v * L::kCount);
                    lanes &= listed.lanes;
                    scratch[found] = {listed.slot, lanes}; // without a branch that nothing could predict
                    found += unsigned(lanes != 0);
                }
                count += inOrder(std::uint32_t(first), scratch, found, pairs + count);
            }
        return count;
    }

    static std::size_t nearBlock(ConstPointRows position, int slot, double reach, const SortedPlaces& places,
                                 const PlaceRun* runs, std::size_t runCount, NearBlock* found) {
        const V reachSquared = L::all(reach * reach);
        Row block[kVectors];
        for (int v = 0; v < kVectors; ++v)
            block[v] = Row::load(position, slot + v * L::kCount);
        std::size_t count = 0;
        for (std::size_t r = 0; r < runCount; ++r)
            for (std::uint32_t k = runs[r].begin; k < runs[r].end; ++k) {
                const Row place{L::all(places.x[k]), L::all(places.y[k]), L::all(places.z[k])};
                unsigned lanes = 0;
                for (int v = 0; v < kVectors; ++v)
                    lanes |= L::bits(L::less((block[v] - place).lengthSquared(), reachSquared))
                             << unsigned(v * L::kCount);
                found[count] = {places.slot[k], lanes}; // without a branch that nothing could predict
                count += unsigned(lanes != 0);
            }
        return count;
    }

private:
    static M isNear(const Row& a, const Row& b, V distanceSquared) {
        const V lengthSquared = (a - b).lengthSquared();
        return L::both(L::less(lengthSquared, distanceSquared), L::less(L::all(0), lengthSquared));
    }

    // The pairs of a block, by lower, then by upper end. There are few.
    static std::size_t inOrder(std::uint32_t first, const NearBlock* found, std::size_t blocks,
                               SlotPair* pairs) {
        std::size_t count = 0;
        for (std::size_t n = 0; n < blocks; ++n)
            for (unsigned lanes = found[n].lanes; lanes != 0; lanes &= lanes - 1) {
                const SlotPair pair{first + std::uint32_t(firstLane(lanes)), found[n].slot};
                std::size_t at = count++;
                for (; at > 0 &&
                       (pairs[at - 1].a > pair.a || (pairs[at - 1].a == pair.a && pairs[at - 1].b > pair.b));
                     --at)
                    pairs[at] = pairs[at - 1];
                pairs[at] = pair;
            }
        return count;
    }

    static constexpr unsigned kFourApart[16] = {0x0000, 0x0001, 0x0010, 0x0011, 0x0100, 0x0101,
                                                0x0110, 0x0111, 0x1000, 0x1001, 0x1010, 0x1011,
                                                0x1100, 0x1101, 0x1110, 0x1111};
    static unsigned fourApart(unsigned bits) {
        return kFourApart[bits & 15U] | kFourApart[bits >> 4U] << 16U;
    }
    // The bits of adjacentPairs that stand for two points of the sheet.
    static unsigned adjacencyInSheet(const RowLayout& layout, int x, int y) {
        unsigned bits = 0;
        for (int lane = 0; lane < L::kCount && x + lane < layout.width; ++lane) {
            const bool right = x + lane + 1 < layout.width;
            const bool below = y + 1 < layout.height;
            bits |= (unsigned(right) | unsigned(below && x + lane > 0) << 1U | unsigned(below) << 2U |
                     unsigned(below && right) << 3U)
                    << unsigned(4 * lane);
        }
        return bits;
    }
};

} // namespace
} // namespace clothlab
