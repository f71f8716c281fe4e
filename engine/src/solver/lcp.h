#pragma once

#include <optional>
#include <span>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The error that elimination leaves in a zero, relative to the numbers it was computed from.
constexpr double lcp_round_off = 1e-11;

/// Solves the linear complementarity problem: finds z with
///
///   w = M z + q,   w >= 0,   z >= 0,   w . z = 0,
///
/// M dense, n x n, row by row. Uses Lemke's complementary pivoting (Cottle, Pang, Stone, The Linear Complementarity
/// Problem, 1992, algorithm 4.4.5) with the lexicographic rule, which prevents cycling. For a copositive-plus M it
/// finds a solution if one exists. Computes in double whatever the engine's precision. w >= 0 holds up to the fraction
/// `noise` of the largest q, which counts as zero: the rounding error of M and q, if larger than that of elimination.
/// Pivots no larger than the noise of their inputs would be meaningless.
///
/// Returns nullopt if the pivoting ends on a ray; for such an M there is no solution. Throws std::invalid_argument for
/// sizes that do not match.
std::optional<std::vector<double>> solve_lcp(std::span<const double> m, std::span<const double> q,
                                             double noise = lcp_round_off);

}  // namespace impulse::inline IMPULSE_PRECISION
