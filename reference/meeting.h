#pragma once

#include <string>

#include "scenarios/scene/scene.h"

namespace plumb {

/// How a pair may be known not to meet while the scene lasts: "" where some pair might, or where there are too many to
/// look at each.
std::string why_none_meet(const Scene&);

}  // namespace plumb
