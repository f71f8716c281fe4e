#include "reference/adapter.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "scenarios/parts.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/scene.h"

namespace plumb::adapter_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Body box(Vec position) {
  Body body;
  body.name = "box";
  body.position = position;
  body.shapes.push_back({Box{}, {}});
  return body;
}

TEST(SceneExtent, IsAsFarAsGravityAndTheInitialVelocityCarry) {
  Scene scene;
  scene.duration = 10;
  scene.bodies = {box({30, 40})};
  scene.bodies[0].velocity = {6, 8};
  EXPECT_DOUBLE_EQ(scene_extent(scene), 50 + 10 * 10 + 10 * 100 / 2.0);
  scene.duration = .1;
  EXPECT_DOUBLE_EQ(scene_extent(scene), 100);
}

struct NewKind {};

TEST(VisitSupported, PassesOnTheKindsThatAnAdapterSupportsAlone) {
  const std::variant<Circle, NewKind> known = Circle{.radius = 2};
  const std::variant<Circle, NewKind> other = NewKind{};
  struct {
    double operator()(const Circle& circle) const { return circle.radius; }
    double operator()(const NewKind&) const { return 7; }
  } const make;
  EXPECT_EQ(visit_supported(make, known), 2);
  EXPECT_THROW(visit_supported(make, other), std::logic_error);
  EXPECT_EQ(visit_supported<NewKind>(make, other), 7);
}

TEST(CommonRefusal, NamesTheBodyThatIsBeyondTheEngine) {
  Scene scene;
  scene.bodies = {box({})};
  EXPECT_EQ(common_refusal(scene), "");
  Scene sticky = scene;
  sticky.bodies[0].shapes[0].surface.static_friction = .7;
  EXPECT_THAT(common_refusal(sticky), AllOf(HasSubstr("friction"), HasSubstr("\"box\"")));
  Scene weightless = scene;
  weightless.bodies[0].shapes[0].surface.density = 0;
  EXPECT_THAT(common_refusal(weightless), AllOf(HasSubstr("mass"), HasSubstr("\"box\"")));
  Scene moving_ground = scene;
  moving_ground.bodies[0].shapes[0].geometry = HalfSpace{};
  EXPECT_THAT(common_refusal(moving_ground), AllOf(HasSubstr("half-space"), HasSubstr("\"box\"")));
}

