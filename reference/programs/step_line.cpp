#include "reference/programs/protocol.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

#include "reference/programs/base64.h"

namespace plumb::protocol {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Goes through a line, as far as it is what it is asked for.
class Scanner {
 public:
  explicit Scanner(std::string_view line) : at_(line.data()), end_(line.data() + line.size()) {}

  // Whether that is what comes next, after white space.
  bool skip(char wanted) {
    skip_space();
    if (at_ == end_ || *at_ != wanted) return false;
    ++at_;
    return true;
  }

  bool at_end() {
    skip_space();
    return at_ == end_;
  }

  // A string without escapes.
  bool text(std::string_view& into) {
    if (!skip('"')) return false;
    const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    const std::size_t length = rest.find('"');
    if (length == std::string_view::npos) return false;
    into = rest.substr(0, length);
    at_ += length;
    return into.find('\\') == std::string_view::npos && skip('"');
  }

  // JSON has less than from_chars: no "inf" and "nan", no leading zeros, and digits on both sides of a point.
  bool number(double& into) {
    skip_space();
    const char* digits = at_ + (at_ != end_ && *at_ == '-' ? 1 : 0);
    if (digits == end_ || !is_digit(*digits)) return false;
    if (*digits == '0' && digits + 1 != end_ && is_digit(digits[1])) return false;
    const auto [rest, error] = std::from_chars(at_, end_, into);
    const char* const point = std::find(digits, rest, '.');
    if (error != std::errc{} || (point != rest && (point + 1 == rest || !is_digit(point[1])))) return false;
    at_ = rest;
    return true;
  }

 private:
  void skip_space() {
    while (at_ != end_ && (*at_ == ' ' || *at_ == '\t' || *at_ == '\r')) ++at_;
  }

  const char *at_, *end_;
};

// A list of rows, or base64 of their numbers in turn.
bool rows(Scanner& in, std::size_t width, std::vector<double>& numbers) {
  std::string_view packed;
  if (in.text(packed)) {
    auto unpacked = numbers_of_base64(packed);
    if (!unpacked || unpacked->size() % width != 0) return false;
    numbers = std::move(*unpacked);
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
  }
  numbers.clear();
  if (!in.skip('[')) return false;
  if (in.skip(']')) return true;
  do {
    if (!in.skip('[')) return false;
    for (std::size_t k = 0; k < width; ++k) {
      double number = 0;
      if ((k > 0 && !in.skip(',')) || !in.number(number)) return false;
      numbers.push_back(number);
    }
    if (!in.skip(']')) return false;
  } while (in.skip(','));
  return in.skip(']');
}

bool whole(Scanner& in, std::uint64_t& into) {
  double number = 0;
  if (!in.number(number) || number < 0 || number > 0x1p53 || number != std::floor(number)) return false;
  into = static_cast<std::uint64_t>(number);
  return true;
}

}  // namespace

bool scan_step_line(std::string_view line, StepLine& read) {
  constexpr std::array<std::string_view, 4> keys{"step", "states", "ns", "contacts"};
  constexpr unsigned needed = 0b0111;
  Scanner in(line);
  unsigned seen = 0;
  if (!in.skip('{')) return false;
  do {
    std::string_view key;
    if (!in.text(key) || !in.skip(':')) return false;
    const auto which = static_cast<std::size_t>(std::ranges::find(keys, key) - keys.begin());
    if (which == keys.size() || (seen >> which & 1U) != 0) return false;
    seen |= 1U << which;
    const bool is_right = which == 0   ? whole(in, read.step)
                          : which == 1 ? rows(in, 6, read.states)
                          : which == 2 ? in.number(read.nanoseconds) && read.nanoseconds >= 0
                                       : rows(in, 9, read.contacts);
    if (!is_right) return false;
  } while (in.skip(','));
  if ((seen & needed) != needed) return false;
  return in.skip('}') && in.at_end();
}

}  // namespace plumb::protocol
