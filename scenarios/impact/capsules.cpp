#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::capsules {
namespace {

constexpr double duration = 1;   // s
constexpr double radius = 0.25;  // m, of both capsules
constexpr double half = 0.75;    // m, from a capsule's centre to that of its cap
constexpr double apart = 0.83;   // m between the two at the start

Body capsule(std::string name, Vec position, double angle, Surface of) {
  return {.name = std::move(name),
          .position = position,
          .angle = angle,
          .shapes = {{.geometry = Capsule{{-half, 0}, {half, 0}, radius}, .surface = of}}};
}

// The upper one is upright and hits with its lower end.
Scene scene(const Parameters& p) {
  const Surface smooth = surface(0, p.at("restitution"));
  Scene scene{.name = "capsules",
              .about = "A capsule hits the side of another with its end, without friction or gravity.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(capsule("struck", {0, 0}, 0, smooth));
  scene.bodies.push_back(capsule("falling", {p.at("offset"), 2 * radius + half + apart}, 90 * degree,
                                 surface(0, p.at("restitution"), p.at("ratio"))));
  scene.bodies.back().velocity = {0, -p.at("speed")};
  return scene;
}

// s after the impact during which the two surely stay apart; 0 if for less than `shortest`. The struck one leaves the
// other's cap at e v and turns at w, at a distance c from where it was hit. With the relative velocity V of the
// centres, the cap is (2 r + V t) cos(w t) + c sin(w t) from its axis, 2 r if they touch, and the rest of the other is
// farther up until it has turned by a right angle.
double clear_for(double v, double w, double c) {
  constexpr double shortest = 0.1;  // s, some steps, whenever the impact is noticed
  constexpr double grid = 1e-3;     // s
  const double quarter = w > 0 ? std::numbers::pi / 2 / w : duration;
  const auto apart_at = [=](double t) { return (2 * radius + v * t) * std::cos(w * t) + c * std::sin(w * t); };
  double t = 0;
  while (t + grid < quarter && apart_at(t + grid) > 2 * radius) t += grid;
  return t < shortest ? 0 : t;
}

// The push is vertical, through the upper centre and at the arm c from the lower one: J = (1+e) v/(1/m_a + 1/m_b +
// c^2/I_b). Velocities do not depend on when the impact is noticed, as nothing turns before. Positions are off by the
// velocity jump times the lag, and by the penetration, v lag, and the skin, that may be corrected: the struck one's
// side turns by at most that over its gyration radius.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene start = scene(p);
  const Mass struck = mass_of(start.bodies[0]);
  const Mass falling = mass_of(start.bodies[1]);
  const double v = p.at("speed");
  const double e = p.at("restitution");
  const double c = p.at("offset");
  const double push = (1 + e) * v / (1 / struck.mass + 1 / falling.mass + c * c / struck.inertia);
  const double spin = -c * push / struck.inertia;
  const double leaves = e * v + c * spin;  // m/s, upper centre from the lower one
  const double clear = clear_for(leaves, std::abs(spin), std::abs(c));
  if (clear == 0) return {};  // they meet again, and where the first impact would lead nobody sees
  const double after = std::min(duration - apart / v, 0.9 * clear);  // s
  const double time = apart / v + after;
  const double gyration = std::sqrt(struck.inertia / struck.mass);
  const double reach = 2 + v + std::abs(spin);
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach); };
  const auto place = [=](const Stepping& s) { return (2 + e) * v * lag(s) + s.contact_gap() + exact(s); };
  const auto turn = [=](const Stepping& s) {
    return std::abs(spin) * lag(s) + (v * lag(s) + s.contact_gap()) / gyration + exact(s);
  };
  std::vector<Expectation> all{
      {.body = "falling",
       .quantity = Quantity::vy,
       .expected = push / falling.mass - v,
       .allowed = exact,
       .source = "J/m - v"},
      {.body = "struck", .quantity = Quantity::vy, .expected = -push / struck.mass, .allowed = exact, .source = "J/m"},
      {.body = "struck", .quantity = Quantity::angular_velocity, .expected = spin, .allowed = exact, .source = "c J/I"},
      {.body = "falling",
       .quantity = Quantity::angular_velocity,
       .expected = 0,
       .allowed = exact,
       .source = "struck through its centre"},
      {.body = "struck",
       .quantity = Quantity::y,
       .expected = -push / struck.mass * after,
       .allowed = place,
       .source = "the velocity jump times the lag, and the penetration"},
      {.body = "struck",
       .quantity = Quantity::angle,
       .expected = spin * after,
       .allowed = turn,
       .source = "the velocity jump times the lag, and the penetration"}};
  for (Expectation& one : all) one.time = time;
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "capsules",
     .question = "Does a capsule struck on its side by another's end get the right spin?",
     .parameters = {{.name = "offset",
                     .value = 0.5,
                     .min = -0.7,
                     .max = 0.7,
                     .unit = "m",
                     .about = "of the impact from the centre"},
                    {.name = "speed", .value = 2, .min = 1.5, .max = 20, .unit = "m/s", .about = "of the approach"},
                    {.name = "ratio",
                     .value = 3,
                     .min = 0.1,
                     .max = 100,
                     .about = "mass of the falling capsule divided by that of the struck one"},
                    {.name = "restitution", .value = 0.6, .min = 0, .max = 1, .about = "of both"}},
     .variants = {{"off centre", {}}, {"centred", {{"offset", 0}}}, {"e=1", {{"offset", -0.3}, {"restitution", 1}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::capsules

namespace plumb::scenarios::capsule_heap {
namespace {

constexpr double duration = 3;                                       // s
constexpr double pitch = 2.1 * (capsules::half + capsules::radius);  // m, room for a capsule at any angle

// The lower capsule lies, the upper ones fall on it, each turned from the last.
Scene scene(const Parameters& p) {
  const Surface of = surface(p.at("friction"), p.at("restitution"));
  Scene scene{.name = "capsule-heap", .about = "Capsules fall on one another.", .duration = duration};
  scene.bodies.push_back(pit(4, of));
  for (int i = 0; i < static_cast<int>(p.at("count")); ++i) {
    const double across = i == 0 ? 0 : p.at("offset") * (i % 2 == 0 ? -1 : 1);
    scene.bodies.push_back(capsules::capsule("capsule " + std::to_string(i + 1), {across, capsules::radius + i * pitch},
                                             i * p.at("turn") * degree, of));
  }
  return scene;
}

const Catalog<Scenario>::Entry entry{
    {.name = "capsule-heap",
     .question = "Do capsules that fall on one another come to lie without gaining energy?",
     .parameters =
         {{.name = "count", .value = 6, .min = 2, .max = 40, .about = "capsules", .whole = true},
          {.name = "offset", .value = 0.2, .min = 0, .max = 0.7, .unit = "m", .about = "to the side, in turns"},
          {.name = "turn", .value = 25, .min = 0, .max = 90, .unit = "deg", .about = "from one to the next"},
          {.name = "friction", .value = 0.4, .min = 0, .max = 2, .about = "of all"},
          {.name = "restitution", .value = 0.1, .min = 0, .max = 1, .about = "of all"}},
     .variants = {{"two", {{"count", 2}, {"turn", 0}}},
                  {"smooth", {{"count", 2}, {"offset", 0.7}, {"turn", 75}, {"friction", 0}, {"restitution", 0.2}}},
                  {"six", {}}},
     .scene = scene,
     .expectations = [](const Parameters&) { return std::vector<Expectation>{}; }}};

}  // namespace
}  // namespace plumb::scenarios::capsule_heap