struct NoCircles {
  std::string operator()(const Circle&) const { return "no circles"; }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

TEST(GeometryRefusal, IsTheFirstReasonOfAnyShape) {
  Scene scene;
  scene.bodies = {box({})};
  EXPECT_EQ(geometry_refusal(scene, NoCircles{}), "");
  scene.bodies[0].shapes.push_back({Circle{}, {}});
  EXPECT_EQ(geometry_refusal(scene, NoCircles{}), "no circles");
}

// Counter-clockwise from the x axis of its frame, the edge's normal is that of the half-space.
TEST(HalfSpaceEdge, LiesAlongTheBoundary) {
  Body ground = box({});
  ground.angle = .2;
  const HalfSpaceEdge edge = edge_of(ground, HalfSpace{.normal = {-std::sin(.3), std::cos(.3)}, .offset = 4}, 100);
  EXPECT_DOUBLE_EQ(edge.angle, .5);
  EXPECT_EQ(edge.segment.from, (Vec{100, 4}));
  EXPECT_EQ(edge.segment.to, (Vec{-100, 4}));
}

Body disc(Vec position, double radius = 1) {
  Body body;
  body.position = position;
  body.shapes.push_back({Circle{radius, {}}, {}});
  return body;
}

constexpr double m = std::numbers::pi;  // kg, of a disc of radius 1

TEST(Loads, AttractByInversePowersAndPushBackIfMutual) {
  Scene scene;
  scene.bodies = {disc({0, 0}), disc({2, 0})};
  scene.forces = {Attraction{0, 8, 2, false}};
  const std::vector<BodyState> states{{{0, 0}}, {{2, 0}}};
  Loads one_way(scene);
  EXPECT_DOUBLE_EQ(one_way.at(states)[1].force.x, -m * 8 / 4);
  EXPECT_EQ(one_way.at(states)[0].force, Vec{});
  scene.forces = {Attraction{0, 8, 2, true}};
  Loads mutual(scene);
  EXPECT_DOUBLE_EQ(mutual.at(states)[0].force.x, m * 8 / 4);
}

TEST(Loads, PullWithSpringsAlongTheLineOfTheirAnchors) {
  Scene scene;
  scene.bodies = {disc({0, 0}), disc({5, 0})};
  scene.forces = {Spring{0, 1, {0, 1}, {0, 1}, 10, 3, 2}};
  const std::vector<BodyState> states{{{0, 0}}, {{5, 0}, 0, {.5, 0}, 0}};
  Loads loads(scene);
  const std::span<const Load> at = loads.at(states);
  EXPECT_DOUBLE_EQ(at[0].force.x, 10 * (5 - 3) + 2 * .5);
  EXPECT_DOUBLE_EQ(at[1].force.x, -21);
  EXPECT_DOUBLE_EQ(at[0].torque, -21);  // at an arm of 1 m upwards
  EXPECT_DOUBLE_EQ(at[1].torque, 21);
}

// The anchor belongs to the body's frame, whose origin need not be the centre of mass.
TEST(Loads, MeasureAnchorsFromTheCentreOfMass) {
  Body body = disc({0, 0});
  body.shapes[0].geometry = Circle{1, {2, 0}};
  Scene scene;
  scene.bodies = {body};
  scene.forces = {Spring{{}, 0, {0, 5}, {0, 0}, 1, 0, 0}};
  Loads loads(scene);
  const Load load = loads.at(std::vector<BodyState>{{{2, 0}}})[0];
  EXPECT_DOUBLE_EQ(load.force.x, 0);
  EXPECT_DOUBLE_EQ(load.force.y, 5);
  EXPECT_DOUBLE_EQ(load.torque, -2 * 5);
}

TEST(Loads, AddUp) {
  Scene scene;
  scene.bodies = {disc({0, 0})};
  scene.forces = {Constant{0, {1, 2}, 3}, Constant{0, {10, 20}, 30}};
  Loads loads(scene);
  const Load load = loads.at(std::vector<BodyState>(1))[0];
  EXPECT_EQ(load.force, (Vec{11, 22}));
  EXPECT_EQ(load.torque, 33);
}

// A table on a path, and a ball far from it.
Scene scene_on_path() {
  Body table = plumb::box("table", {1, 2}, {2, 1}, {});
  table.type = BodyType::kinematic;
  table.velocity = {0.5, 0};
  table.path = Path{.amplitude = {0.1, 0.3}, .frequency = 0.8, .phase = 0.4};
  return {.name = "path", .bodies = {table, plumb::disc("ball", {50, 0}, 0.5, {})}};
}

TEST(Path, BeginsWhereTheBodyIsAndHasTheDerivativeThatItStates) {
  const Path path = *scene_on_path().bodies[0].path;
  EXPECT_EQ(path_offset(path, 0), Vec{});
  constexpr double h = 1e-6;
  const Vec start = start_velocity(scene_on_path().bodies[0]);
  EXPECT_NEAR(start.x, 0.5 + path_offset(path, h).x / h, 1e-5);
  EXPECT_NEAR(start.y, path_offset(path, h).y / h, 1e-5);
  EXPECT_NEAR(path_offset(path, 1 / 0.8).y, 0, 1e-15) << "after a period";
}

TEST(Paths, TakeABodyOfEveryEngineExactlyWhereTheyLead) {
  const Scene on_path = scene_on_path();
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (engine->exact || !engine->unsupported(on_path, complete(*engine, {})).empty()) continue;
    const auto simulation = engine->build(on_path, complete(*engine, {}));
    const double epsilon = engine->stepping(complete(*engine, {}), 1.0 / 60).epsilon;
    std::vector<BodyState> states(2);
    simulation->read(states);
    EXPECT_NEAR(states[0].velocity.y, start_velocity(on_path.bodies[0]).y, 1e-6) << engine->name;
    double t = 0;
    for (int i = 0; i < 100; ++i) {
      const double dt = i % 2 == 0 ? 1.0 / 60 : 1.0 / 100;
      simulation->step(dt);
      t += dt;
      simulation->read(states);
      const Vec offset = path_offset(*on_path.bodies[0].path, t);
      EXPECT_NEAR(states[0].position.x, 1 + 0.5 * t + offset.x, 8 * (i + 1) * epsilon + 1e-12) << engine->name;
      EXPECT_NEAR(states[0].position.y, 2 + offset.y, 8 * (i + 1) * epsilon + 1e-12) << engine->name;
    }
  }
}

TEST(Paths, LeaveOtherScenesAlone) {
  Scene plain = scene_on_path();
  plain.bodies[0].path.reset();
  const Engine& engine = *Catalog<Engine>::find("impulse");
  auto simulation = engine.build(plain, complete(engine, {}));
  const Simulation* made = simulation.get();
  EXPECT_EQ(on_paths(plain, std::move(simulation)).get(), made);
}

}  // namespace
}  // namespace plumb::adapter_test
