#include "broad_phase/lanes/overlaps.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace scalar {
extern const BroadPhaseKernels broad_phase_table;
}
namespace baseline {
extern const BroadPhaseKernels broad_phase_table;
}
#ifdef IMPULSE_X86_LANES
namespace avx2 {
extern const BroadPhaseKernels broad_phase_table;
}
namespace avx512 {
extern const BroadPhaseKernels broad_phase_table;
}
#endif

const BroadPhaseKernels& broad_phase_kernels(InstructionSet set) {
#ifdef IMPULSE_X86_LANES
  // Most ranges hold a few proxies: eight at a time suit them better than sixteen.
  static const BroadPhaseKernels for_avx512{avx2::broad_phase_table.find_overlaps, avx2::broad_phase_table.answer_batch,
                                            avx512::broad_phase_table.filter_pairs};
  static constexpr KernelVersions<BroadPhaseKernels> versions{&scalar::broad_phase_table, &baseline::broad_phase_table,
                                                              &avx2::broad_phase_table, &for_avx512};
#else
  static constexpr KernelVersions<BroadPhaseKernels> versions{&scalar::broad_phase_table, &baseline::broad_phase_table};
#endif
  return kernels_for(set, versions);
}

}  // namespace impulse::inline IMPULSE_PRECISION
