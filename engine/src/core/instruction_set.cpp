#include "core/instruction_set.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::array instruction_sets{InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2,
                                      InstructionSet::avx512};

#ifdef IMPULSE_X86_LANES

// Every extension that avx512 is compiled with: the first processors with AVX-512 lacked some.
bool has_avx512() {
  return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
         __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0;
}

std::size_t count_runnable() {
  if (has_avx512()) return 4;
  return __builtin_cpu_supports("avx2") != 0 ? 3 : 2;
}

#else

std::size_t count_runnable() { return 2; }

#endif

}  // namespace

std::span<const InstructionSet> runnable_instruction_sets() {
  static const std::size_t count = count_runnable();
  return std::span(instruction_sets).first(count);
}

}  // namespace impulse::inline IMPULSE_PRECISION
