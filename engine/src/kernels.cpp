#include "kernels.h"

#include <array>

namespace impulse::inline IMPULSE_PRECISION {

namespace scalar {
extern const Kernels table;
}
namespace baseline {
extern const Kernels table;
}
namespace avx2 {
extern const Kernels table;
}
namespace avx512 {
extern const Kernels table;
}

namespace {

#ifdef IMPULSE_X86_LANES

constexpr std::array versions{&scalar::table, &baseline::table, &avx2::table, &avx512::table};

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

std::size_t runnable() { return 2; }

#endif

}  // namespace

std::span<const Kernels* const> runnable_kernels() {
  static const std::size_t count = runnable();
  return std::span(versions).first(count);
}

}  // namespace impulse::inline IMPULSE_PRECISION
