#pragma once

#include <string>

#include "reports/report.h"

namespace plumb {

/// "y of box at 1 s: 4.9, expected 5 +- .01 m".
std::string in_words(const TruthCheck&);

/// Of a broken one: "breaks energy at 0.4 s: 2.4, tolerance .01 J (240 times)".
std::string in_words(const InvariantCheck&);

}  // namespace plumb
