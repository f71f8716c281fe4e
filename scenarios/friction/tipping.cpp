#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::tipping {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 1;  // s
constexpr double turned = 0.6;  // rad: long before any box lands on its side
const Vec slab{60, 1};          // m
const double arctan_half = std::atan(0.5) / degree;

Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const Vec size{p.at("width"), p.at("height")};
  const Vec up{-std::sin(angle), std::cos(angle)};
  const double middle = (slab.y + size.y) / 2;
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "tipping",
              .about = "A tall box on a slope too rough to slide on.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(box("slope", {0, 0}, slab, rough));
  scene.bodies.push_back(box("box", {middle * up.x, middle * up.y}, size, rough));
  scene.bodies[0].type = BodyType::fixed;
  for (Body& body : scene.bodies) body.angle = angle;
  return scene;
}

// Tips iff tan a > b/h: then the arm d from the lower edge to the centre is an upside-down pendulum, s'' = w^2 sin s,
// w^2 = m g d/(I + m d^2), s(0) = a - arctan(b/h). Errors of the start grow with cosh(w t) at most, of the speed with
// sinh(w t)/w. With W the spin at the end, no more than s(0) w sinh(w t):
//   start    a gap in at one side of the base and out at the other, and an edge that much off: 2 gap/b + gap/d;
//   contact  noticed a lag late, until when the box falls freely; the speed g lag may all become spin: g lag/d;
//   first    the method's drift makes it half a step early or late: 2 |drift| h W;
//   lost     contacts are found once a step and let the centre go along the tangent, which takes (W dt)^2/2 of the
//            speed, t/dt times;
//   second   a phase of (w h)^2/24 w t.
// Standing it may gape by the gap, and creep.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double b = p.at("width");
  const double h = p.at("height");
  const double d = std::hypot(b, h) / 2;
  const Mass mass = mass_of(scene(p).bodies[1]);
  const double w = std::sqrt(gravity * d / (mass.inertia / mass.mass + d * d));
  const double lean = angle - std::atan2(b, h);
  const bool stands = lean <= 0;
  // As s < s(0) cosh(w t), it has turned by no more than `turned` until then.
  const double early = stands ? duration : std::floor(60 * std::acosh(1 + turned / lean) / w) / 60;
  const double time = std::min(duration, early);
  const double reach = slab.y + h + gravity * duration * duration;

  const auto turn = [=](const Stepping& s) {
    const double round = round_off(s, time, reach / b);
    if (stands) return 2 * s.gap / b + round;
    const double fastest = lean * w * std::sinh(w * time);
    const double start = (2 / b + 1 / d) * s.gap * std::cosh(w * time);
    const double late = gravity * lag(s) / d * std::sinh(w * time) / w;
    const double first = 2 * std::abs(s.drift) * s.h * fastest;
    const double swept = lean * (std::cosh(w * time) - 1);
    const double lost = swept * fastest * fastest * s.dt * time / 2;
    const double second = w * w * s.h * s.h / 24 * fastest * time * std::cosh(w * time);
    return start + late + first + lost + second + round * std::cosh(w * time);
  };
  const auto place = [=](const Stepping& s) {
    const double fallen = gravity * lag(s) * (lag(s) + s.h);
    return d * turn(s) + s.creep * time + s.gap + fallen + round_off(s, time, reach);
  };
  const std::string law = stands ? "stands, as tan a <= b/h" : "tan a > b/h: turns about its edge, s'' = w^2 sin s";
  return {{.body = "box",
           .quantity = Quantity::angle,
           .time = time,
           .allowed = turn,
           .source = law + (stands ? "; gapes by a gap" : "; a gap and a lag at the start, grown, and drift")},
          {.body = "box",
           .quantity = Quantity::x,
           .time = time,
           .allowed = place,
           .source = law + "; the arm times the turn"},
          {.body = "box",
           .quantity = Quantity::y,
           .time = time,
           .allowed = place,
           .source = law + "; the arm times the turn"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "tipping",
     .question = "Does a box on a rough slope tip once its centre is beyond its lower edge, and not before?",
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
