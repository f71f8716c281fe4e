#include <gtest/gtest.h>

#include "forged_runs.h"
#include "scenarios/scene/mass.h"

namespace plumb::bouncing_test {
namespace {

constexpr double dt = 0.001;
const Stepping exact{.dt = dt, .h = dt, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};

Scene disc_on_ground(double restitution, double friction = 0.5) {
  Scene scene = box_on_ground(friction);
  scene.bodies[1].shapes[0].geometry = Circle{.radius = 0.5};
  for (Body& body : scene.bodies) body.shapes[0].surface.restitution = restitution;
  return scene;
}

// A disc hits the ground at 1 m/s and leaves it.
Trace bounced(const Scene& scene, double separation) {
  const double impulse = mass_of(scene.bodies[1]).mass * (1 + separation);
  return forged(dt, {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5}, {0, separation}), {pushing(impulse)}}});
}

TEST(BouncingInvariant, HoldsADiscToItsCoefficient) {
  for (const double e : {0.0, 0.3, 1.0}) {
    const Scene scene = disc_on_ground(e);
    EXPECT_EQ(status("bouncing", scene, bounced(scene, e), exact), CheckStatus::held) << e;
    EXPECT_EQ(status("bouncing", scene, bounced(scene, e + 0.01), exact), CheckStatus::broken) << e;
    if (e == 0) continue;
    EXPECT_EQ(status("bouncing", scene, bounced(scene, e - 0.01), exact), CheckStatus::broken) << e;
  }
}

TEST(BouncingInvariant, LetsASlowImpactBeInelastic) {
  const Scene scene = disc_on_ground(0.3);
  Stepping slow = exact;
  slow.restitution_threshold = 1.1;
  EXPECT_EQ(status("bouncing", scene, bounced(scene, 0), slow), CheckStatus::held);
  EXPECT_EQ(status("bouncing", scene, bounced(scene, 0.3), slow), CheckStatus::held);
  EXPECT_EQ(status("bouncing", scene, bounced(scene, 0.31), slow), CheckStatus::broken);
}

// A disc comes at 2.4 m/s and hits the ground some time after a step of 1/60 s has begun; gravity has then added up to
// .16 m/s, and what is left of the step takes as much from the bounce.
CheckStatus bounced_under_gravity(double restitution, double time, const Stepping& stepping) {
  Scene scene = disc_on_ground(0.1);
  scene.gravity = {0, -9.8};
  const double left = stepping.dt - time;
  const double approach = 2.4 + 9.8 * time;
  const double start = 0.5 + 2.4 * time + 4.9 * time * time;
  const double end = 0.5 + restitution * approach * left - 4.9 * left * left;
  const double separation = restitution * approach - 9.8 * left;
  const double impulse = mass_of(scene.bodies[1]).mass * (1 + restitution) * approach;
  ContactState contact = pushing(impulse);
  contact.point = {0, 0};
  return status("bouncing", scene,
                forged(stepping.dt, {{box_at({0, start}, {0, -2.4})}, {box_at({0, end}, {0, separation}), {contact}}}),
                stepping);
}

TEST(BouncingInvariant, SeesASmallCoefficientUnderGravity) {
  constexpr double step = 1.0 / 60;
  Stepping stepping{.dt = step, .h = step, .drift = 0.5, .impact_lag = 1, .epsilon = 1e-16};
  for (const double time : {0.0, 0.3 * step, step}) {
    EXPECT_EQ(bounced_under_gravity(0.1, time, stepping), CheckStatus::held) << time;
  }
  EXPECT_EQ(bounced_under_gravity(0.17, 0, stepping), CheckStatus::held);  // looks like .1 at the end of the step
  EXPECT_EQ(bounced_under_gravity(0.12, step, stepping), CheckStatus::broken);
  EXPECT_EQ(bounced_under_gravity(0.25, 0.3 * step, stepping), CheckStatus::broken);
  EXPECT_EQ(bounced_under_gravity(0.09, 0, stepping), CheckStatus::broken);
  EXPECT_EQ(bounced_under_gravity(0, 0, stepping), CheckStatus::broken);
}

TEST(BouncingInvariant, FindsTheTimeOfAnImpactWhereAMethodSolvesForIt) {
  constexpr double step = 1.0 / 60;
  Stepping stepping{.dt = step, .h = step, .drift = 0, .impact_lag = 0, .epsilon = 1e-16};
  for (const double time : {0.0, 0.3 * step, step}) {
    EXPECT_EQ(bounced_under_gravity(0.1, time, stepping), CheckStatus::held) << time;
    EXPECT_EQ(bounced_under_gravity(0.1001, time, stepping), CheckStatus::broken) << time;
    EXPECT_EQ(bounced_under_gravity(0.0999, time, stepping), CheckStatus::broken) << time;
  }
}

