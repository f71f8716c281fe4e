#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Lines of text that fit a width, in columns.
namespace plumb {

/// Columns that UTF-8 text takes, if every letter takes one.
std::size_t columns_of(std::string_view text);

/// The text, or its beginning and "..." if it takes more columns. No limit: npos.
std::string cut(std::string_view text, std::size_t columns);

/// Breaks text into indented lines that end at `width`; a word too long for a line is broken. A number stays with its
/// unit and with what it is off by: "0.5 +- 0.1 m/s" is never broken. Control characters are replaced.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width);

/// A name of at least `columns` columns, then text that is wrapped beside it.
std::string beside(std::string_view name, std::size_t columns, std::string_view text, std::size_t width);

}  // namespace plumb
