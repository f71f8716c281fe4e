#pragma once

#include <span>
#include <string>
#include <vector>

namespace plumb {

/// A table for the console; the first row is its head: columns as wide as they need be, numbers not aligned.
std::string plain_table(std::span<const std::vector<std::string>> rows);

}  // namespace plumb
