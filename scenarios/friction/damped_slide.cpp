#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::damped_slide {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double rest = 1.5;    // s, for which it lies still at the end; iterations converge until then
const Vec size{1, 0.5};         // m; too low to tip: mu < b/h = 2

// v' = -c v - u, u = mu g.
struct Slide {
  double v, c, mu, u;

  explicit Slide(const Parameters& p)
      : v(p.at("speed")), c(p.at("damping")), mu(p.at("friction")), u(p.at("friction") * gravity) {}

  double stop() const { return std::log1p(c * v / u) / c; }  // s
  double left(double t) const { return std::exp(-c * t); }
  double speed(double t) const { return (v + u / c) * left(t) - u / c; }
  double way(double t) const { return (v + u / c) * (1 - left(t)) / c - u / c * t; }
};

Scene scene(const Parameters& p) {
  const Slide slide(p);
  const Surface rough = surface(slide.mu, 0);
  Scene scene{.name = "damped-slide",
              .about = "A damped box slides over level ground until damping and friction have stopped it.",
              .gravity = {0, -gravity},
              .duration = whole_steps(slide.stop() + rest)};
  Body sliding = box("box", {0, size.y / 2}, size, rough);
  sliding.velocity = {slide.v, 0};
  sliding.linear_damping = slide.c;
  scene.bodies = {level_ground(rough), sliding};
  return scene;
}

// Of v = (v0 + u/c) e^(-ct) - u/c a method is off by
//   damping   e^(-ct): c^2 t h/2 of it if it is of first order, h the interval at which damping acts, and c^3 t h^2/6
//             of it if of second, as for a body in flight (lone-bodies);
//   friction  u/c (1 - e^(-ct)): if of first order, a step of it may escape the damping, and what presses may be
//             damped before it presses, c h of it each; if of second, c^2 h^2/4 of it;
//   contact   late by a lag, and while the box sinks in by the slop.
// A speed between two steps is read from the chord, which lacks at most dt^2/8 of v'' = c^2 (v0 + u/c) e^(-ct).
// Of the way by what these add up to, int t e^(-ct) <= min(t^2/2, 1/c^2), by the drift of the deceleration or, of
// second order, c^2 h^2/4, and where it stops, by a step's way and what the error of the speed still goes.
std::vector<Expectation> expectations(const Parameters& p) {
  const Slide slide(p);
  const double whole = slide.v + slide.u / slide.c;
  const double end = scene(p).duration;
  const auto interval = [](const Stepping& s) { return s.damping_interval > 0 ? s.damping_interval : s.h; };
  const auto rate = [c = slide.c](const Stepping& s) { return damping_error(s, c); };
  const auto friction = [=, c = slide.c](const Stepping& s) {  // share
    return first_order(s) ? 2 * c * interval(s) : c * c * s.h * s.h / 4;
  };
  const auto speed = [=](const Stepping& s, double t) {
    return whole * slide.left(t) * std::expm1(rate(s) * t) + slide.u / slide.c * (1 - slide.left(t)) * friction(s) +
           still_sinking(s, slide.mu, t) + round_off(s, t, slide.v + gravity * t);
  };
  const auto place = [=](const Stepping& s, double t) {
    const double damped = whole * rate(s) * std::min(t * t / 2, 1 / (slide.c * slide.c));
    const double rubbed = slide.u / slide.c * friction(s) * t;
    const double method = first_order(s) ? 0 : whole * t * slide.c * slide.c * s.h * s.h / 4;
    return damped + rubbed + method + std::abs(s.drift) * s.h * (slide.v - slide.speed(t)) + slid_late(s, slide.u) +
           (slide.mu + size.y / size.x / 2) * s.slop + round_off(s, end, slide.way(slide.stop()) + slide.v * end);
  };
  const double half = whole_steps(slide.stop() / 2);
  const auto chord = [=](const Stepping& s) {
    const double share = half / s.dt - std::floor(half / s.dt);
    return share * (1 - share) / 2 * s.dt * s.dt * slide.c * slide.c * whole * slide.left(half);
  };
  return {{.body = "box",
           .quantity = Quantity::vx,
           .time = half,
           .expected = slide.speed(half),
           .allowed = [=](const Stepping& s) { return speed(s, half) + chord(s); },
           .source = "(v0 + mu g/c) e^(-ct) - mu g/c; damping, friction"},
          {.body = "box",
           .quantity = Quantity::x,
           .time = half,
           .expected = slide.way(half),
           .allowed = [=](const Stepping& s) { return place(s, half); },
           .source = "(v0 + mu g/c) (1 - e^(-ct))/c - mu g/c t; damping, friction, late contact"},
          {.body = "box",
           .quantity = Quantity::x,
           .expected = slide.way(slide.stop()),
           .allowed =
               [=](const Stepping& s) {
                 const double off = speed(s, slide.stop());
                 return place(s, slide.stop()) + slide.u * s.h * s.h / 2 + off * off / (2 * slide.u);
               },
           .source = "v0/c - mu g/c^2 ln(1 + c v0/(mu g)), where it stops"},
          {.body = "box",
           .quantity = Quantity::speed,
           .expected = 0,
           .allowed = [=](const Stepping& s) { return round_off(s, end, slide.v); },
           .source = "at rest after ln(1 + c v0/(mu g))/c, on level ground without creep"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "damped-slide",
     .question = "Does a damped box slide to rest after ln(1 + c v/(mu g))/c, by damping and friction together?",
     .parameters = {{.name = "speed", .value = 5, .min = 1, .max = 20, .unit = "m/s", .about = "at the start"},
                    {.name = "friction", .value = 0.3, .min = 0.1, .max = 1, .about = "of box and ground"},
                    {.name = "damping", .value = 1, .min = 0.1, .max = 5, .unit = "1/s", .about = "of its velocity"}},
     .variants = {{"c=1", {}}, {"c=4", {{"damping", 4}, {"friction", 0.1}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::damped_slide