// A contact beside the centre by x and below it by y couples friction to the normal velocity: with I = 1/6, x = y = 1/2
// and m = 1 it is B_nn = 5/2, B_nt = 3/2, so k = .6 mu.
TEST(BouncingInvariant, AllowsWhatHypothesesDisagreeAbout) {
  const auto hit = [](double separation, double friction) {
    Scene scene = box_on_ground(friction);
    for (Body& body : scene.bodies) body.shapes[0].surface.restitution = 0.5;
    ContactState contact = pushing((1 + separation) / 2.5);
    contact.point = {0.5, 0};
    // The velocity at the contact is that of the centre and 1/2 w: J and 3 J.
    const double j = contact.normal_impulse;
    const BodyState after{.position = {0, 0.5}, .velocity = {0, -1 + j}, .angular_velocity = 3 * j};
    return status("bouncing", scene, forged(dt, {{box_at({0, 0.5}, {0, -1})}, {{{}, after}, {contact}}}), exact);
  };
  EXPECT_EQ(hit(0.5, 0), CheckStatus::held);
  EXPECT_EQ(hit(0.55, 0), CheckStatus::broken);
  EXPECT_EQ(hit(0.55, 0.5), CheckStatus::held);
  EXPECT_EQ(hit(0.97, 0.5), CheckStatus::broken);  // (1 + .3)/(1 - .3)/2 = .929
  EXPECT_EQ(hit(0.29, 0.5), CheckStatus::held);    // (1 - .3)/(1 + .3)/2 = .269
  EXPECT_EQ(hit(0.24, 0.5), CheckStatus::broken);
  EXPECT_EQ(hit(0.95, 2), CheckStatus::held);  // k = 1.2: none of them says
}

// Of two inelastic contacts of a box the one hit last may push the other apart, but not both.
TEST(BouncingInvariant, KeepsOneContactOfAnInelasticGroupClosed) {
  const Scene scene = disc_on_ground(0);
  const auto landed = [&](double vy, double spin) {
    const double mass = mass_of(scene.bodies[1]).mass;
    ContactState left = pushing(mass * (1 + vy));
    left.point = {-0.5, 0};
    ContactState right = pushing(0);
    right.point = {0.5, 0};
    const BodyState after{.position = {0, 0.5}, .velocity = {0, vy}, .angular_velocity = spin};
    return status("bouncing", scene, forged(dt, {{box_at({0, 0.5}, {0, -1})}, {{{}, after}, {left, right}}}), exact);
  };
  EXPECT_EQ(landed(0, 0), CheckStatus::held);
  EXPECT_EQ(landed(0.5, 1), CheckStatus::held);
  EXPECT_EQ(landed(0.6, 1), CheckStatus::broken);
}

// The ground went up at 1 m/s and does so at .5 m/s in this step: the disc comes at 1.5 m/s.
TEST(BouncingInvariant, KnowsThatWhatIsOnAPathHasTheVelocityOfTheStep) {
  Scene scene = disc_on_ground(1, 0);
  scene.bodies[0].type = BodyType::kinematic;
  scene.bodies[0].path = Path{.amplitude = {0, 0.1}, .frequency = 1};
  const BodyState comes{.position = {0, 0.5}, .velocity = {0, -1}};
  const auto leaves_at = [&](double vy) {
    const BodyState leaves{.position = {0, 0.5}, .velocity = {0, vy}};
    const double impulse = mass_of(scene.bodies[1]).mass * (1 + vy);
    return status("bouncing", scene,
                  forged(dt, {{{BodyState{.velocity = {0, 1}}, comes}},
                              {{BodyState{.velocity = {0, 0.5}}, leaves}, {pushing(impulse)}}}),
                  exact);
  };
  EXPECT_EQ(leaves_at(2), CheckStatus::held);
  EXPECT_EQ(leaves_at(2.5), CheckStatus::broken) << "as of the velocity of the step before";
}

TEST(BouncingInvariant, SaysNothingWhereUnreportedImpulsesAct) {
  const Scene scene = disc_on_ground(0);
  Trace trace = forged(dt, {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5}, {0, 1}), {pushing(0.1)}}});
  EXPECT_EQ(status("bouncing", scene, trace, exact), CheckStatus::held);
}

TEST(BouncingInvariant, NeedsReportedContacts) {
  const Scene scene = disc_on_ground(0);
  const Trace trace = forged(dt, {{box_at({0, 0.5}, {0, -1})}, {box_at({0, 0.5}, {0, 1})}});
  EXPECT_EQ(status("bouncing", scene, trace, exact), CheckStatus::not_reported);
}

}  // namespace
}  // namespace plumb::bouncing_test
