#pragma once

#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace plumb {

/// Boxes of 1 m, `base` of them in the lowest row and one less in each row above, a quarter of a box apart, on the
/// ground about `x`. They are called "<prefix>row.place", both counted from 1.
std::vector<Body> pyramid_of(const std::string& prefix, int base, double x, Surface);

/// That every box of such a pyramid stays at its height for so long, s, and the apex on its vertical.
std::vector<Expectation> pyramid_stands(const std::vector<Body>& pyramid, double duration);

}  // namespace plumb
