#include "tests/support/settings.h"

#include "tests/support/in_rows.h"

namespace clothlab {

std::string describe(const SolverSettings& settings) {
    return std::string(name(settings.instructionSet)) + ", " + std::to_string(settings.threads) + " threads";
}

SolverSettings plainSettings() {
    return {1, 1, InstructionSet::Scalar};
}

std::vector<SolverSettings> allSettings() {
    std::vector<SolverSettings> all;
    for (const int threads : {1, 2, 3, 8})
        for (const InstructionSet set : supportedInstructionSets())
            all.push_back({threads, 1, set});
    return all;
}

} // namespace clothlab
