#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::slope {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s, short enough that no box slides off the end: g t^2/2 <= 20 m
const Vec slab{60, 1};          // m; a box rather than a half-space, because every engine has boxes
const double arctan_half = std::atan(0.5) / degree;

Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double size = p.at("size");
  const Vec up{-std::sin(angle), std::cos(angle)};
  const double middle = (slab.y + size) / 2;
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{
      .name = "slope", .about = "A box is released on a slope.", .gravity = {0, -gravity}, .duration = duration};
  scene.bodies.push_back(box("slope", {0, 0}, slab, rough));
  scene.bodies.push_back(box("box", {middle * up.x, middle * up.y}, {size, size}, rough));
  scene.bodies[0].type = BodyType::fixed;
  for (Body& body : scene.bodies) body.angle = angle;
  return scene;
}

// Sticks iff tan a <= mu, otherwise slides with a = g (sin a - mu cos a). It slides before it tips, as mu < 1 = b/h.
//   Contact   may be found a lag late. Until then the box falls freely and gains g sin a lag along the slope, which
//             friction removes only in the next step: a distance of g sin a lag (lag + h). Its speed is right then: the
//             total friction impulse is mu times the total normal impulse, whenever that is given.
//   Sticking  it may creep, by the share of gravity that friction bears, sin a.
//   Position  the gap off the slope, mu times the slop along it while the box sinks in and, if it slides, the
//             integrator's drift.
//   Angle     two corners of one contact differ by the slop.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double mu = p.at("friction");
  const double size = p.at("size");
  const bool sticks = std::tan(angle) <= mu;
  const double acceleration = sticks ? 0 : gravity * (std::sin(angle) - mu * std::cos(angle));
  const double end = duration;
  const double reach = slab.y + size + gravity * end * end;

  const auto speed = [=](const Stepping& s) {
    return (sticks ? s.creep * std::sin(angle) : still_sinking(s, mu, end)) + round_off(s, end, gravity * end);
  };
  const auto place = [=](const Stepping& s) {
    const double crept = sticks ? s.creep * std::sin(angle) * end : 0;
    const double late = slid_late(s, gravity * std::sin(angle)) + mu * s.slop;
    return late + crept + drifted(s, acceleration, end) + s.contact_gap() + round_off(s, end, reach);
  };
  const auto turn = [=](const Stepping& s) { return s.slop / size + round_off(s, end, reach / size); };

  const std::string law = sticks ? "sticks, as tan a <= mu" : "g (sin a - mu cos a) t";
  return {
      {.body = "box",
       .quantity = Quantity::speed,
       .allowed = speed,
       .source = law + (sticks ? "; may creep" : "; mu times the whole normal impulse")},
      {.body = "box", .quantity = Quantity::x, .allowed = place, .source = law + "; late contact, creep or drift, gap"},
      {.body = "box", .quantity = Quantity::y, .allowed = place, .source = law + "; late contact, creep or drift, gap"},
      {.body = "box",
       .quantity = Quantity::angle,
       .allowed = turn,
       .source = "lies flat; one corner may be deeper by the slop"}};
}

Smoothness smoothness(const Parameters& p) {
  return std::tan(p.at("angle") * degree) > p.at("friction") ? Smoothness::sliding : Smoothness::none;
}

