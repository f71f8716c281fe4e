#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Lines of text that fit a width, in columns.
namespace plumb {

/// Columns that UTF-8 text takes, if every letter takes one.
std::size_t columns_of(std::string_view text);

/// The text, or its beginning and "..." if it takes more columns. No limit: npos.
std::string cut(std::string_view text, std::size_t columns);

/// Breaks text into indented lines that end at `width`; a word too long for a line is broken. A number stays with its
/// unit and with what it is off by: "0.5 +- 0.1 m/s" is never broken. Control characters are replaced.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width);

/// "a, b and c".
std::string enumerated(std::span<const std::string> parts);

/// A name of at least `columns` columns, then text that is wrapped beside it.
std::string beside(std::string_view name, std::size_t columns, std::string_view text, std::size_t width);

/// A table of plain text: columns are as wide as their contents, and the least important are left out where they don't
/// fit.
class TextTable {
 public:
  struct Column {
    std::string head;
    int rank = 0;       // which go first if there is no room: the highest; 0: never
    bool left = false;  // aligned; others are numbers
  };
  struct Cell {
    std::string text;
    const char* colour = "";  // an escape sequence; "": none
  };

  /// The first column is indented, and cut if nothing else helps.
  TextTable(std::vector<Column> columns, std::size_t indent, std::size_t width);

  /// Control characters are replaced.
  void add(std::vector<Cell> row);
  /// Whole lines between the rows.
  void add_lines(std::string lines);

  /// With the heads as the first line.
  std::string text() const;

 private:
  struct Line {
    std::vector<Cell> cells;
    std::string whole;  // instead of cells
  };
  struct Layout {
    std::vector<std::size_t> widths;  // of each column; 0: left out
  };

  Layout layout() const;
  std::string line_of(const std::vector<Cell>& cells, const Layout& layout) const;

  std::vector<Column> columns_;
  std::size_t indent_, width_;
  std::vector<Line> lines_;
};

}  // namespace plumb
