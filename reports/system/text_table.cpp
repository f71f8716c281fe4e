#include "reports/system/text_table.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "reports/system/layout.h"
#include "scenarios/scene/json_reader.h"

namespace plumb {
namespace {

constexpr std::size_t gap = 2;           // columns between two columns
constexpr std::size_t widest_name = 26;  // columns of the first column where there is room
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
  found.widths[0] = std::min(found.widths[0], widest_name);
  const auto total = [&] { return std::reduce(found.widths.begin(), found.widths.end(), indent_); };
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
