// The kernels, written once for any lanes; see lanes.h for what they may call.
#pragma once

#include "simcore/kernels/model_constants.h"
#include "simcore/kernels/neighbour_templates.h"

namespace clothlab {
namespace { // a copy for each file, see lanes.h

template <typename L>
class KernelTemplates {
    using V = typename L::Vector;
    using M = typename L::Mask;
    using Row = VectorRow<L>;

    static int slotOffset(const RowLayout& layout, int stencil) {
        return kStencils[std::size_t(stencil)].dy * layout.stride + kStencils[std::size_t(stencil)].dx;
    }

    // True where a point has run away, and where that cannot be told because it is not a number.
    static M isRunaway(const Row& moved, V limitSquared) {
        const M within = L::less(moved.lengthSquared(), limitSquared);
        return L::butNot(L::less(L::all(0), L::all(1)), within);
    }

    // Rows of forces that verletRows holds at a time: a point is pulled a row after the last spring that it
    // takes, by those of its own row, of the next and of the one after.
    static constexpr int kRowsHeld[6] = {2, 3, 3, 3, 2, 4};
    static constexpr int kFirstRow[6] = {0, 2, 5, 8, 11, 13};
    static_assert(kFirstRow[5] + kRowsHeld[5] == ForceRows::kRows);

    // Forces on the ends a of the springs of a stencil that start in row y, one coordinate after another.
    static double* forceRow(ForceRows& forces, int stencil, int y) {
        return forces.row(kFirstRow[stencil] + (y + 4) % kRowsHeld[stencil]);
    }

    static V stiffness(const StepData& data, int s) {
        return L::all(data.enabled[std::size_t(s)] ? data.stiffness[std::size_t(s)] : 0);
    }

    // Springs that start at the same row of lanes: from end to end, and how long.
    struct Springs {
        Row along;
        V length;
    };
    static Springs springs(const StepData& data, int a, int offset) {
        const Row along = Row::load(data.position, a + offset) - Row::load(data.position, a);
        return {along, L::squareRoot(along.lengthSquared())};
    }
    static void pull(const Springs& springs, V stiffness, const double* rest, double* to, int rowLength) {
        const V quotient = stiffness * (springs.length - L::load(rest)) / springs.length;
        // Minus infinity, or not a number, where there is no spring, and where one without length has no
        // direction to pull in.
        const Row force = springs.along * L::orZero(L::less(L::all(-kNoSpring), quotient), quotient);
        L::store(to, force.x);
        L::store(to + rowLength, force.y);
        L::store(to + 2 * rowLength, force.z);
    }

    static void pullRow(const StepData& data, int s, int y, ForceRows& forces) {
        const int offset = slotOffset(data.layout, s);
        const V k = stiffness(data, s);
        const double* const rest = data.restLength[std::size_t(s)][y];
        double* const to = forceRow(forces, s, y);
        for (int x = 0; x < data.layout.width; x += L::kCount)
            pull(springs(data, data.layout.slot(x, y), offset), k, rest + x, to + x, forces.length);
    }

    // All springs that the points of row y take.
    static void pullFirstRows(const StepData& data, int y, ForceRows& forces) {
        for (int s = 0; s < 6; ++s)
            for (int row = y; row <= y - kStencils[std::size_t(s)].dy; ++row)
                pullRow(data, s, row, forces);
    }

    // What moves the points of one row: the rows of forces on them as ends a and b of each stencil.
    struct Pulls {
        const double* asA[6];
        const double* asB[6];
    };
    static Pulls pullsOf(ForceRows& forces, int y) {
        Pulls pulls{};
        for (int s = 0; s < 6; ++s) {
            pulls.asA[s] = forceRow(forces, s, y);
            pulls.asB[s] =
                forceRow(forces, s, y - kStencils[std::size_t(s)].dy) - kStencils[std::size_t(s)].dx;
        }
        return pulls;
    }
    static void addPulls(const Pulls& pulls, int s, int at, int length, Row& force) {
        const double* const asA = pulls.asA[s] + at;
        const double* const asB = pulls.asB[s] + at;
        force.x = force.x + L::load(asA) - L::load(asB);
        force.y = force.y + L::load(asA + length) - L::load(asB + length);
        force.z = force.z + L::load(asA + 2 * length) - L::load(asB + 2 * length);
    }

