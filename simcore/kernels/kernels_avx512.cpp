#include "simcore/kernels/kernel_templates.h"

namespace clothlab {

// NOLINTNEXTLINE(misc-use-internal-linkage): kernels.cpp refers to it
const Kernels& avx512Kernels() {
    static constexpr Kernels kernels = makeKernels<Avx512Lanes>();
    return kernels;
}

} // namespace clothlab
