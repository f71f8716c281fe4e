#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::slope_disc {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s

Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double radius = p.at("radius");
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{
      .name = "slope-disc", .about = "A disc is released on a slope.", .gravity = {0, -gravity}, .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  scene.bodies[0].angle = angle;
  scene.bodies.push_back(disc("disc", {-radius * std::sin(angle), radius * std::cos(angle)}, radius, rough));
  return scene;
}

// Rolls with acceleration (2/3) g sin a iff mu >= tan(a)/3; otherwise slips with g (sin a - mu cos a) and spins up with
// 2 mu g cos(a)/r.
// Contact may be found a lag late, after which all velocities are right again. A contact point that is off by the gap
// changes the lever arm: a disc that rolls has the acceleration g sin a/(1 + r^2/(2 arm^2)) and gains spin by
// g sin a/(arm + r^2/(2 arm)), which are off by 4/9 g sin a gap/r and 2/9 g sin a gap/r^2; of one that slips the spin
// alone is off, by gap/r of itself. While the disc sinks in by the slop at a speed u, the contact has given m u less
// impulse, and friction mu times that less: a distance of mu slop is missing. Where contact points are held for a step,
// the disc sinks in by rolls_in besides, and friction is missing for as long as it is unpressed. A rolling disc may
// creep, by the share of its friction in gravity.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double mu = p.at("friction");
  const double radius = p.at("radius");
  const bool rolls = mu >= std::tan(angle) / 3;
  const double friction = rolls ? gravity * std::sin(angle) / 3 : mu * gravity * std::cos(angle);
  const double acceleration = gravity * std::sin(angle) - friction;
  const double reach = radius + gravity * duration * duration;
  const double pull = gravity * std::sin(angle);
  const double fastest = 2 * friction * duration / radius;  // rad/s
  const auto creep = [=](const Stepping& s) { return rolls ? s.creep * friction / gravity : 0; };
  const auto gap = [=](const Stepping& s) { return s.contact_gap() + rolls_in(s, radius, fastest); };
  const auto missing = [=](const Stepping& s) {
    return (rolls ? 0 : still_sinking(s, mu, duration)) +
           friction * unpressed(s, radius, fastest, gravity * std::cos(angle));
  };
  const auto speed = [=](const Stepping& s) {
    const double arm = rolls ? 4.0 / 9 * pull * gap(s) / radius : 0;
    return arm * duration + creep(s) + missing(s) + round_off(s, duration, reach);
  };
  const auto place = [=](const Stepping& s) {
    return speed(s) * duration + drifted(s, acceleration, duration) + gap(s) + mu * s.slop + slid_late(s, pull);
  };
  const auto spin = [=](const Stepping& s) {
    const double arm = (rolls ? 2.0 / 9 * pull : 2 * friction) * gap(s) / (radius * radius);
    return arm * duration + 2 / radius * missing(s) + round_off(s, duration, reach / radius);
  };
  const auto turn = [=](const Stepping& s) {
    return spin(s) * duration + 2 / radius * (drifted(s, friction, duration) + mu * s.slop + slid_late(s, friction));
  };
  const std::string law = rolls ? "(2/3) g sin a t" : "g (sin a - mu cos a) t";
  return {
      {.body = "disc", .quantity = Quantity::speed, .allowed = speed, .source = law + "; lever arm off by the gap"},
      {.body = "disc", .quantity = Quantity::x, .allowed = place, .source = law + "; contact a lag late, drift, gap"},
      {.body = "disc", .quantity = Quantity::y, .allowed = place, .source = law + "; contact a lag late, drift, gap"},
      {.body = "disc", .quantity = Quantity::angular_velocity, .allowed = spin, .source = "2 f t/r"},
      {.body = "disc", .quantity = Quantity::angle, .allowed = turn, .source = "f t^2/r"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "slope-disc",
     .question = "Does a disc roll down a slope with two thirds of the acceleration of a frictionless slider, and slip "
                 "if friction is too weak?",
     .parameters = {{.name = "angle", .value = 20, .min = 1, .max = 60, .unit = "deg", .about = "of the slope"},
                    {.name = "friction", .value = 0.5, .min = 0, .max = 2, .about = "of disc and slope"},
                    {.name = "radius", .value = 0.5, .min = 0.1, .max = 2, .unit = "m", .about = "of the disc"}},
     .variants = {{"rolls", {}}, {"slips", {{"angle", 40}, {"friction", 0.1}}}},
     .closed_form = "roll",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::slope_disc

namespace plumb::scenarios::slip_to_roll {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double radius = 0.5;  // m

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "slip-to-roll",
              .about = "A disc is thrown along the ground without spin, like a bowling ball.",
              .gravity = {0, -gravity},
              .duration = std::ceil(p.at("speed") / (3 * p.at("friction") * gravity)) + 1};
  scene.bodies.push_back(level_ground(rough));
  Body ball = disc("disc", {0, radius}, radius, rough);
  ball.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(ball);
  return scene;
}

// Friction has no moment about a point of the ground, so the disc ends with 2 v/3 whatever the course of friction. Only
// the lever arm matters: a contact point that is off by the gap makes that speed v/(1 + r^2/(2 arm^2)) and the spin
// v/(arm + r^2/(2 arm)), which differ by 4/9 v gap/r and 2/9 v gap/r^2. Where contact points are held for a step, the
// gap is what the rolling disc sinks in besides. Where the disc ends depends on more: the
// contact may be found a lag late; it drifts with the loss of v/3 and the gain of spin; and it is off in speed and spin
// from when it rolls, in spin also for half of the time until then.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double end = scene(p).duration;
  const double slips = v / (3 * p.at("friction") * gravity);  // s, for how long
  const auto gap = [=](const Stepping& s) { return s.contact_gap() + rolls_in(s, radius, 2 * v / (3 * radius)); };
  const auto speed = [=](const Stepping& s) { return 4.0 / 9 * v * gap(s) / radius + round_off(s, end, v); };
  const auto spin = [=](const Stepping& s) {
    return 2.0 / 9 * v * gap(s) / (radius * radius) + round_off(s, end, v / radius);
  };
  const auto late = [=, mu = p.at("friction")](const Stepping& s) {
    return v / 3 * std::abs(s.drift) * s.h + mu * s.slop + slid_late(s, mu * gravity);
  };
  const auto place = [=](const Stepping& s) { return late(s) + speed(s) * (end - slips) + round_off(s, end, v * end); };
  const auto turn = [=](const Stepping& s) {
    const double arm = gap(s) / radius * v / (3 * radius) * slips;
    return 2 / radius * late(s) + arm + spin(s) * (end - slips) + round_off(s, end, v * end / radius);
  };
  return {{.body = "disc",
           .quantity = Quantity::vx,
           .allowed = speed,
           .source = "2 v/3, whatever the course of friction; lever arm off by the gap"},
          {.body = "disc",
           .quantity = Quantity::angular_velocity,
           .allowed = spin,
           .source = "-2 v/(3 r), whatever the course of friction; lever arm off by the gap"},
          {.body = "disc",
           .quantity = Quantity::x,
           .allowed = place,
           .source = "rolls after v/(3 mu g); contact a lag late, drift, lever arm"},
          {.body = "disc", .quantity = Quantity::angle, .allowed = turn, .source = "rolls after v/(3 mu g)"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "slip-to-roll",
     .question = "Does a disc thrown without spin end up rolling at two thirds of its speed?",
     .parameters = {{.name = "speed", .value = 6, .min = 0.5, .max = 30, .unit = "m/s", .about = "at the start"},
                    {.name = "friction", .value = 0.3, .min = 0.05, .max = 2, .about = "of disc and ground"}},
     .variants = {{"mu=0.3", {}}, {"mu=0.1", {{"friction", 0.1}}}},
     .closed_form = "roll",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::slip_to_roll

namespace plumb::scenarios::pushed_plank {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 1;  // s
constexpr double radius = 0.5;  // m
const Vec plank{20, 0.5};       // m; longer than any disc falls behind in that time

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "pushed-plank",
              .about = "A disc lies on a plank that is pushed along a frictionless floor.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(surface(0, 0)));
  scene.bodies.push_back(box("plank", {0, plank.y / 2}, plank, rough));
  scene.bodies.push_back(disc("disc", {0, plank.y + radius}, radius, rough));
  const double mass = mass_of(scene.bodies[1]).mass + mass_of(scene.bodies[2]).mass;
  scene.forces.push_back(Constant{.body = 1, .force = {mass * p.at("push"), 0}});
  return scene;
}

// Rolls with f = m A/3, A = F/(M + m/3), as long as that is at most mu m g; otherwise slips with f = mu m g. The
// contact may be found a lag late, after which all velocities are right again; that with the floor may open and close
// meanwhile, but has no friction to matter. A contact point that is off by the gap changes the
// lever arm. A rolling disc has a = A/(1 + 2 arm^2/r^2) and the spin 2 a arm/r^2, which are off by 4/3 gap/r and 1/3
// gap/r of themselves; of one that slips the spin alone, by gap/r. Where contact points are held for a step, it sinks
// in and is unpressed as on a slope. It may creep, by the share of its friction in gravity.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene pushed = scene(p);
  const double disc_mass = mass_of(pushed.bodies[2]).mass;
  const double plank_mass = mass_of(pushed.bodies[1]).mass;
  const double pull = (plank_mass + disc_mass) * p.at("push");
  const double rolling = pull / (plank_mass + disc_mass / 3) / 3;  // m/s^2, of the disc
  const double most = p.at("friction") * gravity;
  const bool rolls = rolling <= most;
  const double body = rolls ? rolling : most;
  const double board = (pull - disc_mass * body) / plank_mass;
  const double mu = p.at("friction");
  const double fastest = 2 * body * duration / radius;  // rad/s
  const auto gap = [=](const Stepping& s) { return s.contact_gap() + rolls_in(s, radius, fastest); };
  const auto missing = [=](const Stepping& s) {  // m/s, of the disc
    return (rolls ? 0 : still_sinking(s, mu, duration)) + body * unpressed(s, radius, fastest, gravity);
  };
  const auto late = [=](const Stepping& s, double per_mass) {
    const double arm = rolls ? 4.0 / 3 * gap(s) / radius : 0;
    const double creep = rolls ? s.creep * body / gravity : 0;
    return per_mass * arm * duration + creep + (body > 0 ? per_mass / body * missing(s) : 0) +
           round_off(s, duration, board * duration);
  };
  const auto disc_speed = [=](const Stepping& s) { return late(s, body); };
  const auto plank_speed = [=](const Stepping& s) { return late(s, body * disc_mass / plank_mass); };
  const auto spin = [=](const Stepping& s) {
    const double arm = (rolls ? 1.0 / 3 : 1) * gap(s) / radius;
    return 2 / radius * (body * arm * duration + missing(s) + round_off(s, duration, board * duration));
  };
  const auto distance = [=](const Stepping& s, double speed, double acceleration) {
    return speed * duration + drifted(s, acceleration, duration) + slid_late(s, acceleration) + mu * s.slop +
           round_off(s, duration, plank.x);
  };
  const auto disc_place = [=](const Stepping& s) { return distance(s, disc_speed(s), body); };
  const auto plank_place = [=](const Stepping& s) { return distance(s, plank_speed(s), board); };
  const auto turn = [=](const Stepping& s) { return spin(s) * duration + 2 / radius * distance(s, 0, body); };
  const std::string law = rolls ? "rolls: a = A/3, A = F/(M + m/3)" : "slips: a = mu g, A = (F - mu m g)/M";
  return {
      {.body = "disc", .quantity = Quantity::vx, .allowed = disc_speed, .source = law + "; lever arm off by the gap"},
      {.body = "disc", .quantity = Quantity::angular_velocity, .allowed = spin, .source = law + ", w' = 2 a/r"},
      {.body = "disc", .quantity = Quantity::x, .allowed = disc_place, .source = law + "; contact a lag late, drift"},
      {.body = "disc", .quantity = Quantity::angle, .allowed = turn, .source = law + "; contact a lag late, drift"},
      {.body = "plank", .quantity = Quantity::vx, .allowed = plank_speed, .source = law + "; lever arm off by the gap"},
      {.body = "plank",
       .quantity = Quantity::x,
       .allowed = plank_place,
       .source = law + "; contact a lag late, drift"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "pushed-plank",
     .question = "Does a disc on a pushed plank follow with a third of the plank's acceleration, and slip if it is "
                 "pushed too hard?",
     .parameters = {{.name = "push",
                     .value = 3,
                     .min = 0.1,
                     .max = 15,
                     .unit = "m/s^2",
                     .about = "force on the plank divided by the mass of plank and disc"},
                    {.name = "friction", .value = 0.3, .min = 0, .max = 2, .about = "of disc and plank"}},
     .variants = {{"rolls", {}}, {"slips", {{"push", 6}, {"friction", 0.1}}}},
     .closed_form = "plank",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::pushed_plank