    // Where the points from a slot on go. Those that run away, as bits.
    static unsigned move(const StepData& data, const Row& force, int slot) {
        const Row current = Row::load(data.position, slot);
        const Row last = Row::load(data.last, slot);
        const Row next = current + (current - last) * L::all(data.keep) + force * L::all(data.gain);
        const Row moved = Row::choose(L::fromBytes(data.pinned + slot), current, next);
        moved.store(data.last, slot);
        return L::bits(isRunaway(moved - current, L::all(data.runawayDistance * data.runawayDistance)));
    }

public:
    // Each kernel works on a copy of what it is given: as far as the compiler knows, storing a vector may
    // change anything that is not its own.

    // One pass computes the springs that the points of row y are the last to need, and moves the points of
    // the row before. The two take turns stencil by stencil, so that the processor has forces to add while it
    // waits for square roots and quotients.
    static int verletRows(const StepData& shared, RowRange rows, ForceRows& forces, bool goingOn) {
        const StepData data = shared;
        const int rowLength = forces.length;
        if (!goingOn)
            pullFirstRows(data, rows.begin, forces);
        V stiffnesses[6];
        int offsets[6];
        for (int s = 0; s < 6; ++s) {
            stiffnesses[s] = stiffness(data, s);
            offsets[s] = slotOffset(data.layout, s);
        }
        const Row weight{L::all(data.weight[0]), L::all(data.weight[1]), L::all(data.weight[2])};
        int runaway = -1;
        for (int y = rows.begin + 1; y <= rows.end; ++y) {
            double* to[6];
            const double* rest[6];
            for (int s = 0; s < 6; ++s) {
                const int row = y - kStencils[std::size_t(s)].dy;
                to[s] = forceRow(forces, s, row);
                rest[s] = data.restLength[std::size_t(s)][row];
            }
            const Pulls pulls = pullsOf(forces, y - 1);
            for (int x = 0; x < data.layout.width; x += L::kCount) {
                const int a = data.layout.slot(x, y);
                Row force = weight;
                Springs all[6];
#pragma GCC unroll 6
                for (int s = 0; s < 6; ++s)
                    all[s] = springs(data, a - kStencils[std::size_t(s)].dy * data.layout.stride, offsets[s]);
#pragma GCC unroll 6
                for (int s = 0; s < 6; ++s) {
                    pull(all[s], stiffnesses[s], rest[s] + x, to[s] + x, rowLength);
                    addPulls(pulls, s, x, rowLength, force);
                }
                const unsigned out = move(data, force, a - data.layout.stride);
                if (out != 0 && runaway < 0)
                    runaway = a - data.layout.stride + firstLane(out);
            }
        }
        return runaway;
    }

    static void collideSphere(const StepData& shared, RowRange rows, const SphereData& sphere) {
        const StepData data = shared; // see above
        const Row origin{L::all(sphere.x), L::all(sphere.y), L::all(sphere.z)};
        const V radius = L::all(sphere.radius);
        const V slide = L::all(1 - sphere.friction);
        const V zero = L::all(0);
        for (int y = rows.begin; y < rows.end; ++y)
            for (int x = 0; x < data.layout.width; x += L::kCount) {
                const int slot = data.layout.slot(x, y);
                const Row position = Row::load(data.position, slot);
                const Row offset = position - origin;
                const V distanceSquared = offset.lengthSquared();
                const M inside =
                    L::butNot(L::less(distanceSquared, radius * radius), L::fromBytes(data.pinned + slot));
                if (L::bits(inside) == 0)
                    continue;
                const V distance = L::squareRoot(distanceSquared);
                const M off = L::less(zero, distance); // a point at the origin leaves along +y
                const Row direction =
                    Row::choose(off, {offset.x / distance, offset.y / distance, offset.z / distance},
                                {zero, L::all(1), zero});
                const Row last = Row::load(data.last, slot);
                const Row moved = last + (origin + direction * radius - last) * slide;
                Row::choose(inside, moved, position).store(data.position, slot);
            }
    }

