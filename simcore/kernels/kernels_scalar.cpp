#include "simcore/kernels/kernel_templates.h"

namespace clothlab {

// NOLINTNEXTLINE(misc-use-internal-linkage): kernels.cpp refers to it
const Kernels& scalarKernels() {
    static constexpr Kernels kernels = makeKernels<ScalarLanes>();
    return kernels;
}

} // namespace clothlab
