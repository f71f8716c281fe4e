#include "reports/system/csv.h"

#include <fmt/format.h>

#include <cmath>

namespace plumb {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
    quoted += letter;
    if (letter == '"') quoted += '"';
  }
  return quoted + '"';
}

std::string csv_field(double number) { return std::isfinite(number) ? fmt::format("{}", number) : ""; }

}  // namespace plumb
