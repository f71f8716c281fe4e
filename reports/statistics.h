#pragma once

#include <vector>

namespace plumb {

struct Quartiles {
  double low = 0, median = 0, high = 0;
};

/// Quartiles with linear interpolation between order statistics (Hyndman and Fan's type 7). Of nothing: zeros.
Quartiles quartiles(std::vector<double> values);

}  // namespace plumb
