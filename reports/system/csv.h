#pragma once

#include <string>

/// Fields of a table of comma-separated values.
namespace plumb {

/// RFC 4180: what holds a comma, a quote or a line break is quoted, quotes doubled.
std::string csv_field(const std::string& text);

/// The shortest that reads back to the same bits; empty where there is no number.
std::string csv_field(double number);

}  // namespace plumb
