#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/integrate.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::step_climb {
namespace {

constexpr double gravity = 10;      // m/s^2
constexpr double radius = 1;        // m, of the disc
constexpr double far = 2.4;         // m, before the edge, from where it rolls
constexpr double friction = 2;      // enough to stick at the edge
constexpr double watched = 0.6;     // s, at least, after the disc has left the edge
constexpr double step = 1e-4;       // s, of the integration
constexpr double shortest = 1e-13;  // s

// A disc at the edge: the angle of its centre from the vertical, to the left, and its rate.
using State = std::array<double, 2>;

State rate(const State& y) { return {y[1], 2.0 / 3 * gravity / radius * std::sin(y[0])}; }

struct Climb {
  double height = 0, speed = 0;  // m, of the step; m/s, of the disc

  double angle() const { return std::acos(1 - height / radius); }

  // Where the disc's centre meets the edge, from above the edge.
  double before() const { return -radius * std::sin(angle()); }

  // About the edge, and then about the floor, it keeps its angular momentum: (3/2) v' = (1/2 + cos a) v.
  double kept() const { return (1 + 2 * std::cos(angle())) / 3; }

  struct Edge {
    double time = 0;  // s, at the edge
    bool over = false;
    double turned = 0;  // rad, of the disc while it was at the edge, clockwise
    double speed = 0;   // m/s, along the floor or the step, to the right
  };

  // From the moment at which the disc has some angle and speed about the edge, until it lies over it or is back.
  static Edge from(double angle, double speed) {
    State now{angle, -speed / radius};
    Edge edge;
    double h = step;
    while (h > shortest) {
      const State next = runge_kutta(now, h, rate);
      if (next[0] < 0 || next[0] > angle) {
        h /= 2;
        continue;
      }
      now = next;
      edge.time += h;
    }
    edge.over = now[1] < 0;
    edge.turned = angle - now[0];
    edge.speed = -now[1] * radius;
    return edge;
  }

