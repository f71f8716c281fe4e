#include "broad_phase/lanes/overlaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../../random_shapes.h"
#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

struct Crowd {
  std::vector<Aabb> boxes;
  std::vector<Way> ways;
  std::vector<Real> low_x, low_y, high_x, high_y, way_x, way_y, way_length;

  explicit Crowd(std::uint32_t count, RandomShapes& random) {
    for (std::uint32_t i = 0; i < count + most_lanes; ++i) {
      const Vec2 low = random.point(5);
      // Whole numbers, so that some only just touch.
      const Vec2 corner{static_cast<Real>(static_cast<int>(low.x)), static_cast<Real>(static_cast<int>(low.y))};
      const Vec2 size{static_cast<Real>(i % 3), static_cast<Real>(i % 4)};
      boxes.push_back({corner, corner + size});
      low_x.push_back(corner.x);
      low_y.push_back(corner.y);
      high_x.push_back(corner.x + size.x);
      high_y.push_back(corner.y + size.y);
      const Vec2 way = i % 2 == 0 ? Vec2{} : random.point(1);
      ways.push_back({way, length(way)});
      way_x.push_back(way.x);
      way_y.push_back(way.y);
      way_length.push_back(ways.back().length);
    }
  }
  BoundsColumns columns() const {
    return {low_x.data(), low_y.data(), high_x.data(), high_y.data(), way_x.data(), way_y.data(), way_length.data()};
  }
  Proxy proxy(std::uint32_t i) const { return {boxes[i], ways[i], i, 0, true, 1}; }
};

TEST(FindOverlaps, FindsWhatOverlapsOneByOneWithEveryInstructionSet) {
  RandomShapes random(1);
  std::size_t hits = 0;
  for (std::uint32_t count = 1; count < 60; ++count) {
    const Crowd crowd(count, random);
    const auto some = [&] { return static_cast<std::uint32_t>(random.number(0, count + .999)); };
    std::vector<Range> ranges{{some(), count}, {some(), count}};
    ranges[0].begin = std::min(ranges[0].begin, ranges[1].begin);
    ranges[0].end = ranges[1].begin;
    const Proxy one = crowd.proxy(count / 2);

    std::vector<std::uint32_t> expected;
    std::size_t room = 8;
    for (const Range& range : ranges) {
      room += range.end - range.begin;
      for (std::uint32_t i = range.begin; i < range.end; ++i) {
        if (within_reach(one, crowd.proxy(i))) expected.push_back(i);
      }
    }
    hits += expected.size();
    for (const Kernels* version : runnable_kernels()) {
      std::vector<std::uint32_t> found(room + 1, 77);
      const std::uint32_t* end = version->find_overlaps(crowd.columns(), one.bounds, one.way, ranges.data(),
                                                        ranges.data() + ranges.size(), found.data());
      EXPECT_EQ(found.back(), 77U);
      found.resize(static_cast<std::size_t>(end - found.data()));
      EXPECT_EQ(found, expected) << count;
    }
  }
  EXPECT_GT(hits, 100U);
}

TEST(AnswerQuestions, AgreesWithOneAtATime) {
  RandomShapes random(2);
  const Crowd crowd(50, random);
  const auto some = [&] { return static_cast<std::uint32_t>(random.number(0, 49.999)); };
  std::vector<Question> questions;
  std::vector<Pair> expected;  // of a question's number and an answer
  std::size_t room = most_lanes;
  for (std::uint32_t number = 0; number < 300; ++number) {
    const std::uint32_t begin = some();
    const Question question{some(), {begin, std::max(begin, some())}};
    questions.push_back(question);
    room += question.range.end - question.range.begin;
    for (std::uint32_t i = question.range.begin; i < question.range.end; ++i) {
      if (within_reach(crowd.proxy(question.asker), crowd.proxy(i))) expected.push_back({number, i});
    }
  }
  EXPECT_GT(expected.size(), 100U);
  for (const Kernels* version : runnable_kernels()) {
    std::vector<std::uint32_t> question_of(room + 1, 77);
    std::vector<std::uint32_t> answer(room + 1, 77);
    const std::uint32_t count =
        version->answer_questions(crowd.columns(), questions.data(), 300, question_of.data(), answer.data());
    EXPECT_EQ(question_of.back(), 77U);
    EXPECT_EQ(answer.back(), 77U);
    std::vector<Pair> found;
    for (std::uint32_t i = 0; i < count; ++i) found.push_back({question_of[i], answer[i]});
    EXPECT_EQ(found, expected);
  }
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
