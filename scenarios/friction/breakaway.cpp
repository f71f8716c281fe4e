#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::breakaway {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s
const Vec size{1, 0.5};         // m; low enough not to tip: mu < b/h = 2

Scene scene(const Parameters& p) {
  Surface rough = surface(p.at("static"), 0);
  rough.dynamic_friction = p.at("dynamic");
  Scene scene{.name = "breakaway",
              .about = "A box on level ground is pulled by more than sliding friction and less than sticking.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  Body pulled = box("box", {0, size.y / 2}, size, rough);
  pulled.velocity = {p.at("speed"), 0};
  scene.forces.push_back(Constant{.body = 1, .force = {p.at("pull") * mass_of(pulled).mass, 0}});
  scene.bodies.push_back(pulled);
  return scene;
}

// At rest it stays, pull <= mu_s g; on its way it is quicker all the time by pull - mu_d g > 0.
//   Friction may start a lag late: mu_d g lag of speed, for all of the way; at rest the pull has that long, and what it
//   moved is a step more until it is stopped. Place: the drift of its acceleration; sinking by the gap friction is late
//   by mu of it, and the box leans, one end in by the gap, which moves its centre by gap (height/length).
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double mu = v > 0 ? p.at("dynamic") : p.at("static");
  const double a = v > 0 ? p.at("pull") - p.at("dynamic") * gravity : 0;
  const double late = v > 0 ? mu * gravity : p.at("pull");  // m/s^2, while there is no friction
  const double end = duration;
  const double reach = v * end + gravity * end * end;
  const auto speed = [=](const Stepping& s) {
    return (v > 0 ? late * lag(s) : s.creep) + round_off(s, end, v + gravity * end);
  };
  const auto place = [=](const Stepping& s) {
    const double slid = v > 0 ? late * lag(s) * end : late * lag(s) * (lag(s) + s.h) + s.creep * end;
    return slid + drifted(s, a, end) + (mu + size.y / size.x) * s.gap + round_off(s, end, reach);
  };
  return {{.body = "box",
           .quantity = Quantity::vx,
           .expected = v + a * end,
           .allowed = speed,
           .source = "sticks up to mu_s, slides with mu_d; friction a lag late, or creep"},
          {.body = "box",
           .quantity = Quantity::x,
           .expected = v * end + a * end * end / 2,
           .allowed = place,
           .source = "(pull - mu_d g) t^2/2 beyond v t, or nothing; friction a lag late, drift, sinking"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "breakaway",
     .question = "Does a pull between sticking and sliding friction leave what rests and carry on what slides?",
     .parameters =
         {{.name = "static", .value = 0.6, .min = 0.55, .max = 1.5, .about = "coefficient of friction while sticking"},
          {.name = "dynamic", .value = 0.3, .min = 0, .max = 0.45, .about = "and while sliding"},
          {.name = "pull", .value = 5, .min = 4.6, .max = 5.4, .unit = "m/s^2", .about = "force on a unit of mass"},
          {.name = "speed", .value = 0, .min = 0, .max = 20, .unit = "m/s", .about = "at the start"}},
     .variants = {{"rests", {}}, {"slides", {{"speed", 2}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::breakaway
