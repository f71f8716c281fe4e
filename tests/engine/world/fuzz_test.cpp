// Random scenes of up to 200 bodies: for all sizes and speeds, states stay finite and no energy appears from nowhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "../random_shapes.h"
#include "../support.h"

namespace impulse::inline IMPULSE_PRECISION::fuzz_test {

namespace {

/// Sizes from 1 cm to 100 m, each decade equally likely, and speeds up to 100 m/s. No two bodies touch at first,
/// because an overlap holds energy too: bodies start on a square lattice with cells as wide as the largest body.
class RandomScene {
 public:
  RandomScene(unsigned seed, const std::string& solver) : random_(seed), world_(settings(random_, solver)) {
    const int count = 2 + static_cast<int>(random_.number(0, 199));
    const double largest = power_of_ten(static_cast<double>(random_.number(-2, 2)));
    const int row = static_cast<int>(std::ceil(std::sqrt(count)));
    for (int i = 0; i < count; ++i) add(i, row, largest);
    if (world_.gravity() != Vec2{}) add_floor(world_, material());
  }

  World& world() { return world_; }

  /// J, computed in double.
  double energy() {
    double sum = 0;
    for (const BodyId id : world_.bodies()) {
      const Body body = world_.body(id);
      const double m = body.mass().mass;
      const double vx = body.velocity().x;
      const double vy = body.velocity().y;
      const double w = body.angular_velocity();
      sum += m * (vx * vx + vy * vy) / 2 + body.mass().inertia * w * w / 2;
      sum -= m * static_cast<double>(world_.gravity().y) * static_cast<double>(body.center().y);
    }
    return sum;
  }

  /// N s, the greatest pull of a contact; 0 if none pulls.
  double greatest_pull() {
    double worst = 0;
    for (const ContactInfo& contact : world_.contacts()) {
      worst = std::max(worst, -static_cast<double>(contact.normal_impulse));
    }
    return worst;
  }

  bool is_finite() {
    const auto bounded = [](Real x) { return std::abs(x) < Shape::unbounded; };  // false for NaN
    const std::span<const BodyId> ids = world_.bodies();
    return std::all_of(ids.begin(), ids.end(), [&](BodyId id) {
      const Body body = world_.body(id);
      return bounded(body.position().x) && bounded(body.position().y) && bounded(body.angle()) &&
             bounded(body.velocity().x) && bounded(body.velocity().y) && bounded(body.angular_velocity());
    });
  }

 private:
  static Settings settings(RandomShapes& random, const std::string& solver) {
    Settings chosen;
    chosen.solver = solver;
    if (random.number(0, 1) < Real{0.5}) chosen.gravity = {};
    return chosen;
  }

  static double power_of_ten(double exponent) { return std::pow(10.0, exponent); }

  Material material() {
    const Real friction = random_.number(0, 1);
    return {random_.number(.1, 10), friction, friction * random_.number(0, 1), random_.number(0, 1)};
  }

  Shape shape(double size) {
    switch (static_cast<int>(random_.number(0, 3.99))) {
      case 0:
        return Shape::circle(real(size));
      case 1:
        return Shape::box({real(size * .7), random_.number(.05 * size, .7 * size)});
      case 2:
        return Shape::capsule({real(-size / 2), 0}, {real(size / 2), 0}, random_.number(.05 * size, size / 2));
      default:
        return polygon(size);
    }
  }

  Shape polygon(double size) {
    std::array<Vec2, 6> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Real angle = (static_cast<Real>(i) + random_.number(0, .8)) * pi / 3;
      corners[i] = Rotation(angle) * Vec2{random_.number(.5 * size, size), 0};
    }
    return Shape::polygon(corners);
  }

  void add(int i, int row, double largest) {
    const double size = std::max(.01, largest * power_of_ten(static_cast<double>(random_.number(-2, 0))));
    const double cell = 2.2 * std::max(.01, largest);
    const int line = i / row + 1;
    BodyDef def = at(cell * (i % row), cell * line);
    def.angle = random_.number(-3, 3);
    const double fastest = power_of_ten(static_cast<double>(random_.number(-1, 2)));
    def.velocity = random_.point(fastest * .7);
    def.angular_velocity = random_.number(-1, 1) * def.velocity.x / real(size);
    def.bullet = random_.number(0, 1) < real(.1);
    world_.create_body(def, shape(size), material());
  }

  RandomShapes random_;
  World world_;
};

constexpr int steps = 60;

int seeds() {
  const char* chosen = std::getenv("PLUMB_FUZZ_SEEDS");
  return chosen == nullptr ? 20 : std::max(1, std::atoi(chosen));
}

// The relative energy gain that is allowed. The default method gains none: in flight, velocity Verlet conserves the
// energy of a parabola; with e <= 1 impacts take energy, and so does friction; and since no two bodies overlap at
// first, the energy that a contact's spring returns was stored in it before. So only rounding is left: a body's speed
// and height are each rounded about sixteen times in a step of four sub-steps, and in the worst case the errors add up.
//
// For the other methods no bound follows from their sources: pushing overlaps apart adds energy, and so does Newton's
// impact law at several points at once or with friction (Kane and Levinson 1985). Their bounds are what 1000 seeds
// show, rounded up, so that a method that gets worse is noticed.
double bound_of(const std::string& solver) {
  if (solver == "accurate") return steps * 16 * static_cast<double>(round_off);
  if (solver == "exact") return .45;
  return solver == "article" || solver == "xpbd" ? .05 : .2;
}

class Fuzz : public testing::TestWithParam<std::string> {};

TEST_P(Fuzz, RandomScenesStayFiniteNeverPullAndKeepTheEnergyBound) {
  const double bound = bound_of(GetParam());
  int unsolvable = 0;
  for (int seed = 1; seed <= seeds(); ++seed) {
    RandomScene scene(static_cast<unsigned>(seed), GetParam());
    const double before = scene.energy();
    try {
      for (int step = 0; step < steps; ++step) {
        scene.world().step();
        ASSERT_TRUE(scene.is_finite()) << "seed " << seed << ", step " << step;
        ASSERT_LE(scene.energy(), before * (1 + bound)) << "seed " << seed << ", step " << step;
        // xpbd removes the velocity that correcting an overlap added (Mueller et al. 2020, 3.6), so it may pull.
        if (GetParam() != "xpbd") {
          ASSERT_EQ(scene.greatest_pull(), 0) << "seed " << seed << ", step " << step;
        }
      }
    } catch (const std::domain_error&) {
      ++unsolvable;  // more bodies are connected than the method can solve
    }
  }
  if (GetParam() == "exact") {
    EXPECT_LT(unsolvable, seeds());
  } else {
    EXPECT_EQ(unsolvable, 0);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const MethodInfo& solver : solvers()) list.push_back(solver.name);
  return list;
}

INSTANTIATE_TEST_SUITE_P(Solvers, Fuzz, testing::ValuesIn(names()), [](const auto& entry) {
  std::string name = entry.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::fuzz_test
