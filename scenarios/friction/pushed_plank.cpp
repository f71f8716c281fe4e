#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::pushed_plank {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 1;  // s
constexpr double radius = 0.5;  // m
const Vec plank{20, 0.5};       // m; longer than any disc falls behind in that time

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "pushed-plank",
              .about = "A disc lies on a plank that is pushed along a floor without friction.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(surface(0, 0)));
  scene.bodies.push_back(box("plank", {0, plank.y / 2}, plank, rough));
  scene.bodies.push_back(disc("disc", {0, plank.y + radius}, radius, rough));
  const double mass = mass_of(scene.bodies[1]).mass + mass_of(scene.bodies[2]).mass;
  scene.forces.push_back(Constant{.body = 1, .force = {mass * p.at("push"), 0}});
  return scene;
}

// Rolls with f = m A/3, A = F/(M + m/3), while that is within mu m g; else slips with f = mu m g. The contact may be
// noticed a lag late: f is missing so long, from the disc and for the plank; and the contact on the floor may open and
// close meanwhile, without friction to matter. A point of contact off by the gap makes the arm, and with it the share
// of a rolling disc, off by gap/r.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene asked = scene(p);
  const double disc_mass = mass_of(asked.bodies[2]).mass;
  const double plank_mass = mass_of(asked.bodies[1]).mass;
  const double pull = (plank_mass + disc_mass) * p.at("push");
  const double rolling = pull / (plank_mass + disc_mass / 3) / 3;  // m/s^2, of the disc
  const double most = p.at("friction") * gravity;
  const bool rolls = rolling <= most;
  const double body = rolls ? rolling : most;
  const double board = (pull - disc_mass * body) / plank_mass;
  const auto loose = [=](const Stepping& s, double per_mass) {
    return per_mass * (lag(s) + s.gap / radius * duration) + s.creep + round_off(s, duration, board * duration);
  };
  const auto disc_speed = [=](const Stepping& s) { return loose(s, body); };
  const auto plank_speed = [=](const Stepping& s) { return loose(s, body * disc_mass / plank_mass); };
  const auto spin = [=](const Stepping& s) { return 2 * disc_speed(s) / radius; };
  const auto way = [=](const Stepping& s, double speed, double acceleration) {
    return speed * duration + drifted(s, acceleration, duration) + round_off(s, duration, plank.x);
  };
  const auto disc_place = [=](const Stepping& s) { return way(s, disc_speed(s), body); };
  const auto plank_place = [=](const Stepping& s) { return way(s, plank_speed(s), board); };
  const auto turn = [=](const Stepping& s) { return 2 * disc_place(s) / radius; };
  const std::string law = rolls ? "rolls: a = A/3, A = F/(M + m/3)" : "slips: a = mu g, A = (F - mu m g)/M";
  return {{.body = "disc", .quantity = Quantity::vx, .allowed = disc_speed, .source = law + "; friction a lag late"},
          {.body = "disc", .quantity = Quantity::angular_velocity, .allowed = spin, .source = law + ", w' = 2 a/r"},
          {.body = "disc", .quantity = Quantity::x, .allowed = disc_place, .source = law + "; a lag late, drift"},
          {.body = "disc", .quantity = Quantity::angle, .allowed = turn, .source = law + "; a lag late, drift"},
          {.body = "plank", .quantity = Quantity::vx, .allowed = plank_speed, .source = law + "; friction a lag late"},
          {.body = "plank", .quantity = Quantity::x, .allowed = plank_place, .source = law + "; a lag late, drift"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "pushed-plank",
     .question =
         "Does a disc on a pushed plank follow with a third of its acceleration, and slip when pushed too hard?",
     .parameters = {{.name = "push",
                     .value = 3,
                     .min = 0.1,
                     .max = 15,
                     .unit = "m/s^2",
                     .about = "force on the plank over the mass of plank and disc"},
                    {.name = "friction", .value = 0.3, .min = 0, .max = 2, .about = "of disc and plank"}},
     .variants = {{"rolls", {}}, {"slips", {{"push", 6}, {"friction", 0.1}}}},
     .closed_form = "plank",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::pushed_plank
