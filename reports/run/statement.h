#pragma once

#include <string>

namespace plumb {

struct Stepping;

/// What an engine states about how it steps, in words, as far as it concerns what one sees: how far contacts rest from
/// touching, which impacts do not bounce, how often it iterates. "first order; overlaps of up to 5 mm are left alone".
std::string statement(const Stepping&);

}  // namespace plumb
