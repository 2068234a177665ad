// The order of the strain limit, spring after spring, kept by a pipeline: each stencil follows the one before
// it a few rows behind, in one pass over the sheet, and threads take a stencil or a few each.
#pragma once

#include "simcore/kernels/kernels.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace clothlab {

class StrainPipeline {
public:
    // For a number of threads, and the stencils that are switched on.
    void configure(int members, const StepData& data);

    void restart(); // before a run, by one thread

    // What one member does of the strain limit, at the same time as the others, once all rows are where the
    // phases before put them; pass: counts from 0 since restart(). The last member also looks for the first
    // runaway.
    struct Result {
        int corrections = 0;
        int runaway = -1; // slot
    };
    void advance(int member, int pass, const StepData& data, const Kernels& kernels, Result& result);

    // The same work, cut into rows instead of stencils, for who knows what is ready. A pass goes through
    // rows() rows, more than the sheet has; after row n of it, row n - rowsBehind() of the sheet is in its
    // final place.
    int rows() const { return m_rows; }
    int rowsBehind() const { return m_lastBehind; }
    void limitAt(int row, const StepData& data, const Kernels& kernels, Result& result) const;

private:
    struct Stage {
        int stencil;
        int rowsBehind; // the first stencil's row
    };
    struct alignas(64) Member {
        std::vector<Stage> stages;
        std::atomic<std::int64_t> rowsDone{0}; // over all passes; of sweeps, see advance()
    };
    void limit(const std::vector<Stage>& stages, int row, const StepData& data, const Kernels& kernels,
               Result& result) const;
    void findRunaway(int row, const StepData& data, const Kernels& kernels, Result& result) const;

    std::vector<Stage> m_stages;
    int m_rows = 0;       // of a pass: those of the sheet, and as many as the last stage is behind
    int m_lastBehind = 0; // a row is in its final place so many rows behind the first stencil's
    int m_count = 0;
    std::unique_ptr<Member[]> m_members;
};

} // namespace clothlab
