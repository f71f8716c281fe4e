#include "broad_phase/lanes/overlaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../../random_shapes.h"

namespace impulse::inline IMPULSE_PRECISION::overlaps_test {

namespace {

struct Boxes {
  std::vector<Aabb> all;
  std::vector<Displacement> displacements;
  std::vector<Real> low_x, low_y, high_x, high_y, displacement_x, displacement_y, displacement_length;

  explicit Boxes(std::uint32_t count, RandomShapes& random) {
    for (std::uint32_t i = 0; i < count + most_lanes; ++i) {
      const Vec2 low = random.point(5);
      // Whole numbers, so that some only just touch.
      const Vec2 corner{static_cast<Real>(static_cast<int>(low.x)), static_cast<Real>(static_cast<int>(low.y))};
      const Vec2 size{static_cast<Real>(i % 3), static_cast<Real>(i % 4)};
      all.push_back({corner, corner + size});
      low_x.push_back(corner.x);
      low_y.push_back(corner.y);
      high_x.push_back(corner.x + size.x);
      high_y.push_back(corner.y + size.y);
      const Vec2 by = i % 2 == 0 ? Vec2{} : random.point(1);
      displacements.push_back({by, length(by)});
      displacement_x.push_back(by.x);
      displacement_y.push_back(by.y);
      displacement_length.push_back(displacements.back().length);
    }
  }
  BoundsColumns columns() const {
    return {low_x.data(),
            low_y.data(),
            high_x.data(),
            high_y.data(),
            displacement_x.data(),
            displacement_y.data(),
            displacement_length.data()};
  }
  Proxy proxy(std::uint32_t i) const { return {all[i], displacements[i], i, 0, true, 1}; }
};

TEST(FindOverlaps, AgreesWithOneAtATimeForEveryInstructionSet) {
  RandomShapes random(1);
  std::size_t hits = 0;
  for (std::uint32_t count = 1; count < 60; ++count) {
    const Boxes boxes(count, random);
    const auto some = [&] { return static_cast<std::uint32_t>(random.number(0, count + .999)); };
    std::vector<Range> ranges{{some(), count}, {some(), count}};
    ranges[0].begin = std::min(ranges[0].begin, ranges[1].begin);
    ranges[0].end = ranges[1].begin;
    const Proxy one = boxes.proxy(count / 2);

    std::vector<std::uint32_t> expected;
    std::size_t capacity = 8;
    for (const Range& range : ranges) {
      capacity += range.end - range.begin;
      for (std::uint32_t i = range.begin; i < range.end; ++i) {
        if (within_reach(one, boxes.proxy(i))) expected.push_back(i);
      }
    }
    hits += expected.size();
    for (const InstructionSet set : runnable_instruction_sets()) {
      std::vector<std::uint32_t> found(capacity + 1, 77);
      const std::uint32_t* end = broad_phase_kernels(set).find_overlaps(
          boxes.columns(), one.bounds, one.displacement, ranges.data(), ranges.data() + ranges.size(), found.data());
      EXPECT_EQ(found.back(), 77U);
      found.resize(static_cast<std::size_t>(end - found.data()));
      EXPECT_EQ(found, expected) << count;
    }
  }
  EXPECT_GT(hits, 100U);
}

TEST(AnswerBatch, AgreesWithOneAtATime) {
  RandomShapes random(2);
  const Boxes boxes(50, random);
  const auto some = [&] { return static_cast<std::uint32_t>(random.number(0, 49.999)); };
  std::vector<Query> queries;
  std::vector<Pair> expected;  // index of a query and a hit
  std::size_t capacity = most_lanes;
  for (std::uint32_t number = 0; number < 300; ++number) {
    const std::uint32_t begin = some();
    const Query query{some(), {begin, std::max(begin, some())}};
    queries.push_back(query);
    capacity += query.range.end - query.range.begin;
    for (std::uint32_t i = query.range.begin; i < query.range.end; ++i) {
      if (within_reach(boxes.proxy(query.from), boxes.proxy(i))) expected.push_back({number, i});
    }
  }
  EXPECT_GT(expected.size(), 100U);
  for (const InstructionSet set : runnable_instruction_sets()) {
    std::vector<std::uint32_t> query_of(capacity + 1, 77);
    std::vector<std::uint32_t> hit(capacity + 1, 77);
    const std::uint32_t count =
        broad_phase_kernels(set).answer_batch(boxes.columns(), queries.data(), 300, query_of.data(), hit.data());
    EXPECT_EQ(query_of.back(), 77U);
    EXPECT_EQ(hit.back(), 77U);
    std::vector<Pair> found;
    for (std::uint32_t i = 0; i < count; ++i) found.push_back({query_of[i], hit[i]});
    EXPECT_EQ(found, expected);
  }
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::overlaps_test
