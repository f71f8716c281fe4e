#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <utility>

#include "reference/simulation.h"

namespace plumb {

/// N s, the normal impulses of all contacts of a pair.
using Pushed = std::map<std::pair<std::size_t, std::size_t>, double>;
Pushed pushed_in(std::span<const ContactState>);

/// How much more or less a contact's pair carries than a step before.
double changed(const Pushed& before, const Pushed& now, const ContactState&);

}  // namespace plumb
