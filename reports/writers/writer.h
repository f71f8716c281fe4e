#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "reports/report.h"

namespace plumb {

/// One format of a report. Returns the text of the file; `write_all` puts it in place whole or not at all.
struct Writer {
  std::string name;  // "json"
  std::string file;  // "report.json"
  std::function<std::optional<std::string>(const Report&, std::string& why_not)> text;
};

}  // namespace plumb
