#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::rail_stop {
namespace {

constexpr double gravity = 10;   // m/s^2
constexpr double way = 1;        // m, from the start to the stop
constexpr double length = 1;     // m, of the spring at rest
constexpr double after = 2;      // s, from the stop to the end
constexpr double asked_at = .8;  // of the time to the stop

// s'' = g sin(slope) + w^2 (D - s) from rest at s = 0, by the spring that would rest at D, beyond the stop.
struct Slide {
  double pull, w, beyond;  // m/s^2, rad/s, m: g sin(slope), w, D

  explicit Slide(const Parameters& p)
      : pull(gravity * std::sin(p.at("slope") * degree)), w(p.at("spring")), beyond(p.at("beyond")) {}

  double first_pull() const { return pull + w * w * beyond; }
  double swing() const { return beyond + pull / (w * w); }
  double stops() const { return w > 0 ? std::acos(1 - way / swing()) / w : std::sqrt(2 * way / pull); }
  double place(double t) const { return w > 0 ? swing() * (1 - std::cos(w * t)) : pull * t * t / 2; }
  double speed(double t) const { return w > 0 ? swing() * w * std::sin(w * t) : pull * t; }
};

Vec downhill(const Parameters& p) {
  const double slope = p.at("slope") * degree;
  return {std::cos(slope), -std::sin(slope)};
}

Scene scene(const Parameters& p) {
  const Slide slide(p);
  const Vec axis = downhill(p);
  Scene scene{.name = "rail-stop",
              .about = "A slider runs down a rail, pulled by a spring or not, until the rail's end stops it.",
              .gravity = {0, -gravity},
              .duration = whole_steps(slide.stops() + after)};
  Body slider = box("slider", {0, 0}, {0.4, 0.2}, {});
  slider.angle = -p.at("slope") * degree;
  slider.layers = 0;
  scene.bodies = {{.name = "rail", .type = BodyType::fixed, .layers = 0}, slider};
  scene.joints.push_back(Prismatic{.a = 0, .b = 1, .axis = axis, .limits = Limits{-way, way}});
  if (slide.w > 0) {
    const double hook = slide.beyond + length;
    scene.forces.push_back(Spring{.b = 1,
                                  .anchor_a = {hook * axis.x, hook * axis.y},
                                  .stiffness = mass_of(slider).mass * slide.w * slide.w,
                                  .length = length});
  }
  return scene;
}

// On its way, with k = w f, f the interval of forces, and the pull a at the start:
//   drift     |drift| a t h, of the speed too where the spring's pull is that of another place: w^2 times it, a time t;
//   phase     second order, k^2/12 of the swing and of its phase; an energy that grows by k^2 a step by half of that;
//   chord     a reading between two steps, a dt^2/8, of a speed by the change of a in a step.
// A limit has no restitution: whenever within a step it stops the slider, it rests there, but for the slop of the rail
// and of its stop, and for what is left of a step's way, v h, where a step takes back a tenth of it (Baumgarte).
std::vector<Expectation> expectations(const Parameters& p) {
  const Slide slide(p);
  const Vec axis = downhill(p);
  const double t = asked_at * slide.stops();
  const double a = slide.first_pull();
  const double end = slide.stops() + after;
  const auto rounding = [=](const Stepping& s) { return round_off(s, end, 4 + (a + gravity) * end); };
  const auto method = [=](const Stepping& s) {
    const double k = slide.w * force_interval(s);
    const double grown = grows(s) ? std::pow(1 + k * k, t / (2 * force_interval(s))) - 1 : 0;
    return slide.place(t) * (1 + slide.w * t) * (k * k / 12 + grown);
  };
  const auto place = [=](const Stepping& s) {
    return drifted(s, a, t) + method(s) + a * s.dt * s.dt / 8 + s.joint_slop + rounding(s);
  };
  const auto speed = [=](const Stepping& s) {
    const double bend = slide.w * slide.w * (drifted(s, a, t) * t + a * s.dt * s.dt / 8);
    return bend + (1 / t + slide.w) * method(s) + rounding(s);
  };
  const auto left = [=, fastest = slide.speed(slide.stops())](const Stepping& s) {
    return first_order(s) ? fastest * s.h * std::pow(0.9, after / s.dt) : 0;
  };
  const auto rests = [=](const Stepping& s) { return 2 * s.joint_slop + left(s) + rounding(s); };
  const char* slides = slide.w > 0 ? "(D + g sin a/w^2) (1 - cos w t); the method's order and drift"
                                   : "g sin a t^2/2; the method's drift";
  return {{.body = "slider",
           .quantity = Quantity::x,
           .time = t,
           .expected = slide.place(t) * axis.x,
           .allowed = place,
           .source = slides},
          {.body = "slider",
           .quantity = Quantity::speed,
           .time = t,
           .expected = slide.speed(t),
           .allowed = speed,
           .source = slide.w > 0 ? "(D + g sin a/w^2) w sin w t; the method's order" : "g sin a t"},
          {.body = "slider",
           .quantity = Quantity::x,
           .expected = way * axis.x,
           .allowed = rests,
           .source = "at rest at the stop; slop"},
          {.body = "slider",
           .quantity = Quantity::y,
           .expected = way * axis.y,
           .allowed = rests,
           .source = "at rest at the stop; slop"},
          {.body = "slider",
           .quantity = Quantity::speed,
           .expected = 0,
           .allowed = [=](const Stepping& s) { return left(s) / (10 * s.dt) + rounding(s); },
           .source = "the stop takes all of its momentum"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "rail-stop",
     .question = "Does a slider stop at the end of its rail without a rebound, and stay there?",
     .parameters = {{.name = "slope", .value = 30, .min = 5, .max = 80, .unit = "deg", .about = "of the rail"},
                    {.name = "spring",
                     .value = 0,
                     .min = 0,
                     .max = 6,
                     .unit = "rad/s",
                     .about = "sqrt(k/m) of the spring that pulls; 0: there is none"},
                    {.name = "beyond",
                     .value = 1.5,
                     .min = 1.2,
                     .max = 2,
                     .unit = "m",
                     .about = "from the start to where the spring would rest; the stop is at 1 m"}},
     .variants = {{"slides", {}}, {"pulled", {{"slope", 10}, {"spring", 4}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::rail_stop
