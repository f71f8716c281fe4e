#pragma once

#include <optional>
#include <span>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What elimination leaves of a zero, relative to the numbers that it came from.
constexpr double lcp_round_off = 1e-11;

/// The linear complementarity problem: z with
///
///   w = M z + q,   w >= 0,   z >= 0,   w . z = 0,
///
/// M dense, n x n, row by row. By Lemke's complementary pivoting (Cottle, Pang, Stone, The Linear Complementarity
/// Problem, 1992, algorithm 4.4.5) with the lexicographic rule, which no degenerate problem can make circle. For a
/// copositive-plus M it finds a solution wherever one exists. In double whatever the engine's precision. w is >= 0 but
/// for what counts as zero, the share `noise` of the largest q: what M and q were rounded to before, if that is more
/// than elimination leaves. Pivots no larger than the noise that they were made from would lead astray.
///
/// Returns nothing where the pivoting ends on a ray: for such an M there is no solution. Throws std::invalid_argument
/// for sizes that do not fit.
std::optional<std::vector<double>> solve_lcp(std::span<const double> m, std::span<const double> q,
                                             double noise = lcp_round_off);

}  // namespace impulse::inline IMPULSE_PRECISION
