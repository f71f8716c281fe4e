#include "reference/programs/base64.h"

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
  const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(bytes[i])}; };
  std::size_t i = 0;
  for (; i + 3 <= bytes.size(); i += 3, out += 4) {
    const std::uint32_t bits = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (std::size_t k = 0; k < 4; ++k) out[k] = letters[bits >> (18 - 6 * k) & 63];
  }
  const std::size_t left = bytes.size() - i;
  if (left == 0) return text;
  const std::uint32_t bits = byte(i) << 16 | (left == 2 ? byte(i + 1) << 8 : 0);
  for (std::size_t k = 0; k <= left; ++k) out[k] = letters[bits >> (18 - 6 * k) & 63];
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
  std::uint8_t all = 0;
  const auto value = [&](std::size_t i) {
    const std::uint8_t of_letter = values[static_cast<unsigned char>(text[i])];
    all |= of_letter;
    return std::uint32_t{of_letter};
  };
  // Four letters are three bytes; the last four may be padded.
  const std::size_t whole = text.size() - (padding > 0 ? 4 : 0);
  std::size_t i = 0;
  for (; i < whole; i += 4, bytes += 3) {
    const std::uint32_t bits = value(i) << 18 | value(i + 1) << 12 | value(i + 2) << 6 | value(i + 3);
    bytes[0] = static_cast<unsigned char>(bits >> 16);
    bytes[1] = static_cast<unsigned char>(bits >> 8);
    bytes[2] = static_cast<unsigned char>(bits);
  }
  if (padding > 0) {
    const std::uint32_t bits = value(i) << 18 | value(i + 1) << 12 | (padding == 1 ? value(i + 2) << 6 : 0);
    bytes[0] = static_cast<unsigned char>(bits >> 16);
    if (padding == 1) bytes[1] = static_cast<unsigned char>(bits >> 8);
  }
  if ((all & no_letter) != 0) return std::nullopt;
  return numbers;
}

}  // namespace plumb
