// The inner loops of a step, compiled once for each instruction set. All give the same bits. Lengths in
// metres.
#pragma once

#include "simcore/cloth/padded_rows.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace clothlab {

enum class InstructionSet { Scalar, Sse2, Avx2, Avx512 };
std::string_view name(InstructionSet set); // "AVX2"
bool isSupported(InstructionSet set);      // by this machine and this build
InstructionSet bestInstructionSet();

// What a step needs to know of the sheet, in SI units. Lengths of all arrays: as the layout says.
struct StepData {
    RowLayout layout;
    // By stencil and row, also of the rows after the last; kNoSpring where no spring starts.
    std::array<const double* const*, kStencils.size()> restLength{};
    std::array<double, kStencils.size()> stiffness{};
    std::array<bool, kStencils.size()> enabled{};
    const std::uint8_t* pinned = nullptr; // 1: never moves; also around the points
    std::array<double, 3> weight{};       // of a point; no negative zero
    double keep = 1;                      // share of the velocity that damping leaves
    double gain = 0;                      // dt² / mass
    double runawayDistance = 0;           // in one step

    PointRows position; // of the points now
    PointRows last;     // one step earlier
};

inline constexpr double kNoSpring = std::numeric_limits<double>::infinity(); // as a rest length

// The springs of a stencil that start in row y.
struct StencilRow {
    int stencil;
    int y;
};

struct SphereData {
    double x, y, z, radius, friction;
};
struct PlaneData {
    double x, y, z;    // a point of it
    double nx, ny, nz; // of length 1
    double friction;
};

// Buffers of verletRows for one thread: rows of spring forces. All zero at first.
struct ForceRows {
    static constexpr int kRows = 17;
    static constexpr int kBefore = RowLayout::kLanes; // in front of the first point of a row

    explicit ForceRows(const RowLayout& layout);
    double* row(int n) { return values.data() + std::size_t(n) * 3 * std::size_t(length) + kBefore; }

    int length = 0; // of one coordinate of a row, with what is around the points
    std::vector<double> values;
};

// Two points that are too near each other, a < b.
struct SlotPair {
    std::uint32_t a, b;
};

// Places sorted by the cell they are in, and runs of them.
struct SortedPlaces {
    const double* x;
    const double* y;
    const double* z;
    const std::uint32_t* slot;
};
struct PlaceRun {
    std::uint32_t begin, end;
};
// A point near some of the points of a block of RowLayout::kLanes: bit n for the block's nth.
struct NearBlock {
    std::uint32_t slot;
    std::uint32_t lanes;
};

// Lists of the blocks of some rows, one after another: where each ends, and all entries.
struct BlockLists {
    const std::uint32_t* end;
    const NearBlock* listed;
};

// Slots; -1: none. All functions that look for a runaway give the first slot whose point has moved
// runawayDistance or more since its last position, or has no finite place.
struct Kernels {
    // Phases 1 and 2. Where a point will be goes to data.last, so that forces come from the old positions
    // however the sheet is cut into ranges; the caller then exchanges position and last. goingOn: `forces` is
    // as the call for the rows right before these left it.
    int (*verletRows)(const StepData& data, RowRange rows, ForceRows& forces, bool goingOn);
    // Phase 4.
    void (*collideSphere)(const StepData& data, RowRange rows, const SphereData& sphere);
    void (*collidePlane)(const StepData& data, RowRange rows, const PlaneData& plane);
    // Phase 5 for the springs of a stencil that start in a row, one stencil and row after another. How many
    // it shortened.
    int (*limitRows)(const StepData& data, const StencilRow* rows, int count);
    // Whether one of the springs of a stencil that start in a row is too long.
    bool (*anyTooLong)(const StepData& data, StencilRow row);

    int (*firstRunaway)(const StepData& data, RowRange rows);

    // Of phase 3. The greatest squared distance of a point from there + by.
    double (*farthestSquared)(const RowLayout& layout, RowRange rows, ConstPointRows position,
                              ConstPointRows there, const std::array<double, 3>& by);
    // The pairs nearer than the distance, but not at one place, whose lower end is in the rows and whose
    // upper one is next to it in the grid, also diagonally. In order; at most four a point. Returns how many.
    std::size_t (*adjacentPairs)(const RowLayout& layout, RowRange rows, ConstPointRows position,
                                 double distance, SlotPair* pairs);
    // The listed pairs that are nearer than the distance, but not at one place, whose lower ends are in the
    // rows. In order. Room in `scratch` for the longest list of a block.
    std::size_t (*listedPairs)(const RowLayout& layout, RowRange rows, const BlockLists& lists,
                               ConstPointRows position, double distance, NearBlock* scratch, SlotPair* pairs);
    // Of the places of the runs, those nearer than reach to a point of the block that begins at `slot`. Room
    // for all of them in `found`. Returns how many.
    std::size_t (*nearBlock)(ConstPointRows position, int slot, double reach, const SortedPlaces& places,
                             const PlaceRun* runs, std::size_t runCount, NearBlock* found);
};

const Kernels& kernelsFor(InstructionSet set); // precondition: isSupported(set)

} // namespace clothlab
