#pragma once

#include <zlib.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// What `packed` packed.
inline std::string unpacked(std::string_view text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string deflated;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(letters.find(letter));
    held += 6;
    if (held >= 8) deflated += static_cast<char>(bits >> (held -= 8) & 255);
  }
  std::string bytes(1 << 22, '\0');
  uLongf size = bytes.size();
  if (uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(deflated.data()),
                 deflated.size()) != Z_OK) {
    throw std::runtime_error("does not inflate");
  }
  bytes.resize(size);
  return bytes;
}

/// Reads what `Numbers` wrote, by the format's description.
class Reading {
 public:
  explicit Reading(std::string bytes) : bytes_(std::move(bytes)) {}

  bool ended() const { return place_ == bytes_.size(); }

  std::int64_t next() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_.at(place_++));
      value |= static_cast<std::uint64_t>(byte & 127) << shift;
      if (byte < 128) break;
    }
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }

  std::vector<double> smooth(std::size_t count, double step) { return column(count, step, 1); }
  std::vector<double> steady(std::size_t count, double step) { return column(count, step, 0); }

 private:
  std::vector<double> column(std::size_t count, double step, std::int64_t slope) {
    std::vector<double> values;
    std::int64_t last = 0;
    std::int64_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t now = next() + last + slope * (last - before);
      values.push_back(static_cast<double>(now) * step);
      before = last;
      last = now;
    }
    return values;
  }

  std::string bytes_;
  std::size_t place_ = 0;
};

}  // namespace plumb
