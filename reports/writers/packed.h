#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// Compact encoding of numbers for the page: small whole numbers in few bytes, deflated, in base64.
namespace plumb {

/// A sequence of whole numbers, each in as many bytes as it needs: seven bits a byte, lowest first; the eighth bit is
/// set if more bytes follow. The lowest bit is the sign (zigzag): 0, -1, 1, -2 ... become 0, 1, 2, 3 ...
class Numbers {
 public:
  void put(std::int64_t value);

  /// For columns that change smoothly: each value, rounded to whole steps, minus its linear extrapolation from the two
  /// values before it (zero before the first). The reader is off by at most half a step, without accumulation. Throws
  /// std::invalid_argument for a value that it does not hold.
  void put_smooth(std::span<const double> values, double step);

  /// For columns that are constant or jump: each value minus the one before it.
  void put_steady(std::span<const double> values, double step);

  /// Whether a column may have such a value: it is finite and within 2^50 steps.
  static bool holds(double value, double step);

  std::string_view bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Deflated with zlib's header (RFC 1950), then base64 (RFC 4648), as DecompressionStream("deflate") reads it.
std::string packed(std::string_view bytes);

}  // namespace plumb
