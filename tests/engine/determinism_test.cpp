// Same input, same bits: ten mixed scenes end in the same state with every compiler and optimization level.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>

#include "random_shapes.h"
#include "support.h"

namespace impulse::inline IMPULSE_PRECISION::determinism_test {

namespace {

/// FNV-1a over the bits of every pose and velocity (Fowler, Noll and Vo 1991), lowest byte first.
class StateHash {
 public:
  void add(World& world) {
    for (const BodyId id : world.bodies()) {
      const Body body = world.body(id);
      for (const Real value : {body.position().x, body.position().y, body.angle(), body.rotation().c, body.rotation().s,
                               body.velocity().x, body.velocity().y, body.angular_velocity()}) {
        add(value);
      }
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  void add(Real value) {
    using Bits = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
    auto bits = std::bit_cast<Bits>(value);
    for (std::size_t byte = 0; byte < sizeof(Real); ++byte) {
      hash_ = (hash_ ^ (bits & 0xff)) * 0x100000001b3U;
      bits = static_cast<Bits>(bits >> 8);
    }
  }

  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

Settings with(const char* solver, const char* broad_phase = "auto", const char* integrator = "symplectic-euler") {
  Settings settings;
  settings.solver = solver;
  settings.broad_phase = broad_phase;
  settings.integrator = integrator;
  return settings;
}

Material material(double friction, double restitution) {
  return {1, real(friction), real(friction), real(restitution)};
}

/// Draws each number in a statement of its own, because the order in which arguments are evaluated is unspecified.
Shape shape(RandomShapes& random, int kind) {
  const Real a = random.number(.2, 1);
  const Real b = random.number(.2, 1);
  if (kind % 4 == 0) return Shape::circle(a);
  if (kind % 4 == 1) return Shape::box({a, b});
  if (kind % 4 == 2) return Shape::capsule({-a, 0}, {a, 0}, b / 2);
  return Shape::polygon(std::array{Vec2{a, 0}, Vec2{-b, b}, Vec2{-b, -a}});
}

World pyramid(const Settings& settings) {
  World world(settings);
  add_floor(world, material(.6, 0));
  for (int row = 0; row < 8; ++row) {
    for (int i = 0; i < 8 - row; ++i) {
      world.create_body(at(i + .5 * row, .5 + row), Shape::box({Real{0.5}, Real{0.5}}), material(.6, 0));
    }
  }
  return world;
}

World mixed_pile(const Settings& settings, unsigned seed) {
  World world(settings);
  add_floor(world);
  RandomShapes random(seed);
  for (int i = 0; i < 40; ++i) {
    const int row = i / 8;
    BodyDef def = at(i % 8 * 2.5, 2 + row * 3);
    def.angle = random.number(-3, 3);
    def.velocity = random.point(3);
    def.angular_velocity = random.number(-5, 5);
    world.create_body(def, shape(random, i), material(.1 * (i % 7), .2 * (i % 5)));
  }
  return world;
}

World billiards() {
  Settings settings = with("accurate");
  settings.gravity = {};
  World world(settings);
  world.create_body(at(-6, .1, 20, 0), Shape::circle(Real{0.5}), frictionless(1));
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i <= row; ++i) {
      world.create_body(at(.9 * row, 1.01 * i - .5 * row), Shape::circle(Real{0.5}), frictionless(.95));
    }
  }
  return world;
}

World bridge() {
  World world(with("accurate"));
  BodyDef bank = at(-.5, 0);
  bank.type = BodyType::fixed;
  const BodyId left = world.create_body(bank, Shape::box({real(.5), real(.1)}));
  bank.position.x = real(10.5);
  const BodyId right = world.create_body(bank, Shape::box({real(.5), real(.1)}));
  BodyId last = left;
  for (int i = 0; i < 10; ++i) {
    const BodyId plank = world.create_body(at(i + .5, 0), Shape::box({real(.5), real(.1)}));
    world.create_joint(RevoluteJoint{last, plank, {real(i), 0}});
    last = plank;
  }
  world.create_joint(RevoluteJoint{last, right, {10, 0}});
  world.create_body(at(5, 3), Shape::circle(real(.7)), material(.4, .3));
  return world;
}

World machine(const char* solver) {
  World world(with(solver));
  const BodyId floor = add_floor(world);
  const BodyId wheel = world.create_body(at(0, 1), Shape::circle(real(.5)), material(.9, 0));
  const BodyId car = world.create_body(at(.5, 1.6), Shape::box({1, real(.2)}));
  world.create_joint(RevoluteJoint{car, wheel, {0, 1}, {}, Motor{-6, 20}});
  const BodyId slider = world.create_body(at(-6, 2), Shape::box({real(.3), real(.3)}));
  world.create_joint(PrismaticJoint{floor, slider, {-6, 2}, {real(.6), real(.8)}, Limits{real(-.5), 2}, Motor{1, 30}});
  const BodyId arm = world.create_body(at(-5, 2), Shape::capsule({-1, 0}, {1, 0}, real(.1)));
  world.create_joint(WeldJoint{slider, arm, {-6, 2}});
  const BodyId bob = world.create_body(at(4, 3), Shape::circle(real(.3)));
  world.create_joint(DistanceJoint{floor, bob, {5, 5}, {4, 3}, 2, 40, 1});
  return world;
}

World terrain() {
  World world(with("accurate", "tree"));
  BodyDef ground;
  ground.type = BodyType::fixed;
  std::vector<Part> parts;
  std::vector<Vec2> line;
  for (int i = 20; i >= -20; --i) line.push_back({real(i), real(.05 * (i * i % 7) + .01 * i * i)});
  for (const Shape& link : Shape::chain(line, false)) parts.push_back({link, material(.5, .1)});
  world.create_body(ground, parts);
  RandomShapes random(3);
  for (int i = 0; i < 12; ++i) {
    world.create_body(at(2.5 * i - 14, 6 + i % 3), shape(random, i));
  }
  return world;
}

World orbits() {
  Settings settings = with("article", "brute", "rk4");
  settings.gravity = {};
  World world(settings);
  const BodyId sun = world.create_body(at(0, 0), Shape::circle(1));
  for (int i = 0; i < 5; ++i) {
    const BodyId planet = world.create_body(at(4 + 2 * i, 0, 0, 3 - .3 * i), Shape::circle(real(.2)));
    Spring spring;
    spring.a = sun;
    spring.b = planet;
    spring.stiffness = real(.3);
    spring.damping = real(.01);
    world.add_force(spring);
  }
  return world;
}

World mixer() {
  World world = mixed_pile(with("accurate", "grid"), 7);
  BodyDef paddle = at(8, 1.2);
  paddle.type = BodyType::kinematic;
  paddle.angular_velocity = 2;
  world.create_body(paddle, Shape::box({3, real(.2)}));
  BodyDef dumbbell = at(8, 20);
  dumbbell.linear_damping = real(.1);
  dumbbell.angular_damping = real(.3);
  const std::array parts{Part{Shape::circle(real(.5), {-1, 0}), {}},
                         Part{Shape::box({real(.3), real(.3)}, {1, 0}), {}}};
  world.create_body(dumbbell, parts);
  dumbbell.fixed_rotation = true;
  dumbbell.position.x = 12;
  world.create_body(dumbbell, parts);
  return world;
}

/// A pile with all types of contacts that lanes handle.
World hail(const Settings& settings) {
  World world(settings);
  add_floor(world, frictionless());
  RandomShapes random(5);
  for (int i = 0; i < 120; ++i) {
    const int row = i / 12;
    BodyDef def = at(i % 12 * 1.1, .8 + row * 1.2);
    def.angle = random.number(-3, 3);
    def.velocity = random.point(1);
    const Real a = random.number(.3, .5);
    const Real b = random.number(.3, .5);
    const Shape of_kind = i % 4 == 3 ? Shape::box({a * real(.7), b * real(.7)}) : Shape::circle(a);
    world.create_body(def, of_kind, i % 4 == 0 ? frictionless() : material(.5, 0));
  }
  return world;
}

// These constants change only if the engine's results change; then the change log must say so.
TEST(Determinism, TenScenesEndInTheSameBitsWithEveryCompiler) {
  StateHash hash;
  const std::array<std::function<World()>, 10> scenes{
      [] { return pyramid(with("accurate")); },
      [] { return pyramid(with("soft-step")); },
      [] { return mixed_pile(with("accurate"), 1); },
      [] { return mixed_pile(with("article", "auto", "velocity-verlet"), 2); },
      billiards,
      bridge,
      [] { return machine("soft-step"); },
      terrain,
      orbits,
      mixer,
  };
  for (const auto& make : scenes) {
    World world = make();
    run(world, 90);
    hash.add(world);
    RecordProperty("state", std::to_string(hash.value()));
  }
  constexpr std::uint64_t expected = sizeof(Real) == 8 ? 0xf0bc3ef755a22dcbU : 0xd8b104a7c6a7bf4bU;
  EXPECT_EQ(hash.value(), expected) << std::hex << "0x" << hash.value();
}

std::uint64_t hash_of_piles() {
  StateHash hash;
  Settings settings = with("accurate");
  for (const auto& make : {pyramid, hail}) {
    World world = make(settings);
    run(world, 90);
    hash.add(world);
  }
  return hash.value();
}

TEST(Determinism, PilesEndInTheSameBitsWithEveryCompiler) {
  constexpr std::uint64_t expected = sizeof(Real) == 8 ? 0x5efed3cac1f9e7f4U : 0x8aa06e1cc7ff5251U;
  const std::uint64_t hash = hash_of_piles();
  EXPECT_EQ(hash, expected) << std::hex << "0x" << hash;
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::determinism_test
