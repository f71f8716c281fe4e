#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// How the page is handed much in few bytes: whole numbers, mostly small ones, then deflated, then as text.
namespace plumb {

/// Whole numbers in turn, each in as many bytes as it needs: seven bits a byte, the lowest first, the eighth bit set
/// where more follow. The sign is the lowest bit: 0, -1, 1, -2 ... are written as 0, 1, 2, 3 ...
class Numbers {
 public:
  void put(std::int64_t value);

  /// A column that runs smoothly: each value in steps (rounded), less what the two before it lead to expect. Before the
  /// first lie two zeros. What is read back is within half a step, never adding up. Throws std::invalid_argument
  /// for a value that is not finite, or too large for its step.
  void put_smooth(std::span<const double> values, double step);

  /// A column that stands or jumps: less the value before it.
  void put_steady(std::span<const double> values, double step);

  std::string_view bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Deflated with zlib's header (RFC 1950), then base64 (RFC 4648): what DecompressionStream("deflate") reads.
std::string packed(std::string_view bytes);

}  // namespace plumb
