#pragma once

#include <vector>

#include "reference/converged/converged.h"

/// A truth for scenes without a closed form: the converged answer of our engine, as far as another engine that shares
/// no solver with it converges to the same.
namespace plumb {

/// A second engine is heard while it knows every pose within this share of the smallest body.
inline constexpr double second_share = 0.05;

/// The answer of our engine up to the first of these, which its reason states: it does not converge (a horizon, or an
/// order of impacts that the step decides), its budget ends, no other engine is converged any longer, or one that is
/// contradicts it. A second engine that has not converged has nothing to say; one that has and disagrees ends the
/// truth, and what they differ by beyond its own error counts as an error of the first. Each engine has the budget of
/// the first.
ConvergedTruth confirmed_truth(const Scene&, std::vector<double> times, const Refinement& first);

}  // namespace plumb
