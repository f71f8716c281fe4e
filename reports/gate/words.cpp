#include "reports/gate/words.h"

#include <array>
#include <limits>

namespace plumb {
namespace {

template <class T, std::size_t n>
std::array<Word<T>, n> words_of(const std::array<T, n>& values) {
  std::array<Word<T>, n> words{};
  for (std::size_t i = 0; i < n; ++i) words[i] = {name_of(values[i]), values[i]};
  return words;
}

}  // namespace

double number_or_null(const JsonReader& from) {
  constexpr double most = std::numeric_limits<double>::max();
  return from.value().is_null() ? std::numeric_limits<double>::quiet_NaN() : from.number({-most, most});
}

std::string any_text(const JsonReader& from) {
  constexpr std::size_t longest = 4096;
  return from.text(0, longest);
}

std::map<std::string, std::string> texts_from(const JsonReader& from) {
  std::map<std::string, std::string> all;
  for_each_member(from, [&](const std::string& name, const JsonReader& text) { all[name] = any_text(text); });
  return all;
}

Verdict verdict_from(const JsonReader& from) {
  constexpr std::array all{Verdict::right,          Verdict::plausible,     Verdict::wrong,
                           Verdict::beyond_horizon, Verdict::not_supported, Verdict::failed};
  static const auto words = words_of(all);
  return from.one_of<Verdict>(words);
}

CheckStatus check_status_from(const JsonReader& from) {
  constexpr std::array all{CheckStatus::held, CheckStatus::broken, CheckStatus::not_reported};
  static const auto words = words_of(all);
  return from.one_of<CheckStatus>(words);
}

}  // namespace plumb
