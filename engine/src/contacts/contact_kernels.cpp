#include "contacts/lanes/persistence.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace scalar {
extern const ContactKernels contact_table;
}
namespace baseline {
extern const ContactKernels contact_table;
}
#ifdef IMPULSE_X86_LANES
namespace avx2 {
extern const ContactKernels contact_table;
}
#endif

const ContactKernels& contact_kernels(InstructionSet set) {
#ifdef IMPULSE_X86_LANES
  // persist_points gathers more than it computes: AVX2 is faster than AVX-512.
  static constexpr KernelVersions<ContactKernels> versions{&scalar::contact_table, &baseline::contact_table,
                                                           &avx2::contact_table, &avx2::contact_table};
#else
  static constexpr KernelVersions<ContactKernels> versions{&scalar::contact_table, &baseline::contact_table};
#endif
  return kernels_for(set, versions);
}

}  // namespace impulse::inline IMPULSE_PRECISION
