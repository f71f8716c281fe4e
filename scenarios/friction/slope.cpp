#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::slope {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s, in which no box slides off the end: g t^2/2 = 20 m at most
const Vec slab{60, 1};          // m; a box and not a half-space, as every engine has boxes and none needs a stand-in
const double arctan_half = std::atan(0.5) / degree;

Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double size = p.at("size");
  const Vec up{-std::sin(angle), std::cos(angle)};
  const double middle = (slab.y + size) / 2;
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "slope", .about = "A box on a slope.", .gravity = {0, -gravity}, .duration = duration};
  scene.bodies.push_back(box("slope", {0, 0}, slab, rough));
  scene.bodies.push_back(box("box", {middle * up.x, middle * up.y}, {size, size}, rough));
  scene.bodies[0].type = BodyType::fixed;
  for (Body& body : scene.bodies) body.angle = angle;
  return scene;
}

// Sticks iff tan a <= mu, else slides with a = g (sin a - mu cos a). Slides before it tips, as mu < 1 = b/h.
//   Contact  it may be noticed a lag late. Until then the box falls freely, gains g sin a lag along the slope that
//   friction
//            takes away only with the step after: g sin a lag (lag + h) of way. Where it slides, friction's whole
//            impulse is mu times the whole normal impulse, which is off by the fall's m g cos a lag at most.
//   Sticking it may creep. Place: the gap off the slope and, sliding, the integrator's drift.
//   Angle    a gap in at one corner and out at the other.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double mu = p.at("friction");
  const double size = p.at("size");
  const bool sticks = std::tan(angle) <= mu;
  const double acceleration = sticks ? 0 : gravity * (std::sin(angle) - mu * std::cos(angle));
  const double end = duration;
  const double reach = slab.y + size + gravity * end * end;

  const auto speed = [=](const Stepping& s) {
    const double late = sticks ? s.creep : gravity * mu * std::cos(angle) * lag(s);
    return late + round_off(s, end, gravity * end);
  };
  const auto place = [=](const Stepping& s) {
    const double fallen = gravity * std::sin(angle) * lag(s) * (lag(s) + s.h);
    const double way = sticks ? s.creep * end : gravity * mu * std::cos(angle) * lag(s) * end;
    return fallen + way + drifted(s, acceleration, end) + s.gap + round_off(s, end, reach);
  };
  const auto turn = [=](const Stepping& s) { return 2 * s.gap / size + round_off(s, end, reach / size); };

  const std::string law = sticks ? "sticks, as tan a <= mu" : "g (sin a - mu cos a) t";
  return {{.body = "box",
           .quantity = Quantity::speed,
           .allowed = speed,
           .source = law + (sticks ? "; may creep" : "; friction may start one lag late")},
          {.body = "box",
           .quantity = Quantity::x,
           .allowed = place,
           .source = law + "; a late contact, creep or drift, and the gap"},
          {.body = "box",
           .quantity = Quantity::y,
           .allowed = place,
           .source = law + "; a late contact, creep or drift, and the gap"},
          {.body = "box",
           .quantity = Quantity::angle,
           .allowed = turn,
           .source = "lies flat; a gap in at one corner, out at the other"}};
}

Smoothness smoothness(const Parameters& p) {
  return std::tan(p.at("angle") * degree) > p.at("friction") ? Smoothness::sliding : Smoothness::none;
}

const Catalog<Scenario>::Entry entry{
    {.name = "slope",
     .question = "Does a box stick below arctan(mu) and slide as Coulomb says above?",
     .parameters =
         {{.name = "angle", .value = 20, .min = 0, .max = 80, .unit = "deg", .about = "of the slope"},
          {.name = "friction", .value = 0.2, .min = 0, .max = 0.9, .about = "coefficient, sticking and sliding"},
          {.name = "size", .value = 1, .min = 0.1, .max = 2, .unit = "m", .about = "side of the box"}},
     .variants = {{"sticks", {{"angle", arctan_half - 1}, {"friction", 0.5}}},
                  {"slides", {{"angle", arctan_half + 1}, {"friction", 0.5}}},
                  {"steep", {}}},
     .closed_form = "slide",
     .scene = scene,
     .expectations = expectations,
     .canonical = true,
     .smoothness = smoothness}};

}  // namespace
}  // namespace plumb::scenarios::slope