    static void collidePlane(const StepData& shared, RowRange rows, const PlaneData& plane) {
        const StepData data = shared; // see above
        const Row point{L::all(plane.x), L::all(plane.y), L::all(plane.z)};
        const Row normal{L::all(plane.nx), L::all(plane.ny), L::all(plane.nz)};
        const V slide = L::all(1 - plane.friction);
        const V zero = L::all(0);
        const auto heightOf = [&](const Row& p) {
            const Row d = p - point;
            return (d.x * normal.x + d.y * normal.y) + d.z * normal.z;
        };
        for (int y = rows.begin; y < rows.end; ++y)
            for (int x = 0; x < data.layout.width; x += L::kCount) {
                const int slot = data.layout.slot(x, y);
                const Row position = Row::load(data.position, slot);
                const Row last = Row::load(data.last, slot);
                const V height = heightOf(position);
                const M below = L::less(height, zero);
                const M cameFromBelow = L::less(heightOf(last), zero);
                const M crossed = L::either(L::butNot(below, cameFromBelow), L::butNot(cameFromBelow, below));
                const M moves = L::butNot(crossed, L::fromBytes(data.pinned + slot));
                if (L::bits(moves) == 0)
                    continue;
                const V target = L::choose(cameFromBelow, L::all(-kPlaneOffset), L::all(kPlaneOffset));
                const Row tangent = position + normal * (target - height);
                const Row moved = last + (tangent - last) * slide;
                Row::choose(moves, moved, position).store(data.position, slot);
            }
    }

    static int limitRows(const StepData& shared, const StencilRow* rows, int count) {
        const StepData data = shared;
        int corrections = 0;
        for (int n = 0; n < count; ++n)
            // Springs that lie in their row may end where the next one starts.
            corrections += kStencils[std::size_t(rows[n].stencil)].dy == 0
                               ? limitRow<true>(data, rows[n].stencil, rows[n].y)
                               : limitRow<false>(data, rows[n].stencil, rows[n].y);
        return corrections;
    }

    static bool anyTooLong(const StepData& shared, StencilRow row) {
        const StepData data = shared;
        const int offset = slotOffset(data.layout, row.stencil);
        const double* const rest = data.restLength[std::size_t(row.stencil)][row.y];
        M any = L::less(L::all(0), L::all(0));
        for (int x = 0; x < data.layout.width; x += L::kCount) {
            const int a = data.layout.slot(x, row.y);
            const Row along = Row::load(data.position, a + offset) - Row::load(data.position, a);
            const V limit = longest(rest + x);
            any = L::either(any, L::less(limit * limit, along.lengthSquared()));
        }
        return L::bits(any) != 0;
    }

    static int firstRunaway(const StepData& shared, RowRange rows) {
        const StepData data = shared; // see above
        const V limitSquared = L::all(data.runawayDistance * data.runawayDistance);
        for (int y = rows.begin; y < rows.end; ++y)
            for (int x = 0; x < data.layout.width; x += L::kCount) {
                const int slot = data.layout.slot(x, y);
                const Row moved = Row::load(data.position, slot) - Row::load(data.last, slot);
                if (const unsigned out = L::bits(isRunaway(moved, limitSquared)); out != 0)
                    return slot + firstLane(out);
            }
        return -1;
    }

private:
    static V longest(const double* rest) {
        return L::all(1 + kMaxStrain) * L::load(rest);
    }