  // m, where the centre is a time after it met the edge at some angle and with some speed about it.
  struct Place {
    double x = 0, turned = 0;
  };
  Place after(double time, double angle, double about) const {
    const Edge edge = from(angle, about);
    const double left = time - edge.time;
    if (edge.over) return {edge.speed * left, edge.turned + edge.speed * left / radius};
    const double rolls = kept() * edge.speed;
    return {-radius * std::sin(angle) + rolls * left, edge.turned + rolls * left / radius};
  }
};

Climb climb_of(const Parameters& p) { return {p.at("height"), p.at("speed")}; }

double met_at(const Climb& climb) { return (far + climb.before()) / climb.speed; }

double duration(const Climb& climb) {
  return whole_steps(met_at(climb) + Climb::from(climb.angle(), climb.kept() * climb.speed).time + watched);
}

Scene scene(const Parameters& p) {
  const Climb climb = climb_of(p);
  const Surface rough = surface(friction, 0);
  Scene scene{.name = "step-climb",
              .about = "A disc rolls against a step.",
              .gravity = {0, -gravity},
              .duration = duration(climb)};
  Body disc = plumb::disc("disc", {-far, radius}, radius, rough);
  disc.velocity = {climb.speed, 0};
  disc.angular_velocity = -climb.speed / radius;
  const double length = 8;
  scene.bodies = {level_ground(rough),
                  fixed(box("step", {length / 2, climb.height / 2}, {length, climb.height}, rough)), disc};
  return scene;
}

// Before the edge the disc rolls steadily. There it is found to touch a lag late. Until then it keeps what it loses, v
// - v', and is not slowed by 2/3 g sin a. By the gap that it rests deeper at the floor or the edge it
//   meets   the edge gap/sin a sooner or later;
//   falls   as much deeper: (2/3) g gap/v of speed;
//   turns   about another arm, while its spin is that of the arm before: v/3 gap/r.
// About the edge, forces are those of up to a step earlier or later, 2/3 g sin a h, for a method of first order; (w
// h)^2 of all, w^2 = 2 g/(3 r), for one of second. Sticking may creep, by a third of what it does under the whole
// weight. What is wrong then moves on by the derivatives of where the disc ends; falling back, it meets the floor
// likewise, and may not yet be pushed out of it by what it fell in a lag.
std::vector<Expectation> expectations(const Parameters& p) {
  const Climb climb = climb_of(p);
  const double a = climb.angle();
  const double about = climb.kept() * climb.speed;
  const Climb::Edge edge = Climb::from(a, about);
  const double met = met_at(climb);
  const double end = duration(climb);
  const double w = std::sqrt(2.0 / 3 * gravity / radius);
  const auto impact = [=](const Stepping& s, double v) {
    const double gap = s.contact_gap();
    return 2.0 / 3 * gravity * (gap / v + std::sin(a) * lag(s)) + v * (gap / (3 * radius) + unsolved(s, 2));
  };
  struct Reach {
    double angle = 0, speed = 0;  // m, what is asked for after a metre along the edge or a m/s more about it
  };
  // `asked`: m, of a place: where it is or how far it has rolled.
  const auto reach = [=](double time, const auto& asked) {
    constexpr double little = 1e-6;
    const auto value = [&](double by_angle, double by_speed) {
      return asked(climb.after(time - met, a + by_angle, about + by_speed));
    };
    return Reach{std::abs(value(little, 0) - value(-little, 0)) / (2 * little * radius),
                 std::abs(value(0, little) - value(0, -little)) / (2 * little)};
  };
  const auto off = [=](const Stepping& s, double time, Reach by) {
    const double loss = climb.speed - about;
    const double late = (lag(s) + std::abs(s.drift) * s.h) * loss + s.contact_gap() * (1 + 1 / std::sin(a));
    const double order = first_order_in_contact(s) || first_order(s) ? radius * w * w * std::sin(a) * s.h
                                                                     : w * s.h * w * s.h * climb.speed;
    const double speed = impact(s, climb.speed) + order * w * edge.time + order + s.creep / 3;
    const double back = edge.over ? 0 : impact(s, about) * (time - met - edge.time);
    const double steps = 2.0 / 3 * std::abs(s.drift) * s.h * climb.speed + slid_late(s, gravity);
    return by.angle * late + by.speed * speed + back + steps + 2 * s.contact_gap() +
           round_off(s, time, 1 + climb.speed * time) * (1 + by.angle + by.speed);
  };
  std::vector<Expectation> all;
  const std::string law = std::string("(1 + 2 cos a)/3 of the speed at the edge, a'' = 2/3 g/r sin a about it, ") +
                          (edge.over ? "and on top of the step" : "and again at the floor");
  for (const double time : {std::floor(60 * (met + edge.time + watched / 2)) / 60, end}) {
    const Climb::Place then = climb.after(time - met, a, about);
    const Reach moved = reach(time, [](const Climb::Place& place) { return place.x; });
    const Reach rolled = reach(time, [](const Climb::Place& place) { return radius * place.turned; });
    all.push_back({.body = "disc",
                   .quantity = Quantity::x,
                   .time = time,
                   .expected = then.x,
                   .allowed = [=](const Stepping& s) { return off(s, time, moved); },
                   .source = law});
    all.push_back({.body = "disc",
                   .quantity = Quantity::angle,
                   .time = time,
                   .expected = -(then.turned + (far + climb.before()) / radius),
                   .allowed = [=](const Stepping& s) { return off(s, time, rolled) / radius; },
                   .source = law + "; it never slips"});
  }
  all.push_back({.body = "disc",
                 .quantity = Quantity::y,
                 .expected = radius + (edge.over ? climb.height : 0),
                 .allowed =
                     [=](const Stepping& s) {
                       const double fell = edge.over ? 0 : std::abs(edge.speed) * std::sin(a) * lag(s);
                       return s.contact_gap() + fell + round_off(s, end, 1);
                     },
                 .source = edge.over ? "on the step" : "on the floor"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "step-climb",
     .question = "Does a disc climb a step if what it keeps at the edge lifts it, 3/4 v'^2 > g h, and else roll back?",
     .parameters = {{.name = "height", .value = 0.2, .min = 0.1, .max = 0.24, .unit = "m", .about = "of the step"},
                    {.name = "speed", .value = 2.5, .min = 1, .max = 2.7, .unit = "m/s", .about = "of the disc"}},
     .variants = {{"over", {}}, {"back", {{"speed", 1.65}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::step_climb
