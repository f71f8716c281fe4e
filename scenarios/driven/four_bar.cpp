#include "scenarios/driven/four_bar.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/integrate.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::four_bar {
namespace {

using plumb::four_bar::base;
using plumb::four_bar::coupler;
using plumb::four_bar::crank;
using plumb::four_bar::pose;
using plumb::four_bar::Pose;
using plumb::four_bar::rocker;

constexpr double at_start = 0.9;  // rad, of the crank
constexpr double duration = 3;    // s
constexpr double width = 0.1;     // m

// A bar from pin to pin, with the velocity of its middle and its angular velocity.
Body bar(const char* name, Vec from, double length, double angle, Vec velocity_of_pin, double spin) {
  const Vec half{length / 2 * std::cos(angle), length / 2 * std::sin(angle)};
  Body made = box(name, {from.x + half.x, from.y + half.y}, {length, width}, {});
  made.angle = angle;
  made.velocity = {velocity_of_pin.x - spin * half.y, velocity_of_pin.y + spin * half.x};
  made.angular_velocity = spin;
  made.layers = 0;
  return made;
}

Scene linkage(double turn, std::optional<Motor> motor) {
  const Pose now = pose(at_start);
  const Vec pin{crank * std::cos(at_start), crank * std::sin(at_start)};
  const Vec top{pin.x + coupler * std::cos(now.coupler_angle), pin.y + coupler * std::sin(now.coupler_angle)};
  Scene scene{.gravity = {0, 0}, .duration = duration};
  scene.bodies = {
      {.name = "base", .type = BodyType::fixed, .layers = 0},
      bar("crank", {0, 0}, crank, at_start, {}, turn),
      bar("coupler", pin, coupler, now.coupler_angle, {-turn * pin.y, turn * pin.x}, turn * now.coupler_rate),
      bar("rocker", {base, 0}, rocker, now.rocker_angle, {}, turn * now.rocker_rate)};
  scene.joints = {Revolute{.a = 0, .b = 1, .motor = motor}, Revolute{.a = 1, .b = 2, .anchor = pin},
                  Revolute{.a = 2, .b = 3, .anchor = top}, Revolute{.a = 0, .b = 3, .anchor = {base, 0}}};
  return scene;
}

// The largest of a function of the pose over a turn of the crank.
template <class Of>
double largest(Of of) {
  double most = 0;
  for (int i = 0; i < 720; ++i) most = std::max(most, std::abs(of(pose(i * std::numbers::pi / 360))));
  return most;
}

// Where coupler and rocker are nearest to a line, an error across both is amplified by 1/sin of the angle between them.
double steepest() {
  return largest([](const Pose& at) { return 1 / std::sin(at.rocker_angle - at.coupler_angle); });
}

double fastest_rate() {
  return std::max({1.0, largest([](const Pose& at) { return at.coupler_rate; }),
                   largest([](const Pose& at) { return at.rocker_rate; })});
}

// m, by which the pins may be apart in all: the slop of four joints; in methods of first order that hold joints by
// velocities, also what a pin turns away from its tangent in a step, (W h)^2 r/2, of which corrections of a tenth a
// step leave ten times (Baumgarte).
double pins_apart(const Stepping& s, double turn) {
  const double step = fastest_rate() * turn * s.h;
  return 4 * s.joint_slop + (first_order(s) ? 10 * step * step * coupler / 2 : 0);
}

struct Reading {
  const char* body;
  double angle, length;
};

std::vector<Reading> readings(const Pose& at) {
  return {{"coupler", at.coupler_angle, coupler}, {"rocker", at.rocker_angle, rocker}};
}

}  // namespace

