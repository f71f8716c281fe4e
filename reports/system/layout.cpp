#include "reports/system/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <sstream>
#include <utility>
#include <vector>

#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

// The bytes of the first `columns` letters.
std::size_t bytes_of(std::string_view text, std::size_t columns) {
  std::size_t at = 0;
  for (std::size_t letters = 0; at < text.size(); ++at) {
    const bool begins = (static_cast<unsigned char>(text[at]) & 0xc0) != 0x80;
    if (begins && letters++ == columns) break;
  }
  return at;
}

bool is_number(std::string_view word) {
  const std::size_t digit = word.find_first_not_of("+-(.");
  return digit != word.npos && word[digit] >= '0' && word[digit] <= '9';
}

// A unit, or "+-", whatever punctuation follows.
bool belongs_to_number(std::string_view word) {
  constexpr std::array<std::string_view, 26> units{"%",  "m",   "s",  "kg", "J",      "N",   "Hz",    "rad",   "deg",
                                                   "us", "ms",  "mm", "cm", "MiB",    "m/s", "rad/s", "m/s^2", "m^2",
                                                   "Nm", "N*m", "+-", "of", "kg*m/s", "N*s", "times", "min"};
  word = word.substr(0, word.find_last_not_of(".,;:)") + 1);
  return std::ranges::find(units, word) != units.end();
}

// Words, with what must stay on one line as one word.
std::vector<std::string> pieces_of(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::vector<std::string> pieces;
  bool number = false;  // whether the piece ends with a number, or with what a number must follow
  for (std::string word; words >> word;) {
    word = printable(word, word.npos);
    const bool glued = number && (belongs_to_number(word) || pieces.back().ends_with(" +-"));
    if (glued) {
      pieces.back() += " " + word;
    } else {
      pieces.push_back(word);
    }
    number = is_number(word) || (glued && word == "+-");
  }
  return pieces;
}

}  // namespace

std::size_t columns_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char letter) { return (static_cast<unsigned char>(letter) & 0xc0) != 0x80; }));
}

std::string cut(std::string_view text, std::size_t columns) {
  if (columns_of(text) <= columns) return std::string(text);
  return std::string(text.substr(0, bytes_of(text, columns - std::min<std::size_t>(columns, 3)))) + "...";
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
  const std::size_t room = width > indent + 20 ? width - indent : 20;
  std::string lines;
  std::string line;
  const auto flush = [&] {
    lines += std::string(indent, ' ') + line + '\n';
    line.clear();
  };
  for (std::string piece : pieces_of(text)) {
    if (!line.empty() && columns_of(line) + 1 + columns_of(piece) > room) flush();
    while (columns_of(piece) > room) {
      const std::size_t bytes = bytes_of(piece, room);
      line = piece.substr(0, bytes);
      piece.erase(0, bytes);
      flush();
    }
    line += (line.empty() ? "" : " ") + piece;
  }
  if (!line.empty()) flush();
  return lines;
}

std::string enumerated(std::span<const std::string> parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

std::string beside(std::string_view name, std::size_t columns, std::string_view text, std::size_t width) {
  const std::size_t taken = columns_of(name);
  std::string lines = wrapped(text, columns, width);
  if (lines.empty()) return std::string(name) + '\n';
  if (taken + 2 > columns) return std::string(name) + '\n' + lines;
  return std::string(name) + lines.substr(taken);
}

namespace {

constexpr std::size_t gap = 2;           // columns between two columns
constexpr std::size_t widest_name = 26;  // columns of the first column where there is no room for all
constexpr std::size_t least_name = 12;

}  // namespace

TextTable::TextTable(std::vector<Column> columns, std::size_t indent, std::size_t width)
    : columns_(std::move(columns)), indent_(indent), width_(width) {}

void TextTable::add(std::vector<Cell> row) {
  for (Cell& cell : row) cell.text = printable(cell.text, cell.text.npos);
  lines_.push_back({.cells = std::move(row)});
}

void TextTable::add_lines(std::string lines) { lines_.push_back({.whole = std::move(lines)}); }

TextTable::Layout TextTable::layout() const {
  Layout found;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::size_t widest = columns_of(columns_[i].head);
    for (const Line& line : lines_) {
      if (!line.cells.empty()) widest = std::max(widest, columns_of(line.cells[i].text));
    }
    found.widths.push_back(widest + (i == 0 ? 0 : gap));
  }
  const auto total = [&] { return std::reduce(found.widths.begin(), found.widths.end(), indent_); };
  if (total() > width_) found.widths[0] = std::min(found.widths[0], widest_name);
  while (total() > width_) {
    std::size_t least = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (found.widths[i] != 0 && columns_[i].rank > columns_[least].rank) least = i;
    }
    if (columns_[least].rank == 0) break;
    found.widths[least] = 0;
  }
  if (total() > width_) {
    const std::size_t over = total() - width_;
    found.widths[0] =
        std::max(std::min(found.widths[0], least_name), found.widths[0] - std::min(over, found.widths[0]));
  }
  return found;
}

std::string TextTable::line_of(const std::vector<Cell>& cells, const Layout& layout) const {
  std::string line(indent_, ' ');
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::size_t width = layout.widths[i];
    if (width == 0) continue;
    const std::string text = i == 0 ? cut(cells[i].text, width) : cells[i].text;
    const std::string padding(width - std::min(width, columns_of(text) + (i == 0 ? 0 : gap)), ' ');
    const std::string shown = *cells[i].colour == '\0' ? text : cells[i].colour + text + "\033[0m";
    line += (i == 0 ? "" : std::string(gap, ' ')) + (columns_[i].left ? shown + padding : padding + shown);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string TextTable::text() const {
  const Layout widths = layout();
  std::vector<Cell> heads;
  for (const Column& column : columns_) heads.push_back({column.head});
  std::string all = line_of(heads, widths);
  for (const Line& line : lines_) all += line.cells.empty() ? line.whole : line_of(line.cells, widths);
  return all;
}

}  // namespace plumb
