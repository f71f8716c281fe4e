#include "scenarios/scene/nearest.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace plumb {
namespace {

char lower(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter; }

// Levenshtein distance, by rows of the Wagner-Fischer table.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

// The name to suggest: the nearest if no more than every third letter differs, or else one that begins with the word;
// "" if there is none.
std::string suggestion(std::string_view word, std::span<const std::string> names) {
  constexpr std::size_t least_beginning = 3;
  const std::string near = nearest(word, names);
  if (edit_distance(word, near) <= (std::max(word.size(), near.size()) + 2) / 3) return near;
  const auto longer = std::ranges::find_if(names, [&](const std::string& name) { return name.starts_with(word); });
  return word.size() >= least_beginning && longer != names.end() ? *longer : "";
}

}  // namespace

std::string nearest(std::string_view word, std::span<const std::string> names) {
  std::string best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string& name : names) {
    const std::size_t d = edit_distance(word, name);
    if (d < least) {
      least = d;
      best = name;
    }
  }
  return best;
}

std::string unknown(std::string_view kind, std::string_view word, std::span<const std::string> names) {
  constexpr std::size_t most_listed = 12;
  std::string sentence = "unknown ";
  sentence.append(kind).append(" \"").append(word).append("\"");
  if (names.empty()) return sentence;
  const std::string suggested = suggestion(word, names);
  if (!suggested.empty()) return sentence.append(", did you mean \"").append(suggested).append("\"?");
  if (names.size() > most_listed) return sentence;
  sentence.append(", expected ").append(names.size() == 1 ? "" : "one of: ");
  for (const std::string& name : names) sentence.append(&name == names.data() ? "" : ", ").append(name);
  return sentence;
}

}  // namespace plumb
