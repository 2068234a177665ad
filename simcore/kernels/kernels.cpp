#include "simcore/kernels/kernels.h"

#include <cassert>

namespace clothlab {

// Each in a file of its own, compiled for its instruction set.
const Kernels& scalarKernels();
const Kernels& sse2Kernels();
const Kernels& avx2Kernels();

ForceRows::ForceRows(const RowLayout& layout)
    : length(RowLayout::spread(layout.stride + 2 * kBefore)),
      values(std::size_t(kRows) * 3 * std::size_t(length) + 2 * kBefore) {}

std::string_view name(InstructionSet set) {
    constexpr std::array<std::string_view, 3> names{"scalar", "SSE2", "AVX2"};
    return names[std::size_t(set)];
}

#if defined(__x86_64__)

bool isSupported(InstructionSet set) {
    return set != InstructionSet::Avx2 || __builtin_cpu_supports("avx2") != 0;
}

const Kernels& kernelsFor(InstructionSet set) {
    assert(isSupported(set));
    switch (set) {
    case InstructionSet::Scalar:
        return scalarKernels();
    case InstructionSet::Sse2:
        return sse2Kernels();
    case InstructionSet::Avx2:
        return avx2Kernels();
    }
    return scalarKernels();
}

#else

bool isSupported(InstructionSet set) {
    return set == InstructionSet::Scalar;
}

const Kernels& kernelsFor([[maybe_unused]] InstructionSet set) {
    assert(isSupported(set));
    return scalarKernels();
}

#endif

InstructionSet bestInstructionSet() {
    for (const InstructionSet set : {InstructionSet::Avx2, InstructionSet::Sse2})
        if (isSupported(set))
            return set;
    return InstructionSet::Scalar;
}

} // namespace clothlab
