// The order of the strain limit, spring after spring, kept by a pipeline: each stencil follows the one before
// it a few rows behind, in one pass over the sheet.
#pragma once

#include "simcore/kernels/kernels.h"

#include <cstdint>
#include <vector>

namespace clothlab {

class StrainPipeline {
public:
    void configure(const StepData& data); // for the stencils that are switched on

    // A pass goes through so many rows, one after another, more than the sheet has; after row n of it, row
    // n - rowsBehind() of the sheet is in its final place.
    int rows() const { return m_rows; }
    int rowsBehind() const { return m_rowsBehind; }

    // A row of the pass. How many springs it shortened.
    int limitAt(int row, const StepData& data, const Kernels& kernels) const;

    // Which of some rows of the sheet need no correction, for all that is known. A thread that waits for its
    // turn looks before, and then needs to go through those only that are too long or were moved since.
    class Glance {
    public:
        explicit Glance(RowRange rows);

    private:
        friend class StrainPipeline;
        bool isCalm(int stencil, int y) const; // its springs that start in row y
        void setMoved(int y);

        RowRange m_rows;
        std::vector<std::uint8_t> m_tooLong; // by row, a bit a stencil
        std::vector<std::uint8_t> m_moved;   // by row
    };
    void look(const StepData& data, const Kernels& kernels, Glance& glance) const;
    int limitAt(int row, const StepData& data, const Kernels& kernels, Glance& glance) const;

private:
    struct Stage {
        int stencil;
        int rowsBehind; // the row of the pass
    };
    std::vector<Stage> m_stages;
    int m_rows = 0;
    int m_rowsBehind = 0;
};

} // namespace clothlab
