#include "figures.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace plumb::benchmarks {
namespace {

TEST(Figures, AreMediansAStep) {
  const std::vector<Lap> laps{{.wall = 6, .cpu = 3}, {.wall = 2, .cpu = 1}, {.wall = 4, .cpu = 2}};
  const Figures all = figures(laps, {}, 10, Basis::cpu);
  EXPECT_DOUBLE_EQ(all.wall.median, 0.4);
  EXPECT_DOUBLE_EQ(all.cpu.median, 0.2);
  EXPECT_DOUBLE_EQ(all.cpu.low, 0.15);
  EXPECT_EQ(all.speed.median, 0);
}

TEST(Figures, TellSpeedRoundByRound) {
  const std::vector<Lap> laps{{.wall = 1, .cpu = 1}, {.wall = 9, .cpu = 3}};
  const std::vector<Lap> reference{{.wall = 2, .cpu = 2}, {.wall = 9, .cpu = 9}};
  EXPECT_DOUBLE_EQ(figures(laps, reference, 1, Basis::cpu).speed.median, 2.5);
  EXPECT_DOUBLE_EQ(figures(laps, reference, 1, Basis::wall).speed.median, 1.5);
}

TEST(Figures, CompareNothingWithNothing) {
  const std::vector<Lap> one(1);
  EXPECT_EQ(figures({}, one, 1, Basis::cpu).speed.median, 0);
  EXPECT_THROW(figures(std::vector<Lap>(2), one, 1, Basis::cpu), std::invalid_argument);
}

TEST(Figures, CountTheRoundsThatOthersDisturbed) {
  EXPECT_FALSE(disturbed({.wall = 1, .cpu = 0.91}));
  EXPECT_TRUE(disturbed({.wall = 1, .cpu = 0.89}));
  const std::vector<Lap> laps{{.wall = 2, .cpu = 1}, {.wall = 1, .cpu = 1}};
  EXPECT_EQ(figures(laps, laps, 1, Basis::cpu).disturbed, 1);
}

}  // namespace
}  // namespace plumb::benchmarks
