#include "reports/cli/glossary.h"

#include <algorithm>
#include <optional>

namespace plumb {
namespace {

// Text without Markdown's marks: links are their words, and "\|" is "|".
std::string plain(std::string_view markdown) {
  std::string text;
  for (std::size_t i = 0; i < markdown.size(); ++i) {
    const char letter = markdown[i];
    if (letter == '*' || letter == '`' || letter == '\\' || letter == '[') continue;
    if (letter == ']' && i + 1 < markdown.size() && markdown[i + 1] == '(') {
      i = std::min(markdown.find(')', i), markdown.size());
      continue;
    }
    text += letter;
  }
  const std::size_t first = text.find_first_not_of(' ');
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

struct Row {
  std::string first, second;
};

// "| a | b |"; nullopt for another line. "\|" does not end a cell.
std::optional<Row> row_of(std::string_view line) {
  if (!line.starts_with("| ") || !line.ends_with(" |")) return std::nullopt;
  const std::size_t bar = line.find(" | ", 1);
  if (bar == line.npos) return std::nullopt;
  return Row{plain(line.substr(2, bar - 2)), plain(line.substr(bar + 3, line.size() - bar - 5))};
}

}  // namespace

std::vector<GlossaryWord> glossary_of(std::string_view markdown) {
  std::vector<GlossaryWord> words;
  bool inside = false;
  while (!markdown.empty()) {
    const std::string_view line = markdown.substr(0, markdown.find('\n'));
    markdown.remove_prefix(std::min(markdown.size(), line.size() + 1));
    const auto row = row_of(line);
    if (!row) {
      inside = inside && line.starts_with("|---");
    } else if (row->first == "word") {
      inside = true;
    } else if (inside && !row->second.starts_with("see ")) {
      std::string_view names = row->first;
      while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find(", "));
        const auto same = [&](const GlossaryWord& word) { return word.name == name; };
        if (std::ranges::none_of(words, same)) words.push_back({std::string(name), row->second});
        names.remove_prefix(std::min(names.size(), name.size() + 2));
      }
    }
  }
  return words;
}

std::vector<GlossaryWord> glossary() { return glossary_of(glossary_text()); }

}  // namespace plumb
