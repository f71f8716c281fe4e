#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string_view>

#include "../random_shapes.h"
#include "../real_literal.h"
#include "broad_phase/broad_phase.h"
#include "core/method_list.h"

namespace impulse::broad_phases_test {
namespace {

using Proxies = std::vector<Proxy>;

std::vector<Pair> pairs_of(BroadPhase& method, const Proxies& proxies) {
  std::vector<Pair> pairs{{7, 3}};  // must be cleared
  method.find_pairs(proxies, pairs);
  return pairs;
}

std::vector<Pair> pairs_of(const char* method, const Proxies& proxies) {
  return pairs_of(*MethodList<BroadPhase>::make(method), proxies);
}

std::vector<Pair> expected_of(const Proxies& proxies) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < proxies.size(); ++i) {
    for (std::uint32_t j = i + 1; j < proxies.size(); ++j) {
      if (within_reach(proxies[i], proxies[j]) && may_collide(proxies[i], proxies[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

struct Crowd {
  std::uint32_t bodies;
  double room;               // half width of the square they are in
  double smallest, largest;  // half sizes, spread evenly over the powers in between
};

Proxies make_proxies(const Crowd& crowd, unsigned seed) {
  RandomShapes random(seed);
  Proxies proxies;
  for (std::uint32_t body = 0; body < crowd.bodies; ++body) {
    const Vec2 center = random.point(crowd.room);
    const bool moves = random.number(0, 1) < 0.8_r;
    const std::uint32_t category =
        random.number(0, 1) < 0.7_r ? ~0U : 1U << static_cast<unsigned>(random.number(0, 3.9));
    // A tenth meets less than it is: masks that differ from categories.
    const Layers layers(category, body % 10 == 0 ? category & 5U : category);
    const int parts = random.number(0, 1) < 0.8_r ? 1 : 3;
    const Vec2 by = random.number(0, 1) < 0.5_r ? Vec2{} : random.point(crowd.smallest);
    const Displacement displacement{by, length(by)};
    for (int part = 0; part < parts; ++part) {
      const Real half = static_cast<Real>(
          crowd.smallest * std::pow(crowd.largest / crowd.smallest, static_cast<double>(random.number(0, 1))));
      const Vec2 at = center + random.point(static_cast<double>(half));
      proxies.push_back({{at - Vec2{half, half}, at + Vec2{half, half}},
                         displacement,
                         body,
                         static_cast<std::uint16_t>(part),
                         moves,
                         layers});
    }
  }
  return proxies;
}

const std::vector<Crowd> crowds{{0, 1, 1, 1},        {1, 1, 1, 1},         {20, 3, 0.5, 0.5},
                                {300, 10, 0.5, 0.6}, {300, 1e4, 0.5, 0.5}, {500, 30, 0.01, 100},
                                {700, 3, 0.5, 0.5},  {300, 1e7, 1, 1},     {1000, 40, 0.5, 0.9}};

class EveryBroadPhase : public testing::TestWithParam<const char*> {};

TEST_P(EveryBroadPhase, FindsEveryPairThatOverlapsAndNoOther) {
  std::size_t found = 0;
  for (const Crowd& crowd : crowds) {
    for (unsigned seed = 0; seed < 10; ++seed) {
      const Proxies proxies = make_proxies(crowd, seed);
      const std::vector<Pair> expected = expected_of(proxies);
      found += expected.size();
      ASSERT_EQ(pairs_of(GetParam(), proxies), expected) << crowd.bodies << " bodies, seed " << seed;
    }
  }
  EXPECT_GT(found, 10000U);
}

// The article sorts the pairs and drops neighbours that are equal, comparing (a, b) with (b, a), which its sort does
// not bring together: each pair stays twice.
TEST_P(EveryBroadPhase, ReportsEachPairOnceAndSorted) {
  const Proxies proxies = make_proxies({400, 10, 0.3, 1.2}, 5);
  const std::vector<Pair> pairs = pairs_of(GetParam(), proxies);
  ASSERT_GT(pairs.size(), 400U);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ASSERT_LT(pairs[i].first, pairs[i].second);
    ASSERT_TRUE(i == 0 || pairs[i - 1] < pairs[i]);
  }
}

TEST_P(EveryBroadPhase, FollowsBodiesThatMoveAppearAndDisappear) {
  const std::unique_ptr<BroadPhase> method = MethodList<BroadPhase>::make(GetParam());
  Proxies all = make_proxies({400, 12, 0.3, 0.9}, 9);
  RandomShapes random(10);
  for (int step = 0; step < 100; ++step) {
    for (Proxy& proxy : all) {
      const Vec2 by = random.point(proxy.body % 7 == 0 ? 1 : 0.02);
      proxy.bounds = {proxy.bounds.low + by, proxy.bounds.high + by};
    }
    Proxies present;
    const auto absent = static_cast<std::uint32_t>(random.number(0, 9.99));
    std::copy_if(all.begin(), all.end(), std::back_inserter(present),
                 [&](const Proxy& proxy) { return proxy.body % 10 != absent; });
    ASSERT_EQ(pairs_of(*method, present), expected_of(present)) << step;
  }
}

TEST_P(EveryBroadPhase, FindsThePairsOfChosenProxies) {
  RandomShapes random(6);
  for (const Real share : {0.2_r, 0.7_r}) {
    for (const Crowd& crowd : crowds) {
      const Proxies proxies = make_proxies(crowd, 1);
      std::vector<std::uint8_t> chosen(proxies.size());
      for (std::uint8_t& one : chosen) one = random.number(0, 1) < share ? 1 : 0;
      std::vector<Pair> expected = expected_of(proxies);
      std::erase_if(expected, [&](const Pair& pair) { return (chosen[pair.first] | chosen[pair.second]) == 0; });
      std::vector<Pair> pairs{{7, 3}};
      MethodList<BroadPhase>::make(GetParam())->find_pairs_of(proxies, chosen, pairs);
      ASSERT_EQ(pairs, expected) << crowd.bodies << " bodies, of which " << share << " are chosen";
    }
  }
}

/// Right after a full search, when the grid can be reused; it must be rebuilt if others changed, too.
TEST_P(EveryBroadPhase, FindsThePairsOfProxiesThatHaveGrown) {
  RandomShapes random(8);
  for (const Real most : {0.0_r, 0.3_r, 30.0_r}) {
    for (const Crowd& crowd : crowds) {
      const std::unique_ptr<BroadPhase> method = MethodList<BroadPhase>::make(GetParam());
      Proxies proxies = make_proxies(crowd, 2);
      pairs_of(*method, proxies);
      for (const char* change : {"growth", "more growth", "layers"}) {
        std::vector<std::uint8_t> chosen(proxies.size());
        for (std::size_t i = 0; i < proxies.size(); ++i) {
          chosen[i] = random.number(0, 1) < 0.3_r ? 1 : 0;
          if (chosen[i] != 0) proxies[i].bounds = grown(proxies[i].bounds, random.number(0, static_cast<double>(most)));
        }
        if (std::string_view(change) == "layers") {
          for (Proxy& proxy : proxies) proxy.layers = {~proxy.layers.category, ~proxy.layers.mask};
        }
        std::vector<Pair> expected = expected_of(proxies);
        std::erase_if(expected, [&](const Pair& pair) { return (chosen[pair.first] | chosen[pair.second]) == 0; });
        std::vector<Pair> pairs{{7, 3}};
        method->find_pairs_of(proxies, chosen, pairs);
        ASSERT_EQ(pairs, expected) << crowd.bodies << " bodies, up to " << most << " m, " << change;
      }
    }
  }
}

/// Like the floor of a crowded hall. A grid that hashes its rows of cells to few buckets could find some of them twice.
TEST_P(EveryBroadPhase, FindsEachProxyOnAWideOneOnce) {
  Proxies proxies{{{{-80, -6}, {80, 6}}, {}, 0, 0, false, 1}};
  for (std::uint32_t body = 1; body < 1500; ++body) {
    const Vec2 low{static_cast<Real>(body % 100) * 1.7_r - 84, static_cast<Real>(body / 100) - 7};
    proxies.push_back({{low, low + Vec2{0.9_r, 0.9_r}}, {}, body, 0, true, 1});
  }
  const std::vector<Pair> expected = expected_of(proxies);
  ASSERT_GT(expected.size(), 1000U);
  EXPECT_EQ(pairs_of(GetParam(), proxies), expected);
}

/// Proxies that move the same way must be close already.
TEST_P(EveryBroadPhase, LeavesOutProxiesThatMoveTheSameWay) {
  const auto going = [](Real x, std::uint32_t body, Vec2 by) {
    const Displacement displacement{by, length(by)};
    return Proxy{grown({{x, 0}, {x + 1, 1}}, displacement.length), displacement, body, 0, true, 1};
  };
  const auto meet = [&](Real x, Vec2 by) {
    return pairs_of(GetParam(), {going(0, 0, {2, 0}), going(x, 1, by)}).size();
  };
  EXPECT_EQ(meet(0.9_r, {2, 0}), 1U);
  EXPECT_EQ(meet(1.1_r, {2, 0}), 0U);
  EXPECT_EQ(meet(4.9_r, {-2, 0}), 1U);
  EXPECT_EQ(meet(5.1_r, {-2, 0}), 0U);
  EXPECT_EQ(meet(2.9_r, {}), 1U);
  EXPECT_EQ(meet(3.1_r, {}), 0U);
}

TEST_P(EveryBroadPhase, PairsOnlyProxiesThatMayCollide) {
  const Aabb place{{0, 0}, {1, 1}};
  EXPECT_THAT(pairs_of(GetParam(), {{place, {}, 0, 0, true, 1}, {place, {}, 1, 0, true, 3}}),
              testing::ElementsAre(Pair{0, 1}));
  EXPECT_THAT(pairs_of(GetParam(), {{place, {}, 0, 0, true, 1}, {place, {}, 1, 0, true, 2}}), testing::IsEmpty());
  EXPECT_THAT(pairs_of(GetParam(), {{place, {}, 0, 0, false, 1}, {place, {}, 1, 0, false, 1}}), testing::IsEmpty());
  EXPECT_THAT(pairs_of(GetParam(), {{place, {}, 0, 0, true, 1}, {place, {}, 0, 1, true, 1}}), testing::IsEmpty());
}

TEST_P(EveryBroadPhase, SurvivesInfiniteAndNanBounds) {
  constexpr Real inf = std::numeric_limits<Real>::infinity();
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  Proxies proxies = make_proxies({200, 8, 0.4, 0.6}, 3);
  proxies[3].bounds = {{-1e9_r, -1e9_r}, {1e9_r, 0}};
  proxies[40].bounds = {{-inf, -inf}, {inf, inf}};
  proxies[60].bounds = {{1e30_r, 0}, {1e30_r, 1}};
  EXPECT_EQ(pairs_of(GetParam(), proxies), expected_of(proxies));
  proxies[80].bounds = {{nan, nan}, {nan, nan}};
  EXPECT_EQ(pairs_of(GetParam(), proxies), expected_of(proxies));
}

INSTANTIATE_TEST_SUITE_P(BroadPhases, EveryBroadPhase, testing::Values("auto", "brute", "grid", "tree"),
                         [](const auto& name) { return std::string(name.param); });

TEST(BroadPhases, AreExactlyThese) {
  std::vector<std::string> names;
  for (const MethodInfo& info : MethodList<BroadPhase>::infos()) names.push_back(info.name);
  EXPECT_THAT(names, testing::ElementsAre("auto", "brute", "grid", "tree"));
}

}  // namespace
}  // namespace impulse::broad_phases_test
