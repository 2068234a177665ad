#include "simcore/kernels/kernel_templates.h"

namespace clothlab {

// NOLINTNEXTLINE(misc-use-internal-linkage): kernels.cpp refers to it
const Kernels& sse2Kernels() {
    static constexpr Kernels kernels = makeKernels<Sse2Lanes>();
    return kernels;
}

} // namespace clothlab
