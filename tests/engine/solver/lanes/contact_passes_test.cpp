// Every version of the kernels against the one that takes one number at a time, bit for bit.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "../../random_shapes.h"
#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION::contact_passes_test {

namespace {

constexpr std::uint32_t body_count = 64;

/// Contacts of all kinds between bodies, no body twice in a run; the numbers mean nothing, but are the same for every
/// width: sixteen contacts of each kind and run, the last of eight is none.
template <std::size_t width>
struct Tangle {
  static constexpr std::uint32_t run_lanes = 16;
  static constexpr std::uint32_t groups = run_lanes / width;  // of a run
  std::vector<Real> velocity, before, kick, motion, turn, acceleration;
  std::vector<ContactLanes<1, width>> one{2 * groups};
  std::vector<DiscLanes<width>> discs{2 * groups};
  std::vector<ContactLanes<2, width>> two{2 * groups};
  std::vector<ContactLanes<2, width>> block{2 * groups};
  std::vector<SmoothLanes<width>> smooth{2 * groups};
  std::vector<SmoothDiscLanes<width>> smooth_discs{2 * groups};
  std::vector<LanesRun> runs;
  SoftRule soft{};

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
    for (std::size_t body = 0; body < body_count; ++body) {
      velocity[4 * body + 3] = body % 8 == 3 || body == body_count - 1 ? 0 : random.number(.1, 2);
      acceleration[4 * body + 3] = 0;
    }
    const auto choose = [&](SoftRule::Choice& choice, double least, double most) {
      for (auto& by_web : choice) {
        for (Real& number : by_web) number = random.number(least, most);
      }
    };
    choose(soft.strength, .5, 1);
    choose(soft.rate, 5, 20);
    choose(soft.relief, 0, .5);
    choose(soft.give, .001, .01);
    choose(soft.gain, .01, .7);
    soft.leak = random.number(.01, .4);
    for (std::uint32_t run = 0; run < 2; ++run) {
      fill(one, random, run);
      fill(discs, random, run);
      fill(two, random, run);
      fill(block, random, run);
      fill(smooth, random, run);
      fill(smooth_discs, random, run);
      for (std::size_t kind = 0; kind < lanes_kinds; ++kind) {
        runs.push_back({static_cast<LanesKind>(kind), run * groups, (run + 1) * groups});
      }
    }
  }

  template <class Lanes>
  static void fill(std::vector<Lanes>& all, RandomShapes& random, std::uint32_t run) {
    for (std::uint32_t i = 0; i < run_lanes; ++i) {
      Lanes& lanes = all[run * groups + i / width];
      const std::uint32_t lane = i % width;
      if (i % 8 == 7) {
        lanes.a[lane] = lanes.b[lane] = 4 * (body_count - 1);
        continue;
      }
      lanes.a[lane] = 4 * (i + run);
      lanes.b[lane] = 4 * (i + 2 * run + 20);
      const Rotation q(random.number(-3, 3));
      lanes.normal_x.lane[lane] = q.c;
      lanes.normal_y.lane[lane] = q.s;
      const std::uint32_t bit = 1U << lane;
      lanes.fixed |= i % 8 == 3 ? bit : 0;
      lanes.web |= i % 3 == 1 ? bit : 0;
      lanes.aged |= i % 2 == 1 ? bit : 0;
      lanes.offset.lane[lane] = random.number(0, .001);
      for (auto& p : lanes.point) {
        p.separation.lane[lane] = p.gap.lane[lane] = random.number(-.01, .01);
        p.normal_impulse.lane[lane] = i % 4 == 0 ? 0 : random.number(0, 1);
        p.normal_mass.lane[lane] = random.number(.1, 2);
      }
      if constexpr (requires { lanes.static_friction; }) roughen(lanes, random, i);
      if constexpr (requires { lanes.distance; }) {
        lanes.between_x.lane[lane] = random.number(-1, 1);
        lanes.between_y.lane[lane] = random.number(-1, 1);
        lanes.distance.lane[lane] = random.number(.5, 1.5);
      }
    }
  }

