#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

// A spinning disc is put down, on the ground or in a corner.
namespace plumb::scenarios::spin_up {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double radius = 0.5;  // m

double slips_for(const Parameters& p) { return p.at("spin") * radius / (3 * p.at("friction") * gravity); }  // s

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "spin-up",
              .about = "A spinning disc is put on the ground.",
              .gravity = {0, -gravity},
              .duration = std::ceil(slips_for(p)) + 1};
  scene.bodies.push_back(level_ground(rough));
  Body spun = disc("disc", {0, radius}, radius, rough);
  spun.angular_velocity = -p.at("spin");
  scene.bodies.push_back(spun);
  return scene;
}

// Friction has no moment about a point of the ground, so I w0 = I w + m v r with v = w r: w = w0/3 whatever the course
// of friction. A contact point that is off by the gap makes that w0/(1 + 2 arm^2/r^2), off by 4/9 w0 gap/r, and the
// speed, that times the arm, off by w0 gap/9. Where contact points are held for a step, the disc sinks in by rolls_in,
// on average over the spins from w0 to w0/3, whose mean square is 13/27 w0^2. Where the disc ends depends on more: the
// contact may be found a lag late;
// it drifts with the gain of speed; its friction is short of mu times the slop while it sinks in; and it is off in
// speed and spin from when it rolls, in spin also for half of the time until then.
std::vector<Expectation> expectations(const Parameters& p) {
  const double spin = p.at("spin");
  const double mu = p.at("friction");
  const double end = scene(p).duration;
  const double slips = slips_for(p);
  const double v = spin * radius / 3;
  const auto gap = [=](const Stepping& s) {
    return s.contact_gap() + rolls_in(s, radius, std::sqrt(13.0 / 27) * spin);
  };
  const auto speed = [=](const Stepping& s) { return spin * gap(s) / 9 + round_off(s, end, v); };
  const auto about = [=](const Stepping& s) { return 4.0 / 9 * spin * gap(s) / radius + round_off(s, end, spin); };
  const auto late = [=](const Stepping& s) {
    return v * std::abs(s.drift) * s.h + mu * s.slop + slid_late(s, mu * gravity);
  };
  const auto place = [=](const Stepping& s) { return late(s) + speed(s) * (end - slips) + round_off(s, end, v * end); };
  const auto turn = [=](const Stepping& s) {
    return 2 / radius * late(s) + about(s) * (end - slips / 2) + round_off(s, end, spin * end);
  };
  return {{.body = "disc",
           .quantity = Quantity::vx,
           .allowed = speed,
           .source = "w0 r/3, whatever the course of friction; lever arm off by the gap"},
          {.body = "disc",
           .quantity = Quantity::angular_velocity,
           .allowed = about,
           .source = "w0/3, whatever the course of friction; lever arm off by the gap"},
          {.body = "disc",
           .quantity = Quantity::x,
           .allowed = place,
           .source = "rolls after w0 r/(3 mu g); contact a lag late, drift, lever arm"},
          {.body = "disc", .quantity = Quantity::angle, .allowed = turn, .source = "rolls after w0 r/(3 mu g)"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "spin-up",
     .question = "Does a spinning disc put on the ground roll away with a third of its spin?",
     .parameters = {{.name = "spin", .value = 24, .min = 1, .max = 100, .unit = "rad/s", .about = "clockwise"},
                    {.name = "friction", .value = 0.3, .min = 0.05, .max = 2, .about = "of disc and ground"}},
     .variants = {{"mu=0.3", {}}, {"mu=0.8", {{"friction", 0.8}}}},
     .closed_form = "roll",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::spin_up

namespace plumb::scenarios::corner_spin {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double radius = 0.5;  // m

// rad/s^2. Sliding friction at the floor, mu N1, presses the disc on the wall, N2 = mu N1, and that at the wall, mu N2,
// lifts it: N1 + mu N2 = m g. Both brake: w' = -mu (N1 + N2) r/I = -2 mu (1 + mu) g/((1 + mu^2) r). (Irodov, Problems
// in General Physics, 1.259)
double braking(const Parameters& p) {
  const double mu = p.at("friction");
  return 2 * mu * (1 + mu) * gravity / ((1 + mu * mu) * radius);
}

double stops_at(const Parameters& p) { return p.at("spin") / braking(p); }  // s

double halfway(const Parameters& p) { return std::ceil(30 * stops_at(p)) / 60; }  // s

// Anticlockwise: its lowest point moves to the right, so that friction pushes it to the left, against the wall.
Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "corner-spin",
              .about = "A spinning disc is put in a corner, where both floor and wall brake it.",
              .gravity = {0, -gravity},
              .duration = 2 * halfway(p) + 0.5};
  scene.bodies.push_back(level_ground(rough));
  scene.bodies.push_back(half_space("wall", {.normal = {1, 0}, .offset = 0}, rough));
  Body spun = disc("disc", {radius, radius}, radius, rough);
  spun.angular_velocity = p.at("spin");
  scene.bodies.push_back(spun);
  return scene;
}

// Errors of the spin, each as of one contact:
//   arm         either contact point may be off by the gap, gap/r of the braking;
//   sinking     while the disc sinks in by the slop, friction is short of mu times it, at each contact;
//   iterations  floor and wall feed each other by mu, forth and back: mu^2 of an error is left in each;
//   lag         none: the blow that ends the fall of a lag has just the impulses that were missing. But the angle is
//               off by what was not yet braked, and by the drift.
std::vector<Expectation> expectations(const Parameters& p) {
  const double spin = p.at("spin");
  const double mu = p.at("friction");
  const double brakes = braking(p);
  const double stops = stops_at(p);
  const double end = scene(p).duration;
  const auto about = [=](const Stepping& s, double t) {
    const double left = s.iterations > 0 ? std::pow(mu, 2 * s.iterations) : 0;
    return brakes * t * (s.contact_gap() / radius + left) + 4 / radius * still_sinking(s, mu, t) +
           round_off(s, t, spin);
  };
  const auto turn = [=](const Stepping& s, double t) {
    return about(s, t) * t + drifted(s, brakes, t) + slid_late(s, brakes) + 4 / radius * mu * s.slop +
           round_off(s, t, spin * t);
  };
  const auto place = [=](const Stepping& s) {
    return s.contact_gap() + gravity * lag(s) * (lag(s) + s.h) + round_off(s, end, 1);
  };
  const auto rests = [=](const Stepping& s) { return 2 / radius * (s.creep + still_sinking(s, 1, end)); };
  const double t = halfway(p);
  return {
      {.body = "disc",
       .quantity = Quantity::angular_velocity,
       .time = t,
       .expected = spin - brakes * t,
       .allowed = [=](const Stepping& s) { return about(s, t); },
       .source = "w0 - 2 mu (1 + mu) g t/((1 + mu^2) r); lever arms off by the gap, sinking, iterations"},
      {.body = "disc",
       .quantity = Quantity::angle,
       .time = t,
       .expected = spin * t - brakes * t * t / 2,
       .allowed = [=](const Stepping& s) { return turn(s, t); },
       .source = "w0 t - w' t^2/2; contact a lag late, drift, lever arms"},
      {.body = "disc",
       .quantity = Quantity::angular_velocity,
       .expected = 0,
       .allowed = [=](const Stepping& s) { return rests(s) + round_off(s, end, spin); },
       .source = "at rest since w0/w'; creep at both contacts, and what still sinks in at one rolls on the other"},
      {.body = "disc",
       .quantity = Quantity::angle,
       .expected = spin * stops / 2,
       .allowed = [=](const Stepping& s) { return turn(s, stops) + 2 / radius * (s.creep * (end - stops) + s.slop); },
       .source = "w0^2/(2 w'); contact a lag late, drift, lever arms"},
      {.body = "disc",
       .quantity = Quantity::x,
       .expected = radius,
       .allowed = place,
       .source = "stays in the corner; gap, and the fall during a lag"},
      {.body = "disc",
       .quantity = Quantity::y,
       .expected = radius,
       .allowed = place,
       .source = "stays in the corner; gap, and the fall during a lag"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "corner-spin",
     .question = "Do floor and wall of a corner brake a spinning disc together as Coulomb says?",
     .parameters =
         {{.name = "spin", .value = 30, .min = 1, .max = 100, .unit = "rad/s", .about = "anticlockwise, at the start"},
          {.name = "friction", .value = 0.3, .min = 0.05, .max = 0.8, .about = "of disc, floor and wall"}},
     .variants = {{"mu=0.3", {}}, {"mu=0.6", {{"friction", 0.6}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::corner_spin
