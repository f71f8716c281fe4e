#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Bytes, and numbers to the bit, as text: base64 with padding (RFC 4648, section 4). A double is eight bytes, the
/// least significant first.
namespace plumb {

std::string base64(std::string_view bytes);
std::string base64(std::span<const double> numbers);

/// nullopt if the text is not base64, or not of whole numbers.
std::optional<std::vector<double>> numbers_of_base64(std::string_view text);

}  // namespace plumb
