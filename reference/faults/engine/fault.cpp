#include "reference/faults/engine/fault.h"

#include <algorithm>
#include <utility>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

std::vector<Fault>& all_noted() {
  static std::vector<Fault> list;
  return list;
}

}  // namespace

void note(Fault fault) { all_noted().push_back(std::move(fault)); }

std::vector<Fault> faults() {
  std::vector<Fault> sorted = all_noted();
  std::sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) { return a.name < b.name; });
  return sorted;
}

}  // namespace impulse::inline IMPULSE_PRECISION