    template <bool chained>
    static int limitRow(const StepData& data, int stencil, int y) {
        const int offset = slotOffset(data.layout, stencil);
        const double* const rest = data.restLength[std::size_t(stencil)][y];
        int corrections = 0;
        for (int x = 0; x < data.layout.width; x += L::kCount) {
            const int a = data.layout.slot(x, y);
            const Row pa = Row::load(data.position, a);
            const Row pb = Row::load(data.position, a + offset);
            const V limit = longest(rest + x);
            const M tooLong = L::less(limit * limit, (pb - pa).lengthSquared());
            if (L::bits(tooLong) == 0)
                continue;
            if constexpr (chained)
                corrections += limitChain(data, rest + x, L::bits(tooLong), a, offset);
            else
                corrections += limitBlock(data, pa, pb, limit, tooLong, a, a + offset);
        }
        return corrections;
    }

    // Springs that have no ends in common.
    static int limitBlock(const StepData& data, const Row& pa, const Row& pb, V limit, M tooLong, int a,
                          int b) {
        const M aPinned = L::fromBytes(data.pinned + a);
        const M bPinned = L::fromBytes(data.pinned + b);
        const M moves = L::butNot(tooLong, L::both(aPinned, bPinned));
        const Row along = pb - pa;
        const V length = L::squareRoot(along.lengthSquared());
        const Row excess = along * ((length - limit) / length);
        const V shareOfA = L::choose(aPinned, L::all(0), L::choose(bPinned, L::all(1), L::all(0.5)));
        Row::choose(moves, pa + excess * shareOfA, pa).store(data.position, a);
        Row::choose(moves, pb - excess * (L::all(1) - shareOfA), pb).store(data.position, b);
        return __builtin_popcount(L::bits(moves));
    }

    // Springs that may end where another of them starts: those that are too long, as bits, and those that
    // become so when one before them is shortened.
    static int limitChain(const StepData& data, const double* rest, unsigned tooLong, int a, int offset) {
        constexpr unsigned lanes = (1U << unsigned(L::kCount)) - 1;
        int corrections = 0;
        for (; tooLong != 0; tooLong &= tooLong - 1) {
            const int n = firstLane(tooLong);
            if (limitSpring(data, rest[n], a + n, a + n + offset) == 0)
                continue;
            ++corrections;
            tooLong |= (1U << unsigned(n - offset)) & lanes; // the one that ends where this one starts
        }
        return corrections;
    }

    // One spring of the strain limit. 1 if it was too long and an end of it may move.
    static int limitSpring(const StepData& data, double atRest, int a, int b) {
        using One = VectorRow<ScalarLanes>;
        const double limit = (1 + kMaxStrain) * atRest;
        const One pa = One::load(data.position, a);
        const One pb = One::load(data.position, b);
        const One along = pb - pa;
        const double lengthSquared = along.lengthSquared();
        const bool aPinned = data.pinned[a] != 0;
        const bool bPinned = data.pinned[b] != 0;
        if (!(lengthSquared > limit * limit) || (aPinned && bPinned))
            return 0;
        const double length = ScalarLanes::squareRoot(lengthSquared);
        const One excess = along * ((length - limit) / length);
        const double shareOfA = aPinned ? 0 : bPinned ? 1 : 0.5;
        (pa + excess * shareOfA).store(data.position, a);
        (pb - excess * (1 - shareOfA)).store(data.position, b);
        return 1;
    }
};

template <typename L>
constexpr Kernels makeKernels() {
    using K = KernelTemplates<L>;
    using N = NeighbourTemplates<L>;
    return {&K::verletRows,   &K::collideSphere,   &K::collidePlane,  &K::limitRows,   &K::anyTooLong,
            &K::firstRunaway, &N::farthestSquared, &N::adjacentPairs, &N::listedPairs, &N::nearBlock};
}

} // namespace
} // namespace clothlab