namespace driven {
namespace {

Scene scene(const Parameters& p) {
  constexpr double strong = 1000;  // N m, far above what the bars' inertia asks for
  Scene scene = linkage(p.at("turn"), Motor{p.at("turn"), strong});
  scene.name = "four-bar";
  scene.about = "A motor turns the crank of a four-bar linkage at a constant speed.";
  return scene;
}

// The motor holds the crank's speed at every step's end, and its angle is that times the time.
std::vector<Expectation> expectations(const Parameters& p) {
  const double turn = p.at("turn");
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, 4 * (1 + turn * duration)); };
  std::vector<Expectation> all;
  for (const double t : {duration / 2, duration}) {
    const Pose at = pose(at_start + turn * t);
    all.push_back({.body = "crank",
                   .quantity = Quantity::angle,
                   .time = t,
                   .expected = at.crank_angle,
                   .allowed = [=](const Stepping& s) { return 2 * pins_apart(s, turn) / crank + exact(s); },
                   .source = "the motor's speed times the time; slop"});
    for (const Reading& one : readings(at)) {
      all.push_back({.body = one.body,
                     .quantity = Quantity::angle,
                     .time = t,
                     .expected = one.angle,
                     .allowed =
                         [=, length = one.length](const Stepping& s) {
                           return 2 * steepest() * pins_apart(s, turn) / length +
                                  fastest_rate() * 2 * pins_apart(s, turn) / crank + exact(s);
                         },
                     .source = "a e^(i t) + b e^(i s) = d + c e^(i r); the slop of its joints"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "four-bar",
     .question = "Does a four-bar linkage that a motor turns move as its loop says?",
     .parameters = {{.name = "turn", .value = 3, .min = 1, .max = 6, .unit = "rad/s", .about = "of the motor"}},
     .variants = {{"3rad/s", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace driven

namespace free {
namespace {

Scene scene(const Parameters& p) {
  Scene scene = linkage(p.at("turn"), std::nullopt);
  scene.name = "free-four-bar";
  scene.about = "A four-bar linkage turns by itself, faster and slower, without a loss.";
  return scene;
}

// kg m^2, of the linkage at the crank: twice the kinetic energy at a turning of 1 rad/s.
double inertia(const Scene& scene, double angle) {
  const Pose at = pose(angle);
  const Mass bars[] = {mass_of(scene.bodies[1]), mass_of(scene.bodies[2]), mass_of(scene.bodies[3])};
  const auto about_end = [](const Mass& bar, double length) { return bar.inertia + bar.mass * length * length / 4; };
  const double s = at.coupler_rate;
  const double middle =
      crank * crank + coupler * coupler / 4 * s * s + crank * coupler * s * std::cos(angle - at.coupler_angle);
  return about_end(bars[0], crank) + bars[1].mass * middle + bars[1].inertia * s * s +
         about_end(bars[2], rocker) * at.rocker_rate * at.rocker_rate;
}

// The energy I(t) t'^2/2 stays: t' = W sqrt(I0/I), integrated.
double crank_angle(const Scene& scene, double turn, double time) {
  const double first = inertia(scene, at_start);
  const auto rate = [&](const std::array<double, 1>& y) {
    return std::array<double, 1>{turn * std::sqrt(first / inertia(scene, y[0]))};
  };
  return integrated<1>({at_start}, time, 2000, rate)[0];
}

// With k = W h, W the fastest turning of a bar, of all that the crank has swept
//   first order   k, once for the direction, which is that of the step's start, and once for the energy of what leaves
//                 its arc;
//   second order  k^2/3.
// Its pins are apart as in a driven one.
std::vector<Expectation> expectations(const Parameters& p) {
  const double turn = p.at("turn");
  const Scene of = scene(p);
  double slowest = inertia(of, at_start);
  double least = slowest;
  for (int i = 0; i < 360; ++i) least = std::min(least, inertia(of, i * std::numbers::pi / 180));
  const double fastest = turn * std::sqrt(slowest / least) * fastest_rate();
  std::vector<Expectation> all;
  for (const double t : {duration / 2, duration}) {
    const Pose at = pose(crank_angle(of, turn, t));
    const double swept = at.crank_angle - at_start;
    const auto crank_off = [=](const Stepping& s) {
      const double k = fastest * s.h;
      return swept * (first_order(s) ? 2 * k : k * k / 3) + 2 * pins_apart(s, fastest / fastest_rate()) / crank +
             round_off(s, duration, 4 * (1 + swept));
    };
    all.push_back({.body = "crank",
                   .quantity = Quantity::angle,
                   .time = t,
                   .expected = at.crank_angle,
                   .allowed = crank_off,
                   .source = "t' = W sqrt(I0/I(t)), integrated; the method's order, slop"});
    for (const Reading& one : readings(at)) {
      all.push_back({.body = one.body,
                     .quantity = Quantity::angle,
                     .time = t,
                     .expected = one.angle,
                     .allowed =
                         [=, length = one.length](const Stepping& s) {
                           return fastest_rate() * crank_off(s) +
                                  2 * steepest() * pins_apart(s, fastest / fastest_rate()) / length;
                         },
                     .source = "a e^(i t) + b e^(i s) = d + c e^(i r); the crank's error, slop"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "free-four-bar",
     .question = "Does a four-bar linkage that nothing drives keep its energy as it turns?",
     .parameters =
         {{.name = "turn", .value = 2, .min = 0.5, .max = 4, .unit = "rad/s", .about = "of the crank at the start"}},
     .variants = {{"2rad/s", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace free
}  // namespace plumb::scenarios::four_bar
