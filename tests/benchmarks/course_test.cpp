#include "course.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "collapse.h"
#include "reports/judge/mechanics.h"

namespace plumb::benchmarks {
namespace {

TEST(Courses, AreTheseOfTheirSizesAndBeginSound) {
  std::map<std::string, std::ptrdiff_t> dynamic;
  for (const Course* course : Catalog<Course>::all()) {
    const Start start = course->start();
    const Condition found = condition(start, initial_states(start.scene));
    EXPECT_EQ(found.broken, "") << course->name;
    EXPECT_LT(found.overlap.most, 1e-12) << course->name;
    EXPECT_GT(course->settled.steps() + course->moving.steps(), 0) << course->name;
    dynamic[course->name] = std::count_if(start.scene.bodies.begin(), start.scene.bodies.end(),
                                          [](const Body& body) { return body.type == BodyType::dynamic; });
  }
  const std::map<std::string, std::ptrdiff_t> expected{
      {"bouncing", 600},      {"free-10000", 10000}, {"joint-grid", 9993}, {"many-pyramids", 22000}, {"one-box", 1},
      {"pyramid-100", 5050},  {"pyramid-20", 210},   {"rain", 2000},       {"smash", 9601},          {"terrain", 4000},
      {"smooth-discs", 2000}, {"three-bodies", 2},   {"tumbler", 2025},    {"washer", 8100}};
  EXPECT_EQ(dynamic, expected);
}

}  // namespace
}  // namespace plumb::benchmarks