  template <class Lanes>
  static void roughen(Lanes& lanes, RandomShapes& random, std::uint32_t i) {
    const std::uint32_t lane = i % width;
    lanes.fresh |= (i % 3 == 0 ? 1U : 0U) << lane;
    lanes.rounded = true;
    lanes.radius_a.lane[lane] = i % 4 == 0 ? 0 : random.number(0, .1);
    lanes.radius_b.lane[lane] = i % 4 == 0 ? 0 : random.number(0, .1);
    lanes.inertia_a.lane[lane] = random.number(.1, 2);
    lanes.inertia_b.lane[lane] = i % 8 == 3 ? 0 : random.number(.1, 2);
    lanes.static_friction.lane[lane] = random.number(.3, 1);
    lanes.dynamic_friction.lane[lane] = random.number(.1, .3);
    lanes.friction.lane[lane] = lanes.static_friction.lane[lane];
    lanes.two_frictions |= (i % 5 < 3 ? 1U : 0U) << lane;
    for (PointLanes<width>& p : lanes.point) {
      for (Row<width>* row : {&p.cross_a, &p.cross_b, &p.dot_a, &p.dot_b}) {
        row->lane[lane] = random.number(-1, 1);
      }
      p.tangent_impulse.lane[lane] = random.number(-.3, .3);
      p.tangent_mass.lane[lane] = random.number(.1, 2);
    }
  }

  /// A whole step of two sub-steps.
  void step(const SolverKernels& by, const ContactPasses<width>& passes) {
    const BodyRows rows{body_count,    velocity.data(), before.data(),      kick.data(),
                        motion.data(), turn.data(),     acceleration.data()};
    const ContactTable<width> table{one.data(),    discs.data(),        two.data(),  block.data(),
                                    smooth.data(), smooth_discs.data(), runs.data(), runs.data() + runs.size()};
    const Real h = Real{1} / 240;
    by.kick_by_forces(rows, h);
    passes.kick(table, rows);
    for (int i = 0; i < 2; ++i) {
      passes.meet(table, rows, Real{1} / 2);
      by.kick_bodies(rows, i == 0);
      passes.press(table, rows, soft, h);
      far |= by.drift_bodies(rows, h);
      passes.relax(table, rows, false);
      broke |= passes.stick_or_slip(table, rows, Real{1} / 8, Real{1} / 2);
      passes.relax(table, rows, true);
    }
    passes.settle(table, soft, false);
  }
  bool far = false;
  bool broke = false;
};

template <class Item>
bool same_bits(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0;
}

/// For lanes of any width.
template <std::size_t width, class Lanes>
std::vector<Real> numbers_of(const std::vector<Lanes>& all) {
  std::vector<Real> numbers;
  for (std::size_t i = 0; i < all.size() * width; ++i) {
    const Lanes& lanes = all[i / width];
    numbers.push_back(lanes.offset.lane[i % width]);
    for (const auto& p : lanes.point) {
      for (const Row<width>* row : {&p.separation, &p.gap, &p.normal_mass, &p.normal_impulse, &p.total_normal}) {
        numbers.push_back(row->lane[i % width]);
      }
      if constexpr (requires { p.tangent_impulse; }) {
        numbers.push_back(p.tangent_impulse.lane[i % width]);
        numbers.push_back(p.total_tangent.lane[i % width]);
      }
    }
  }
  return numbers;
}

template <std::size_t width>
void expect_same_bits(const Tangle<8>& oracle, const SolverKernels& by, const ContactPasses<width>& passes,
                      unsigned seed) {
  Tangle<width> tangle(seed);
  tangle.step(by, passes);
  EXPECT_TRUE(same_bits(tangle.velocity, oracle.velocity)) << seed;
  EXPECT_TRUE(same_bits(tangle.motion, oracle.motion)) << seed;
  EXPECT_TRUE(same_bits(tangle.turn, oracle.turn)) << seed;
  EXPECT_EQ(tangle.far, oracle.far);
  EXPECT_EQ(tangle.broke, oracle.broke);
  EXPECT_TRUE(same_bits(numbers_of<width>(tangle.one), numbers_of<8>(oracle.one))) << seed;
  EXPECT_TRUE(same_bits(numbers_of<width>(tangle.discs), numbers_of<8>(oracle.discs))) << seed;
  EXPECT_TRUE(same_bits(numbers_of<width>(tangle.two), numbers_of<8>(oracle.two))) << seed;
  EXPECT_TRUE(same_bits(numbers_of<width>(tangle.block), numbers_of<8>(oracle.block))) << seed;
  EXPECT_TRUE(same_bits(numbers_of<width>(tangle.smooth), numbers_of<8>(oracle.smooth))) << seed;
  EXPECT_TRUE(same_bits(numbers_of<width>(tangle.smooth_discs), numbers_of<8>(oracle.smooth_discs))) << seed;
}

TEST(ContactPasses, GiveTheSameBitsWithEveryInstructionSet) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const SolverKernels& scalar = solver_kernels(InstructionSet::scalar);
    Tangle<8> oracle(seed);
    oracle.step(scalar, *scalar.contacts_by_eight);
    for (const InstructionSet set : runnable_instruction_sets()) {
      const SolverKernels& version = solver_kernels(set);
      if (version.contacts_by_eight != nullptr) {
        expect_same_bits(oracle, version, *version.contacts_by_eight, seed);
      } else {
        expect_same_bits(oracle, version, *version.contacts_by_sixteen, seed);
      }
    }
  }
}

