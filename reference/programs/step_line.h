#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace plumb::protocol {

/// What the answer to a step says, before it is compared with what was asked.
struct StepLine {
  std::uint64_t step = 0;
  double nanoseconds = 0;
  std::vector<double> states, contacts;  // rows of 6 and of 9 numbers in turn, all finite
};

/// Reads an answer to a step in a tenth of the time that a JSON document takes. False if it is anything else than such
/// an answer, or says anything wrong: the parser of whole answers then finds out what.
bool scan_step_line(std::string_view line, StepLine&);

}  // namespace plumb::protocol
