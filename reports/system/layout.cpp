#include "reports/system/layout.h"

#include <algorithm>
#include <array>
#include <sstream>
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

std::string beside(std::string_view name, std::size_t columns, std::string_view text, std::size_t width) {
  const std::size_t taken = columns_of(name);
  std::string lines = wrapped(text, columns, width);
  if (lines.empty()) return std::string(name) + '\n';
  if (taken + 2 > columns) return std::string(name) + '\n' + lines;
  return std::string(name) + lines.substr(taken);
}

}  // namespace plumb