const Catalog<Scenario>::Entry entry{
    {.name = "slope",
     .question = "Does a box on a slope stick below arctan(mu) and slide with Coulomb friction above?",
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

namespace plumb::scenarios::tipping {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 1;  // s
constexpr double turned = 0.6;  // rad, well before any box lands on its side
const Vec slab{60, 1};          // m
const double arctan_half = std::atan(0.5) / degree;

Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const Vec size{p.at("width"), p.at("height")};
  const Vec up{-std::sin(angle), std::cos(angle)};
  const double middle = (slab.y + size.y) / 2;
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "tipping",
              .about = "A tall box stands on a slope that is too rough to slide on.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(box("slope", {0, 0}, slab, rough));
  scene.bodies.push_back(box("box", {middle * up.x, middle * up.y}, size, rough));
  scene.bodies[0].type = BodyType::fixed;
  for (Body& body : scene.bodies) body.angle = angle;
  return scene;
}

// Tips iff tan a > b/h. Then the lever arm d from the lower edge to the centre is an inverted pendulum, s'' = w^2 sin
// s, w^2 = m g d/(I + m d^2), s(0) = a - arctan(b/h). Errors of the start grow at most like cosh(w t), those of the
// speed like sinh(w t)/w. With the angular velocity at the end W <= s(0) w sinh(w t):
//   start    two corners of the base differ by the slop, slop/b; and the edge on which the box turns is off by the gap
//            along the slope's normal, gap (b/2)/d^2 in the arm's angle, which also changes w by gap/(2 d) of itself;
//   contact  it is found a lag late, until when the box falls freely. Its angular momentum about the edge grows as it
//            does in contact, and the impact turns all of it into spin: the turn until then is missing,
//            w^2 s(0) lag (lag + h);
//   first    the method's drift makes it half a step early or late: |drift| h W;
//   lost     first-order contacts are found once per step and let the centre move along the tangent, which loses
//            (W dt)^2/2 of the speed in each of t/dt steps;
//   second   a phase error of (w h)^2/24 w t.
// If it stands, one corner may be deeper by the slop, and the box may creep.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double b = p.at("width");
  const double h = p.at("height");
  const double d = std::hypot(b, h) / 2;
  const Mass mass = mass_of(scene(p).bodies[1]);
  const double w = std::sqrt(gravity * d / (mass.inertia / mass.mass + d * d));
  const double lean = angle - std::atan2(b, h);
  const bool stands = lean <= 0;
  // As s < s(0) cosh(w t), it has turned by at most `turned` until then.
  const double early = stands ? duration : std::floor(60 * std::acosh(1 + turned / lean) / w) / 60;
  const double time = std::min(duration, early);
  const double reach = slab.y + h + gravity * duration * duration;

  const auto turn = [=](const Stepping& s) {
    const double round = round_off(s, time, reach / b);
    if (stands) return s.slop / b + round;
    const double fastest = lean * w * std::sinh(w * time);
    const double start = (s.slop / b + s.contact_gap() * b / (2 * d * d)) * std::cosh(w * time);
    const double stiffer = s.contact_gap() / (2 * d) * fastest * time;
    const double late = w * w * lean * lag(s) * (lag(s) + s.h) * std::cosh(w * time);
    const double first = std::abs(s.drift) * s.h * fastest;
    const double swept = lean * (std::cosh(w * time) - 1);
    const double lost = first_order_in_contact(s) ? swept * fastest * fastest * s.dt * time / 2 : 0;
    const double second = w * w * s.h * s.h / 24 * fastest * time * std::cosh(w * time);
    return start + stiffer + late + first + lost + second + round * std::cosh(w * time);
  };
  const auto place = [=](const Stepping& s) {
    const double fallen = gravity * lag(s) * (lag(s) + s.h);
    return d * turn(s) + s.creep * std::sin(angle) * time + s.contact_gap() + fallen + round_off(s, time, reach);
  };
  const std::string law =
      stands ? "stands, as tan a <= b/h" : "tips, as tan a > b/h: turns about its edge, s'' = w^2 sin s";
  return {{.body = "box",
           .quantity = Quantity::angle,
           .time = time,
           .allowed = turn,
           .source = law + (stands ? "; tilted by the slop" : "; gap and lag at the start, amplified, and drift")},
          {.body = "box",
           .quantity = Quantity::x,
           .time = time,
           .allowed = place,
           .source = law + "; the lever arm times the angle"},
          {.body = "box",
           .quantity = Quantity::y,
           .time = time,
           .allowed = place,
           .source = law + "; the lever arm times the angle"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "tipping",
     .question = "Does a box on a rough slope tip if and only if its centre is beyond its lower edge?",
     .parameters =
         {{.name = "angle", .value = arctan_half + 10, .min = 0, .max = 60, .unit = "deg", .about = "of the slope"},
          {.name = "width", .value = 2, .min = 0.5, .max = 4, .unit = "m", .about = "of the base"},
          {.name = "height", .value = 4, .min = 0.5, .max = 8, .unit = "m", .about = "of the box"},
          {.name = "friction", .value = 2, .min = 0, .max = 4, .about = "coefficient, sticking and sliding"}},
     .variants = {{"stands", {{"angle", arctan_half - 2}}}, {"tips", {}}},
     .closed_form = "topple",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::tipping