TEST(ContactPasses, LeaveEmptyLanesUnchanged) {
  Tangle<8> tangle(1);
  const std::size_t nobody = std::size_t{4} * (body_count - 1);
  for (auto* rows : {&tangle.velocity, &tangle.before, &tangle.kick, &tangle.motion, &tangle.acceleration}) {
    std::fill_n(rows->begin() + static_cast<std::ptrdiff_t>(nobody), 4, Real{0});
  }
  tangle.turn.back() = 0;
  const SolverKernels& scalar = solver_kernels(InstructionSet::scalar);
  tangle.step(scalar, *scalar.contacts_by_eight);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(tangle.velocity[nobody + k], 0);
}

/// Frictionless contacts as general ones.
template <class Lanes, class Smooth>
void widen(const std::vector<Smooth>& from, std::vector<Lanes>& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    to[i] = {};
    static_cast<NormalLanes<8>&>(to[i]) = from[i];
    to[i].rounded = true;
    static_cast<SmoothPointLanes<8>&>(to[i].point[0]) = from[i].point[0];
    for (std::size_t lane = 0; lane < 8; ++lane) {
      to[i].inertia_a.lane[lane] = 2;
      to[i].inertia_b.lane[lane] = 3;
      to[i].radius_a.lane[lane] = to[i].radius_b.lane[lane] = Real{1} / 2;
      to[i].point[0].dot_a.lane[lane] = Real{1} / 2;
      to[i].point[0].dot_b.lane[lane] = -Real{1} / 2;
      to[i].point[0].tangent_mass.lane[lane] = Real{1} / 4;
    }
    if constexpr (requires { to[i].distance; }) {
      to[i].between_x = from[i].between_x;
      to[i].between_y = from[i].between_y;
      to[i].distance = from[i].distance;
    }
  }
}

// With r x n and friction 0, everything that the frictionless kernels leave out only adds 0.
TEST(ContactPasses, GiveFrictionlessKindsTheBitsOfContactsWithoutFriction) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const SolverKernels& scalar = solver_kernels(InstructionSet::scalar);
    Tangle<8> smooth(seed);
    Tangle<8> rough = smooth;
    widen(smooth.smooth, rough.one);
    widen(smooth.smooth_discs, rough.discs);
    const auto keep = [](Tangle<8>& tangle, LanesKind one, LanesKind other) {
      std::erase_if(tangle.runs, [&](const LanesRun& run) { return run.kind != one && run.kind != other; });
    };
    keep(smooth, LanesKind::smooth, LanesKind::smooth_discs);
    keep(rough, LanesKind::one, LanesKind::discs);
    smooth.step(scalar, *scalar.contacts_by_eight);
    rough.step(scalar, *scalar.contacts_by_eight);
    EXPECT_EQ(smooth.velocity, rough.velocity) << seed;
    EXPECT_EQ(smooth.motion, rough.motion) << seed;
    for (std::size_t i = 0; i < smooth.smooth.size(); ++i) {
      for (std::size_t lane = 0; lane < 8; ++lane) {
        const auto expect_same = [&](const auto& now, const auto& twin) {
          EXPECT_EQ(now.point[0].gap.lane[lane], twin.point[0].gap.lane[lane]);
          EXPECT_EQ(now.point[0].normal_impulse.lane[lane], twin.point[0].normal_impulse.lane[lane]);
          EXPECT_EQ(now.point[0].total_normal.lane[lane], twin.point[0].total_normal.lane[lane]);
          EXPECT_EQ(now.offset.lane[lane], twin.offset.lane[lane]);
          EXPECT_EQ(twin.point[0].total_tangent.lane[lane], 0);
        };
        expect_same(smooth.smooth[i], rough.one[i]);
        expect_same(smooth.smooth_discs[i], rough.discs[i]);
      }
    }
  }
}

TEST(ContactPasses, GiveSharpShapesTheBitsOfShapesWithZeroRadius) {
  Tangle<8> rounded(1);
  for (auto& lanes : rounded.two) lanes.radius_a = lanes.radius_b = {};
  Tangle<8> sharp = rounded;
  for (auto& lanes : sharp.two) lanes.rounded = false;
  const SolverKernels& scalar = solver_kernels(InstructionSet::scalar);
  rounded.step(scalar, *scalar.contacts_by_eight);
  sharp.step(scalar, *scalar.contacts_by_eight);
  EXPECT_TRUE(same_bits(numbers_of<8>(sharp.two), numbers_of<8>(rounded.two)));
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::contact_passes_test
