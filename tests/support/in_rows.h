// Phases of a step on their own, on points that need not be a sheet.
#pragma once

#include "simcore/collision/colliders.h"
#include "simcore/collision/self_collision.h"

#include <memory>
#include <string>

namespace clothlab {

std::vector<InstructionSet> supportedInstructionSets();

// How points are laid out for self-collision, which must make no difference.
struct CloudLayout {
    InstructionSet instructionSet = bestInstructionSet();
    int width = 0; // points a row; 0, or what does not divide them: all in one
    int bands = 1; // at most
    std::string describe() const;
};

// Self-collision of any points. Keeps its lists from call to call, as a solver does from step to step.
class CloudCollision {
public:
    explicit CloudCollision(const CloudLayout& layout = {}) : m_layout(layout) {}
    // Returns how many points are moved.
    int corrections(const PointArray& position, const std::vector<std::uint8_t>& pinned, double distance,
                    double share, PointArray& correction);
    int listings() const { return m_listings; } // how often lists were made

private:
    void lay(int count);

    CloudLayout m_layout;
    RowLayout m_rows;
    std::vector<RowRange> m_bands;
    int m_listings = 0;
    RowArrays m_arrays;
    std::unique_ptr<SelfCollision> m_collision;
};

// The colliders of the scene, and nothing else of it, on all points in one row.
void collideWith(const Scene& scene, InstructionSet set, const std::vector<std::uint8_t>& pinned,
                 ClothState& state);

} // namespace clothlab
