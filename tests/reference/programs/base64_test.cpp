#include "reference/programs/base64.h"

#include <gmock/gmock.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace plumb::base64_test {
namespace {

// RFC 4648, section 10.
TEST(Base64, WritesWhatTheStandardShows) {
  EXPECT_EQ(base64(std::string_view("")), "");
  EXPECT_EQ(base64(std::string_view("f")), "Zg==");
  EXPECT_EQ(base64(std::string_view("fo")), "Zm8=");
  EXPECT_EQ(base64(std::string_view("foo")), "Zm9v");
  EXPECT_EQ(base64(std::string_view("foobar")), "Zm9vYmFy");
}

TEST(Base64, KeepsEveryBitOfNumbers) {
  const std::vector<double> all{0, -0.0, 1.0 / 3, -1e308, std::numeric_limits<double>::denorm_min(), 0x1p-53, 42};
  for (std::size_t count = 0; count <= all.size(); ++count) {
    const std::vector<double> given(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    const auto read = numbers_of_base64(base64(given));
    ASSERT_TRUE(read && read->size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>((*read)[i]), std::bit_cast<std::uint64_t>(given[i]));
    }
  }
}

TEST(Base64, RefusesWhatIsNotNumbers) {
  const std::string one = base64(std::vector<double>{1});
  const std::vector<std::string> all{one.substr(1), one + "A",           one + one,           "Zg==" + one.substr(4),
                                     "Zm9v",        '-' + one.substr(1), '=' + one.substr(1), one + "\n"};
  for (const std::string& wrong : all) {
    EXPECT_EQ(numbers_of_base64(wrong), std::nullopt) << wrong;
  }
}

}  // namespace
}  // namespace plumb::base64_test
