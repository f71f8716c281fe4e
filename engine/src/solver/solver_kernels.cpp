#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace scalar {
extern const SolverKernels solver_table;
}
namespace baseline {
extern const SolverKernels solver_table;
}
#ifdef IMPULSE_X86_LANES
namespace avx2 {
extern const SolverKernels solver_table;
}
namespace avx512 {
extern const SolverKernels solver_table;
}
#endif

const SolverKernels& solver_kernels(InstructionSet set) {
#ifdef IMPULSE_X86_LANES
  static constexpr KernelVersions<SolverKernels> versions{&scalar::solver_table, &baseline::solver_table,
                                                          &avx2::solver_table, &avx512::solver_table};
#else
  static constexpr KernelVersions<SolverKernels> versions{&scalar::solver_table, &baseline::solver_table};
#endif
  return kernels_for(set, versions);
}

}  // namespace impulse::inline IMPULSE_PRECISION
