#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::peaucellier {
namespace {

constexpr double crank = 0.6;     // m, from its pivot to its pin, and from the pivot to the origin
constexpr double long_bar = 1.5;  // m, from the origin to either side of the rhombus
constexpr double bar = 0.6;       // m, each side of the rhombus
constexpr double duration = 3;    // s

// The crank's pin C runs on a circle through the origin O. A rhombus A C B D of bars, held by two long bars O A and O
// B, inverts it: O C times O D is long^2 - bar^2, so that D runs on a straight line (Peaucellier 1864, Lipkin 1871).
constexpr double line = (long_bar * long_bar - bar * bar) / (2 * crank);  // m, from the origin

struct Point {
  Vec at, velocity;
};

struct Pose {
  Point pin, above, below, end;  // C, A, B, D
};

Vec sum(Vec a, double factor, Vec b) { return {a.x + factor * b.x, a.y + factor * b.y}; }
double distance(Vec a, Vec b) { return std::hypot(b.x - a.x, b.y - a.y); }

// With the crank at an angle, turning at a rate.
Pose pose(double angle, double turn) {
  const double half = angle / 2;
  const Vec along{std::cos(half), std::sin(half)};
  const Vec across{-along.y, along.x};
  const double middle = crank * along.x + line / (2 * along.x);  // m, of the rhombus, from the origin
  const double moves = turn / 2 * (-crank * along.y + line * along.y / (2 * along.x * along.x));
  const double wide = std::sqrt(long_bar * long_bar - middle * middle);
  const double widens = -middle * moves / wide;
  const auto side = [&](double way) {
    const Vec velocity = sum({moves * along.x, moves * along.y}, middle * turn / 2 + way * widens, across);
    return Point{sum({middle * along.x, middle * along.y}, way * wide, across),
                 sum(velocity, -way * wide * turn / 2, along)};
  };
  return {{{crank + crank * std::cos(angle), crank * std::sin(angle)},
           {-turn * crank * std::sin(angle), turn * crank * std::cos(angle)}},
          side(1),
          side(-1),
          {{line, line * along.y / along.x}, {0, line * turn / 2 / (along.x * along.x)}}};
}

double widest(const Parameters& p) { return p.at("swing") * degree; }
double turn_of(const Parameters& p) { return 2 * widest(p) / duration; }
double angle_at(const Parameters& p, double t) { return widest(p) * (2 * t / duration - 1); }
Pose pose_at(const Parameters& p, double t) { return pose(angle_at(p, t), turn_of(p)); }

Scene scene(const Parameters& p) {
  const Pose start = pose_at(p, 0);
  Scene scene{.name = "peaucellier",
              .about = "A crank drives Peaucellier's linkage of six bars.",
              .gravity = {0, 0},
              .duration = duration};
  Body shaft = box("crank", {crank, 0}, {2 * crank, 0.1}, {});
  shaft.type = BodyType::kinematic;
  shaft.angle = angle_at(p, 0);
  shaft.angular_velocity = turn_of(p);
  scene.bodies = {{.name = "origin", .type = BodyType::fixed}, shaft};
  for (const auto& [name, point] :
       {std::pair{"above", start.above}, std::pair{"below", start.below}, std::pair{"end", start.end}}) {
    Body pin = disc(name, point.at, 0.1, {});
    pin.velocity = point.velocity;
    scene.bodies.push_back(pin);
  }
  for (Body& body : scene.bodies) body.layers = 0;
  const auto joined = [&](std::size_t a, Vec on_a, std::size_t b, double length) {
    scene.joints.push_back(
        Distance{.a = a, .b = b, .anchor_a = on_a, .anchor_b = scene.bodies[b].position, .length = length});
  };
  for (const std::size_t side : {std::size_t{2}, std::size_t{3}}) {
    joined(0, {0, 0}, side, long_bar);
    joined(1, start.pin.at, side, bar);
    joined(side, scene.bodies[side].position, 4, bar);
  }
  return scene;
}

using Lengths = std::array<double, 6>;  // of O A, C A, A D, O B, C B, B D
constexpr Lengths lengths{long_bar, bar, bar, long_bar, bar, bar};

// Where circles about two points meet, on the left of the way from the first to the second or on the right.
Vec meet(Vec a, double radius_a, Vec b, double radius_b, double left) {
  const double between = distance(a, b);
  const double along = (between * between + radius_a * radius_a - radius_b * radius_b) / (2 * between);
  const double across = left * std::sqrt(radius_a * radius_a - along * along);
  const Vec unit{(b.x - a.x) / between, (b.y - a.y) / between};
  return sum(sum(a, along, unit), across, {-unit.y, unit.x});
}

Vec end_of(Vec pin, const Lengths& of) {
  const Vec above = meet({0, 0}, of[0], pin, of[1], 1);
  const Vec below = meet({0, 0}, of[3], pin, of[4], -1);
  return meet(above, of[2], below, of[5], 1);
}

// The crank's angle decides all else. Each of the six bars may be off by the slop, and for methods of first order that
// hold joints by velocities alone by what it turns away from its tangent in a step, (W h)^2 l/2, ten times, as
// corrections of a tenth a step leave it (see slider-crank). What each does to the end is found by drawing the linkage
// with that bar a little longer.
//   Speed   first order: the velocity is that of the step's start, up to the largest acceleration, w^2 y/2 sec^2, times
//           a step; second order: (W h)^2/3 of it.
std::vector<Expectation> expectations(const Parameters& p) {
  const double turn = turn_of(p);
  const double fastest = turn / 2 * line / std::pow(std::cos(widest(p) / 2), 2);  // m/s, of the end
  const double bends = turn * fastest * std::tan(widest(p) / 2);                  // m/s^2
  double rate = 0;  // rad/s, of the bar that turns fastest
  for (int i = 0; i <= 100; ++i) {
    const Pose now = pose_at(p, duration * i / 100);
    for (const Point& side : {now.above, now.below}) {
      rate = std::max({rate, distance(side.velocity, now.pin.velocity) / bar,
                       distance(side.velocity, now.end.velocity) / bar, distance(side.velocity, {}) / long_bar});
    }
  }
  std::vector<Expectation> all;
  for (const double t : {duration / 4, 2 * duration / 3, duration}) {
    const Pose then = pose_at(p, t);
    double by_lengths = 0;  // m per m, of all bars
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      constexpr double little = 1e-6;
      Lengths longer = lengths;
      longer[i] += little;
      by_lengths += distance(end_of(then.pin.at, longer), then.end.at) / little;
    }
    const auto off = [=](const Stepping& s) {
      const double turned = rate * s.h;
      const double left = first_order(s) ? 10 * turned * turned * bar / 2 : 0;
      return by_lengths * (s.joint_slop + left + round_off(s, duration, 2 * long_bar + fastest * duration));
    };
    all.push_back(
        {.body = "end",
         .quantity = Quantity::x,
         .time = t,
         .expected = then.end.at.x,
         .allowed = off,
         .source = "Peaucellier (1864): a straight line at (long^2 - bar^2)/(2 crank); the slop of six bars"});
    all.push_back({.body = "end",
                   .quantity = Quantity::y,
                   .time = t,
                   .expected = then.end.at.y,
                   .allowed = off,
                   .source = "tan(crank's angle/2) of the line's distance; the slop of six bars"});
    all.push_back({.body = "end",
                   .quantity = Quantity::vy,
                   .time = t,
                   .expected = then.end.velocity.y,
                   .allowed =
                       [=](const Stepping& s) {
                         const double turned = rate * s.h;
                         return (first_order(s) ? bends * s.h : turned * turned / 3 * fastest) + rate * off(s);
                       },
                   .source = "its derivative; a step's change of velocity"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "peaucellier",
     .question = "Does Peaucellier's linkage draw a straight line?",
     .parameters =
         {{.name = "swing", .value = 60, .min = 20, .max = 70, .unit = "deg", .about = "of the crank to either side"}},
     .variants = {{"draws", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::peaucellier
