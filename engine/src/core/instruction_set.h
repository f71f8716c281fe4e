#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The instruction sets that kernels (src/*/lanes/*.cpp) are compiled for, slowest first; see simd.h. All give the same
/// bits: `scalar` computes one number at a time and is the oracle of the others, `baseline` uses what every processor
/// of the target has.
enum class InstructionSet : std::uint8_t { scalar, baseline, avx2, avx512 };

/// Those that this processor runs, slowest first.
std::span<const InstructionSet> runnable_instruction_sets();
inline InstructionSet fastest_instruction_set() { return runnable_instruction_sets().back(); }

/// The kernels of one room as compiled for each instruction set; null for a set that the target does not have.
template <class Kernels>
using KernelVersions = std::array<const Kernels*, 4>;

template <class Kernels>
const Kernels& kernels_for(InstructionSet set, const KernelVersions<Kernels>& versions) {
  return *versions[static_cast<std::size_t>(set)];
}

}  // namespace impulse::inline IMPULSE_PRECISION
