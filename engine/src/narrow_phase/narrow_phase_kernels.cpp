#include "narrow_phase/lanes/manifolds.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace scalar {
extern const NarrowPhaseKernels narrow_phase_table;
}
namespace baseline {
extern const NarrowPhaseKernels narrow_phase_table;
}
#ifdef IMPULSE_X86_LANES
namespace avx2 {
extern const NarrowPhaseKernels narrow_phase_table;
}
namespace avx512 {
extern const NarrowPhaseKernels narrow_phase_table;
}
#endif

const NarrowPhaseKernels& narrow_phase_kernels(InstructionSet set) {
#ifdef IMPULSE_X86_LANES
  static constexpr KernelVersions<NarrowPhaseKernels> versions{&scalar::narrow_phase_table,
                                                               &baseline::narrow_phase_table, &avx2::narrow_phase_table,
                                                               &avx512::narrow_phase_table};
#else
  static constexpr KernelVersions<NarrowPhaseKernels> versions{&scalar::narrow_phase_table,
                                                               &baseline::narrow_phase_table};
#endif
  return kernels_for(set, versions);
}

}  // namespace impulse::inline IMPULSE_PRECISION
