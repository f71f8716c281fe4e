#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../random_shapes.h"
#include "narrow_phase/lanes/manifolds.h"

namespace impulse::inline IMPULSE_PRECISION::fast_pairs_test {

namespace {

constexpr Real least = static_cast<Real>(0.05);
constexpr Real time = static_cast<Real>(0.1);

bool fast(const ShapeRecord& a, const ShapeRecord& b, const PairPoints& found, bool known) {
  const Vec2 between = b.velocity - a.velocity;
  const Real turning = a.rim + b.rim;
  if (time * (std::abs(between.x) + std::abs(between.y) + turning) <= least * (Real{63} / 64)) return false;
  const Real speed = turning - dot({found.normal[0], found.normal[1]}, between);
  return !known || time * speed > std::max(std::min(found.separation[0], found.separation[1]), least);
}

TEST(FindFast, AgreesWithOneAtATime) {
  RandomShapes random(3);
  std::vector<ShapeRecord> records(30);
  for (ShapeRecord& record : records) {
    record.velocity = random.point(.4);
    record.rim = random.number(0, .3);
  }
  std::size_t hits = 0;
  for (std::uint32_t count = 0; count < 60; ++count) {
    std::vector<Pair> pairs;
    std::vector<PairPoints> found(count + 1);
    std::vector<std::int8_t> counts;
    std::vector<std::uint32_t> items;
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i <= count; ++i) {
      pairs.push_back({i % 30, (7 * i + 1) % 30});
      const Vec2 normal = Rotation(random.number(-4, 4)) * Vec2{1, 0};
      found[i] = {{normal.x, normal.y}, {random.number(-.1, .1), random.number(-.1, .1)}, {}, {}, 2};
      counts.push_back(i % 4 == 0 ? std::int8_t{-1} : std::int8_t{2});
    }
    for (std::uint32_t item = count; item > 0; --item) {
      items.push_back(item);
      const Pair& pair = pairs[item];
      if (fast(records[pair.first], records[pair.second], found[item], counts[item] >= 0)) expected.push_back(item);
    }
    hits += expected.size();
    const PairBatch batch{records.data(), pairs.data(), items.data(), count, least, time};
    for (const InstructionSet set : runnable_instruction_sets()) {
      std::vector<std::uint32_t> to(count);
      to.resize(static_cast<std::size_t>(
          narrow_phase_kernels(set).find_fast(batch, found.data(), counts.data(), to.data()) - to.data()));
      EXPECT_EQ(to, expected) << count;
    }
  }
  EXPECT_GT(hits, 200U);
  EXPECT_LT(hits, 1500U);  // of 1770
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::fast_pairs_test
