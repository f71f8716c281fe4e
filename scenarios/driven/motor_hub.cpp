#include <cmath>
#include <numbers>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

// Many hinges of one body, with motors and stops.
namespace plumb::scenarios::motor_hub {
namespace {

constexpr double duration = 3;  // s
constexpr double hub_radius = 2;
constexpr double reach = 1.6;         // m, from the hub's centre to the hinges
constexpr double wheel_radius = .15;  // m

int wheels(const Parameters& p) { return 2 * static_cast<int>(p.at("pairs")); }

double direction(int wheel) { return wheel % 2 == 0 ? 1 : -1; }

// The hub floats, and of two neighbouring wheels one turns to the left and one to the right.
Scene scene(const Parameters& p) {
  Scene scene{.name = "motor-hub",
              .about = "Motors on a hub that floats spin wheels, half of them to the left and half to the right.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(disc("hub", {0, 0}, hub_radius, {}));
  for (int i = 0; i < wheels(p); ++i) {
    const double angle = 2 * std::numbers::pi * i / wheels(p);
    const Vec at{reach * std::cos(angle), reach * std::sin(angle)};
    scene.bodies.push_back(disc("wheel " + std::to_string(i + 1), at, wheel_radius, {}));
    Revolute hinge{.a = 0,
                   .b = scene.bodies.size() - 1,
                   .anchor = at,
                   .motor = Motor{direction(i) * p.at("speed"), p.at("torque")}};
    if (p.at("stop") > 0) hinge.limits = Limits{-p.at("stop") * degree, p.at("stop") * degree};
    scene.joints.push_back(hinge);
  }
  for (Body& body : scene.bodies) body.layers = 0;
  return scene;
}

// The torques on the hub cancel, so it stays, and each wheel turns as the one of `motor`: w = (tau/I) t until the
// motor's speed; or it reaches its stop, has no restitution there and stays. Off by
//   drift     a t h while the wheel gains speed;
//   chord     a dt^2/8 between two steps, and in the one that reaches the speed, as for `motor`;
//   stop      what the method leaves of an angle past the limit, and a/(2 pi f)^2 where joints are springs;
//   iteration where a motor needs less than its torque, a method that solves one hinge after another may leave one
//             wheel's change of a step, I a h, to the hub, which turns by that over its inertia from then on, and the
//             wheel with it;
//   round-off places of the hinges are rounded, so their directions from the hub's centre by an epsilon, and their
//             velocities by w times that, and the hub takes the share m r^2/I of both, of all wheels.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene made = scene(p);
  const double inertia = mass_of(made.bodies[1]).inertia;
  const double hub = mass_of(made.bodies[0]).inertia;
  const double a = p.at("torque") / inertia;
  const double speed = p.at("speed");
  const double gains = std::min(duration, speed / a);
  const double free = a * gains * (duration - gains / 2);
  const double stop = p.at("stop") * degree;
  const bool stopped = stop > 0 && free > stop;
  const double turned = stopped ? stop : free;
  const double last = stopped ? 0 : a * gains;

  const auto round = [=](const Stepping& s) { return round_off(s, duration, free + speed + reach); };
  const double share = wheels(p) * mass_of(made.bodies[1]).mass * reach * reach / hub;
  const auto unsolved = [=](const Stepping& s) { return s.iterations > 0 ? inertia * a * s.h / hub : 0; };
  const auto spin = [=](const Stepping& s) { return round(s) + unsolved(s); };
  const auto still = [=](const Stepping& s) {
    return round_off(s, duration, share * (1 + speed * duration)) + unsolved(s) * duration;
  };
  const auto angle = [=](const Stepping& s) {
    if (stopped) return s.angular_slop + spring_depth(s.joint_frequency, a, 1) + round(s) + still(s);
    return drifted(s, a, gains) + a * s.dt * s.dt / 8 + round(s) + still(s);
  };
  const double early = std::min(gains, stop > 0 ? std::sqrt(2 * stop / a) : duration) / 2;
  const auto on_the_way = [=](const Stepping& s) {
    return drifted(s, a, early) + a * s.dt * s.dt / 8 + round(s) + still(s);
  };
  const char* at_stop = "at rest at the stop; what the method leaves beyond it";
  std::vector<Expectation> all{
      {.body = "hub", .quantity = Quantity::angle, .expected = 0, .allowed = still, .source = "the torques cancel"},
      {.body = "hub",
       .quantity = Quantity::angular_velocity,
       .expected = 0,
       .allowed = [=](const Stepping& s) { return round_off(s, duration, share * (1 + speed)) + unsolved(s); },
       .source = "likewise"}};
  for (const int wheel : {0, wheels(p) / 2, wheels(p) - 1}) {
    const std::string name = made.bodies[static_cast<std::size_t>(wheel) + 1].name;
    all.push_back({.body = name,
                   .quantity = Quantity::angle,
                   .time = early,
                   .expected = direction(wheel) * a * early * early / 2,
                   .allowed = on_the_way,
                   .source = "tau t^2/(2 I); the method's drift"});
    all.push_back({.body = name,
                   .quantity = Quantity::angle,
                   .expected = direction(wheel) * turned,
                   .allowed = angle,
                   .source = stopped ? at_stop : "tau t^2/(2 I), then speed t; the method's drift"});
    all.push_back({.body = name,
                   .quantity = Quantity::angular_velocity,
                   .expected = direction(wheel) * last,
                   .allowed = spin,
                   .source = stopped ? at_stop : "tau t/I, then the motor's speed; round-off"});
    all.push_back({.body = name,
                   .quantity = Quantity::x,
                   .expected = made.bodies[static_cast<std::size_t>(wheel) + 1].position.x,
                   .allowed = [=](const Stepping& s) { return reach * still(s) + s.joint_slop + round(s); },
                   .source = "held by a hub that stays"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "motor-hub",
     .question = "Do many motors and stops on one body that floats each do what one on the ground would?",
     .parameters =
         {{.name = "pairs", .value = 15, .min = 1, .max = 100, .about = "of wheels on the hub", .whole = true},
          {.name = "speed", .value = 4, .min = .5, .max = 10, .unit = "rad/s", .about = "of the motors"},
          {.name = "torque", .value = .002, .min = .001, .max = .1, .unit = "N m", .about = "the motors' largest"},
          {.name = "stop", .value = 0, .min = 0, .max = 170, .unit = "deg", .about = "of each wheel; 0: none"}},
     .variants = {{"spins", {}}, {"stops", {{"stop", 120}}}, {"200 wheels", {{"pairs", 100}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::motor_hub
