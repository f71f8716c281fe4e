#include "broad_phase/neighbours.h"

#include <gtest/gtest.h>

#include "../random_shapes.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION::neighbours_test {

namespace {

/// Unit boxes in a square, a fifth of them fixed, some of them in several layers or parts of one body.
class Crowd {
 public:
  explicit Crowd(unsigned seed, std::uint32_t count = 300) : random_(seed) {
    for (std::uint32_t i = 0; i < count; ++i) {
      centers_.push_back(random_.point(8));
      const std::uint32_t layers = i % 3 == 0 ? 1U : ~0U;
      proxies_.push_back({{}, {}, i / 2, static_cast<std::uint16_t>(i % 2), i % 10 > 1, layers});
    }
    move(0, 0);
  }

  /// Every box by up to `little`, the first `leaving` by a meter or so.
  void move(double little, std::uint32_t leaving) {
    for (std::uint32_t i = 0; i < proxies_.size(); ++i) {
      const Vec2 by = random_.point(i < leaving ? 1 : little);
      centers_[i] = centers_[i] + by;
      proxies_[i].displacement = {by, length(by)};
      proxies_[i].bounds = grown({centers_[i], centers_[i] + Vec2{1, 1}}, length(by));
    }
  }
  std::span<const Proxy> proxies() const { return proxies_; }

 private:
  RandomShapes random_;
  std::vector<Vec2> centers_;
  std::vector<Proxy> proxies_;
};

/// Counts the searches.
class Counted : public BroadPhase {
 public:
  void find_pairs(std::span<const Proxy> proxies, std::vector<Pair>& pairs) override {
    ++searches;
    brute_->find_pairs(proxies, pairs);
  }
  int searches = 0;

 private:
  std::unique_ptr<BroadPhase> brute_ = MethodList<BroadPhase>::make("brute");
};

class Watched {
 public:
  void expect_the_pairs_of(const Crowd& crowd, std::uint64_t version = 1) {
    std::vector<Pair> expected;
    MethodList<BroadPhase>::make("brute")->find_pairs(crowd.proxies(), expected);
    std::vector<Pair> pairs{{7, 3}};
    neighbours_.find(broad_phase_, crowd.proxies(), version, pairs);
    EXPECT_EQ(pairs, expected);
  }
  int searches() const { return broad_phase_.searches; }

 private:
  Counted broad_phase_;
  Neighbours neighbours_;
};

TEST(Neighbours, SearchOnceWhileNothingMoves) {
  Crowd crowd(1);
  Watched watched;
  for (int step = 0; step < 30; ++step) {
    watched.expect_the_pairs_of(crowd);
    crowd.move(step % 2 == 0 ? 1e-3 : 0, 0);
  }
  EXPECT_EQ(watched.searches(), 1);
}

TEST(Neighbours, UpdateAFewMovedProxiesWithoutASearch) {
  Crowd crowd(2);
  Watched watched;
  for (int step = 0; step < 30; ++step) {
    watched.expect_the_pairs_of(crowd);
    crowd.move(1e-4, 20);
  }
  EXPECT_EQ(watched.searches(), 1);
}

TEST(Neighbours, FindTheSamePairsAsABroadPhase) {
  for (unsigned seed = 3; seed < 20; ++seed) {
    Crowd crowd(seed);
    Watched watched;
    for (int step = 0; step < 60; ++step) {
      watched.expect_the_pairs_of(crowd);
      crowd.move(step % 7 == 0 ? .2 : 1e-3, step % 5 == 0 ? 40 : 3);
    }
  }
}

TEST(Neighbours, UseNoFatBoundsForAWhileIfAllMove) {
  Crowd crowd(20);
  Watched watched;
  for (int step = 0; step < 17; ++step) {
    watched.expect_the_pairs_of(crowd);
    crowd.move(.5, 0);
  }
  EXPECT_EQ(watched.searches(), 17);
}

TEST(Neighbours, StartOverWithOtherProxies) {
  Watched watched;
  for (std::uint32_t count = 70; count < 80; ++count) watched.expect_the_pairs_of(Crowd(count, count), count);
  EXPECT_EQ(watched.searches(), 10);
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::neighbours_test
