#include "simcore/kernels/kernels.h"

#include <cassert>

namespace clothlab {

// Each in a file of its own, compiled for its instruction set.
const Kernels& scalarKernels();
const Kernels& sse2Kernels();
const Kernels& avx2Kernels();
const Kernels& avx512Kernels();

ForceRows::ForceRows(const RowLayout& layout)
    : length(RowLayout::spread(layout.stride + 2 * kBefore)),
      values(std::size_t(kRows) * 3 * std::size_t(length) + 2 * kBefore) {}

std::string_view name(InstructionSet set) {
    constexpr std::array<std::string_view, 4> names{"scalar", "SSE2", "AVX2", "AVX-512"};
    return names[std::size_t(set)];
}

#if defined(__x86_64__)

bool isSupported(InstructionSet set) {
    __builtin_cpu_init();
    switch (set) {
    case InstructionSet::Avx2:
        return __builtin_cpu_supports("avx2") != 0;
    case InstructionSet::Avx512: // and what its file is compiled with
        return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx2") != 0 &&
               __builtin_cpu_supports("fma") != 0;
    default:
        return true;
    }
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
    case InstructionSet::Avx512:
        return avx512Kernels();
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
    for (const InstructionSet set : {InstructionSet::Avx512, InstructionSet::Avx2, InstructionSet::Sse2})
        if (isSupported(set))
            return set;
    return InstructionSet::Scalar;
}

} // namespace clothlab
