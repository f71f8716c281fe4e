#include "reports/writers/packed.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "unpacking.h"

namespace plumb::packed_test {
namespace {

TEST(Numbers, AreShortWhereTheyAreSmall) {
  Numbers numbers;
  for (const std::int64_t value : {0, -1, 1, 63, -64, 64}) numbers.put(value);
  EXPECT_EQ(numbers.bytes(), std::string_view("\x00\x01\x02\x7e\x7f\x80\x01", 7));
}

TEST(Numbers, ComeBackHoweverLarge) {
  Numbers numbers;
  const std::vector<std::int64_t> values{
      0, -1, 1 << 20, -(1LL << 50), std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()};
  for (const std::int64_t value : values) numbers.put(value);
  Reading reading{std::string(numbers.bytes())};
  for (const std::int64_t value : values) EXPECT_EQ(reading.next(), value);
  EXPECT_TRUE(reading.ended());
}

TEST(Numbers, OfColumnsAreWithinHalfAStepFromFirstToLast) {
  constexpr double step = 1.0 / 512;
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) values.push_back(20 - 5e-4 * i * i + 3 * std::sin(i / 3.0));
  Numbers numbers;
  numbers.put_smooth(values, step);
  numbers.put_steady(values, step);
  Reading reading{std::string(numbers.bytes())};
  for (const auto& read : {reading.smooth(values.size(), step), reading.steady(values.size(), step)}) {
    for (std::size_t i = 0; i < values.size(); ++i) ASSERT_LE(std::abs(read[i] - values[i]), step / 2) << i;
  }
  EXPECT_TRUE(reading.ended());
}

TEST(Numbers, OfAFallAreTheSameByteOverAndOver) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(-7.0 * i * i);
  Numbers numbers;
  numbers.put_smooth(values, 1);
  EXPECT_THAT(numbers.bytes().substr(2), ::testing::Each(numbers.bytes()[2]));
}

TEST(Numbers, RefuseWhatNoStepCanHold) {
  Numbers numbers;
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity(), 1e16}) {
    EXPECT_THROW(numbers.put_smooth(std::span(&value, 1), 1), std::invalid_argument);
    EXPECT_THROW(numbers.put_steady(std::span(&value, 1), 1), std::invalid_argument);
  }
}

TEST(Packed, InflatesToWhatItWas) {
  std::string bytes;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(unpacked(packed(bytes)), bytes);
    EXPECT_EQ(packed(bytes).size() % 4, 0u) << "padded base64";
    bytes += static_cast<char>(i * 37);
  }
}

}  // namespace
}  // namespace plumb::packed_test
