#include "reports/writers/packed.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/programs/base64.h"

namespace plumb {
namespace {

// Beyond 2^50 steps a double cannot represent half steps, and second differences would soon overflow.
constexpr double most_steps = 1125899906842624.0;

std::int64_t in_steps(double value, double step) {
  if (!Numbers::holds(value, step)) throw std::invalid_argument("a packed value must be finite and within 2^50 steps");
  return std::llround(value / step);
}

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const auto* from = reinterpret_cast<const Bytef*>(bytes.data());
  auto* to = reinterpret_cast<Bytef*>(out.data());
  if (compress2(to, &size, from, static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib could not compress");
  }
  out.resize(size);
  return out;
}

}  // namespace

bool Numbers::holds(double value, double step) { return std::abs(value / step) < most_steps; }

void Numbers::put(std::int64_t value) {
  auto rest = static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
  for (; rest >= 128; rest >>= 7) bytes_ += static_cast<char>((rest & 127) | 128);
  bytes_ += static_cast<char>(rest);
}

void Numbers::put_smooth(std::span<const double> values, double step) {
  std::int64_t before = 0;
  std::int64_t last = 0;
  for (const double value : values) {
    const std::int64_t now = in_steps(value, step);
    put(now - 2 * last + before);
    before = last;
    last = now;
  }
}

void Numbers::put_steady(std::span<const double> values, double step) {
  std::int64_t last = 0;
  for (const double value : values) {
    const std::int64_t now = in_steps(value, step);
    put(now - last);
    last = now;
  }
}

std::string packed(std::string_view bytes) { return base64(deflated(bytes)); }

}  // namespace plumb
