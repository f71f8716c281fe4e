#include "solver/lanes/kernels.h"

#include <array>

namespace impulse::inline IMPULSE_PRECISION {

namespace scalar {
extern const Kernels table;
extern const PileKernels pile_table;
}
namespace baseline {
extern const Kernels table;
extern const PileKernels pile_table;
}
namespace avx2 {
extern const Kernels table;
extern const PileKernels pile_table;
}
namespace avx512 {
extern const Kernels table;
extern const PileKernels pile_table;
}

namespace {

#ifdef IMPULSE_X86_LANES

constexpr std::array versions{&scalar::table, &baseline::table, &avx2::table, &avx512::table};
constexpr std::array pile_versions{&scalar::pile_table, &baseline::pile_table, &avx2::pile_table, &avx512::pile_table};

// What avx512 is compiled with: the first processors that had some of it had not all.
bool has_avx512() {
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
         __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0;
}

std::size_t runnable() {
  if (has_avx512()) return 4;
  return __builtin_cpu_supports("avx2") != 0 ? 3 : 2;
}

#else

constexpr std::array versions{&scalar::table, &baseline::table};
constexpr std::array pile_versions{&scalar::pile_table, &baseline::pile_table};

std::size_t runnable() { return 2; }
#endif

}  // namespace

std::span<const Kernels* const> runnable_kernels() {
  static const std::size_t count = runnable();
  return std::span(versions).first(count);
}

std::span<const PileKernels* const> runnable_pile_kernels() {
  static const std::size_t count = runnable();
  return std::span(pile_versions).first(count);
}

}  // namespace impulse::inline IMPULSE_PRECISION
