#include "reference/programs/base64.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace plumb {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t no_letter = 64;

constexpr std::array<std::uint8_t, 256> values = [] {
  std::array<std::uint8_t, 256> all{};
  all.fill(no_letter);
  for (std::size_t i = 0; i < letters.size(); ++i) {
    all[static_cast<unsigned char>(letters[i])] = static_cast<std::uint8_t>(i);
  }
  return all;
}();

}  // namespace

std::string base64(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  char* out = text.data();
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t known = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < known ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k <= known; ++k) out[k] = letters[bits >> (18 - 6 * k) & 63];
    out += 4;
  }
  return text;
}

std::string base64(std::span<const double> numbers) {
  return base64(std::string_view(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()));
}

std::optional<std::vector<double>> numbers_of_base64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  const std::size_t size = text.size() / 4 * 3 - padding;  // bytes
  if (size % sizeof(double) != 0) return std::nullopt;
  std::vector<double> numbers(size / sizeof(double));
  auto* bytes = reinterpret_cast<unsigned char*>(numbers.data());
  for (std::size_t i = 0, at = 0; i < text.size(); i += 4) {
    std::uint32_t bits = 0;
    std::uint8_t all = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const bool padded = i + k >= text.size() - padding;
      const std::uint8_t value = padded ? 0 : values[static_cast<unsigned char>(text[i + k])];
      all |= value;
      bits = bits << 6 | value;
    }
    if ((all & no_letter) != 0) return std::nullopt;
    for (std::size_t k = 0; k < 3 && at < size; ++k) bytes[at++] = static_cast<unsigned char>(bits >> (16 - 8 * k));
  }
  return numbers;
}

}  // namespace plumb
