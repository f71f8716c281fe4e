#pragma once

#include <string>
#include <string_view>

namespace plumb {

/// FIPS 180-4, as 64 hexadecimal digits: names a content so that no two meet.
std::string sha256(std::string_view);

}  // namespace plumb
