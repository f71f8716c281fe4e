// Every version of the kernels against the one that takes one number at a time, bit for bit.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "../random_shapes.h"
#include "kernels.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::uint32_t body_count = 40;

/// Contacts of all kinds between bodies, no body twice in a run; the numbers mean nothing.
struct Tangle {
  std::vector<Real> velocity, before, kick, motion, turn, acceleration;
  std::vector<ContactLanes<1>> one{2};
  std::vector<DiscLanes> discs{2};
  std::vector<ContactLanes<2>> two{2};
  std::vector<ContactLanes<2>> block{2};
  std::vector<LanesRun> runs;

  explicit Tangle(unsigned seed) {
    RandomShapes random(seed);
    const auto numbers = [&](std::size_t count, double reach) {
      std::vector<Real> result(count);
      for (Real& one_number : result) one_number = random.number(-reach, reach);
      return result;
    };
    velocity = numbers(std::size_t{4} * body_count, 5);
    before = numbers(std::size_t{4} * body_count, 5);
    kick = numbers(std::size_t{4} * body_count, 1);
    motion = numbers(std::size_t{4} * body_count, .1);
    turn = numbers(body_count, .1);
    acceleration = numbers(std::size_t{4} * body_count, 10);
    for (std::uint32_t i = 0; i < 2; ++i) {
      fill(one[i], random, i);
      fill(discs[i], random, i);
      for (std::size_t lane = 0; lane < 8; ++lane) {
        discs[i].between_x.lane[lane] = random.number(-1, 1);
        discs[i].between_y.lane[lane] = random.number(-1, 1);
        discs[i].distance.lane[lane] = random.number(.5, 1.5);
      }
      fill(two[i], random, i);
      fill(block[i], random, i);
      for (const LanesKind kind : {LanesKind::one, LanesKind::discs, LanesKind::two, LanesKind::block}) {
        runs.push_back({kind, i, i + 1});
      }
    }
  }

  template <class Lanes>
  static void fill(Lanes& lanes, RandomShapes& random, std::uint32_t shift) {
    for (std::uint32_t lane = 0; lane < 8; ++lane) {
      // The last lane holds no contact.
      if (lane == 7) {
        lanes.a[lane] = lanes.b[lane] = body_count - 1;
        continue;
      }
      lanes.a[lane] = 2 * lane + shift;
      lanes.b[lane] = 2 * lane + 16 + 2 * shift;
      const Rotation q(random.number(-3, 3));
      lanes.normal_x.lane[lane] = q.c;
      lanes.normal_y.lane[lane] = q.s;
      lanes.mass_a.lane[lane] = random.number(.1, 2);
      lanes.inertia_a.lane[lane] = random.number(.1, 2);
      lanes.mass_b.lane[lane] = lane == 3 ? 0 : random.number(.1, 2);
      lanes.inertia_b.lane[lane] = lane == 3 ? 0 : random.number(.1, 2);
      lanes.static_friction.lane[lane] = random.number(.3, 1);
      lanes.dynamic_friction.lane[lane] = random.number(.1, .3);
      lanes.strength.lane[lane] = random.number(.5, 1);
      lanes.rate.lane[lane] = random.number(5, 20);
      lanes.relief.lane[lane] = 1 - lanes.strength.lane[lane];
      lanes.give.lane[lane] = random.number(.001, .01);
      lanes.offset.lane[lane] = random.number(0, .001);
      lanes.offset_rate.lane[lane] = lane % 2 == 0 ? 0 : random.number(.01, .1);
      lanes.fresh.lane[lane] = lane % 3 == 0 ? 1 : 0;
      for (PointLanes& p : lanes.point) {
        for (Eight* eight : {&p.cross_a, &p.cross_b, &p.dot_a, &p.dot_b, &p.turn_a, &p.turn_b}) {
          eight->lane[lane] = random.number(-1, 1);
        }
        p.separation.lane[lane] = p.gap.lane[lane] = random.number(-.01, .01);
        p.normal_impulse.lane[lane] = lane % 4 == 0 ? 0 : random.number(0, 1);
        p.tangent_impulse.lane[lane] = random.number(-.3, .3);
      }
    }
    lanes.any_fresh = true;
  }

  /// A whole step of two sub-steps.
  void step(const Kernels& by) {
    const BodyRows rows{body_count,    velocity.data(), before.data(),      kick.data(),
                        motion.data(), turn.data(),     acceleration.data()};
    const ContactTable table{one.data(),   discs.data(), two.data(),
                             block.data(), runs.data(),  runs.data() + runs.size()};
    const Real h = Real{1} / 240;
    by.weigh_contacts(table);
    by.kick_by_forces(rows, h);
    by.kick_by_contacts(table, rows);
    for (int i = 0; i < 2; ++i) {
      by.kick_bodies(rows, i == 0);
      by.press_contacts(table, rows, h);
      far |= by.drift_bodies(rows, h);
      by.relax_contacts(table, rows, false);
      by.relax_contacts(table, rows, true);
    }
    by.settle_offsets(table, false);
  }
  bool far = false;
};

template <class Item>
bool same_bits(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0;
}

bool same_bits(const PointLanes& a, const PointLanes& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST(ContactPasses, GiveTheSameBitsWithEveryInstructionSet) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Tangle oracle(seed);
    oracle.step(*runnable_kernels().front());
    for (const Kernels* version : runnable_kernels()) {
      Tangle tangle(seed);
      tangle.step(*version);
      EXPECT_TRUE(same_bits(tangle.velocity, oracle.velocity)) << seed;
      EXPECT_TRUE(same_bits(tangle.motion, oracle.motion)) << seed;
      EXPECT_TRUE(same_bits(tangle.turn, oracle.turn)) << seed;
      EXPECT_EQ(tangle.far, oracle.far);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_TRUE(same_bits(tangle.one[i].point[0], oracle.one[i].point[0])) << seed;
        EXPECT_TRUE(same_bits(tangle.discs[i].point[0], oracle.discs[i].point[0])) << seed;
        for (std::size_t p = 0; p < 2; ++p) {
          EXPECT_TRUE(same_bits(tangle.two[i].point[p], oracle.two[i].point[p])) << seed;
          EXPECT_TRUE(same_bits(tangle.block[i].point[p], oracle.block[i].point[p])) << seed;
        }
        EXPECT_EQ(std::memcmp(&tangle.block[i].offset, &oracle.block[i].offset, sizeof(Eight)), 0) << seed;
      }
    }
  }
}

TEST(ContactPasses, LeaveLanesWithoutContactAlone) {
  Tangle tangle(1);
  const std::size_t nobody = std::size_t{4} * (body_count - 1);
  for (auto* rows : {&tangle.velocity, &tangle.before, &tangle.kick, &tangle.motion, &tangle.acceleration}) {
    std::fill_n(rows->begin() + static_cast<std::ptrdiff_t>(nobody), 4, Real{0});
  }
  tangle.turn.back() = 0;
  tangle.step(kernels());
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(tangle.velocity[nobody + k], 0);
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
