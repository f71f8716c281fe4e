#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace plumb {

/// FIPS 180-4, as 64 hexadecimal digits. Different contents get different names.
std::string sha256(std::string_view);

/// FNV-1a, 64 bits, over the bytes of words, lowest byte first on any machine. Fast, for comparing the bits of results.
class BitHash {
 public:
  void add(std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) value_ = (value_ ^ (word >> shift & 0xff)) * 1099511628211U;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037U;
};

}  // namespace plumb
