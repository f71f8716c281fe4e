#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::soft_joint {
namespace {

constexpr double length = 1.5;  // m, of the joint at rest

// The stretch of a damped oscillator that is let go: s'' + 2 c w s' + w^2 s = 0.
struct Stretch {
  double w, damping, amplitude;  // rad/s, of the critical one, m

  explicit Stretch(const Parameters& p)
      : w(p.at("frequency")), damping(p.at("damping")), amplitude(p.at("amplitude")) {}

  double swings() const { return w * std::sqrt(1 - damping * damping); }  // rad/s
  double left(double t) const { return amplitude * std::exp(-damping * w * t); }
  double at(double t) const {
    return left(t) * (std::cos(swings() * t) + damping * w / swings() * std::sin(swings() * t));
  }
  double rate(double t) const { return -left(t) * w * w / swings() * std::sin(swings() * t); }
};

double duration(const Stretch& stretch) { return whole_steps(3 * std::numbers::pi / stretch.swings()); }

// Two free discs, the right one `ratio` times as heavy. Their centre of mass stays at the origin.
Scene scene(const Parameters& p) {
  const Stretch stretch(p);
  const double ratio = p.at("ratio");
  Scene scene{.name = "soft-joint",
              .about = "Two discs on a soft distance joint are let go apart.",
              .gravity = {0, 0},
              .duration = duration(stretch)};
  const double apart = length + stretch.amplitude;
  scene.bodies = {disc("left", {-ratio / (1 + ratio) * apart, 0}, 0.25, {}),
                  disc("right", {1 / (1 + ratio) * apart, 0}, 0.25, surface(0, 0, ratio))};
  const double mass = mass_of(scene.bodies[0]).mass * ratio / (1 + ratio);  // the reduced mass
  scene.joints = {Distance{.a = 0,
                           .b = 1,
                           .anchor_a = scene.bodies[0].position,
                           .anchor_b = scene.bodies[1].position,
                           .length = length,
                           .stiffness = mass * stretch.w * stretch.w,
                           .damping = 2 * mass * stretch.damping * stretch.w}};
  return scene;
}

// The characteristic numbers z = w (-c +- i sqrt(1 - c^2)) have the size w. With k = w f, f the interval of forces:
//   first     Euler's methods, explicit, implicit and in between, take z + z^2 h/2 at most for z: k/2 w t of the
//             amplitude, and growing ones e^(k/2 w t); symplectic ones are half a step ahead or behind besides;
//   second    z + z^3 h^2/12 (trapezoidal rule; Verlet half of that): k^2/12 w t, and k^2/8 within a step.
std::vector<Expectation> expectations(const Parameters& p) {
  const Stretch stretch(p);
  const double ratio = p.at("ratio");
  const double w = stretch.w;
  const Scene built = scene(p);
  const double mass = mass_of(built.bodies[0]).mass * ratio / (1 + ratio);
  const double end = built.duration;
  const auto share = [=](const Stepping& s, double t) {
    const double k = w * force_interval(s);
    const double first = first_order(s) ? std::expm1(k / 2 * w * t) + std::abs(s.drift) * k : 0;
    return first + k * k / 12 * w * t + k * k / 8;
  };
  const double quarter = whole_steps(std::numbers::pi / (2 * stretch.swings()));
  std::vector<Expectation> all;
  for (const double t : {quarter, end}) {
    const double rounded = (length + stretch.amplitude) * (1 + w * t);
    for (const char* body : {"left", "right"}) {
      const double part = body == std::string("left") ? -ratio / (1 + ratio) : 1 / (1 + ratio);
      all.push_back({.body = body,
                     .quantity = Quantity::x,
                     .time = t,
                     .expected = part * (length + stretch.at(t)),
                     .allowed =
                         [=](const Stepping& s) {
                           return std::abs(part) * stretch.amplitude * share(s, t) + round_off(s, t, rounded);
                         },
                     .source = "A e^(-c w t) cos(w' t - ...), w^2 = k (1/m1 + 1/m2); the method's order"});
    }
    const double most = mass * w * w * stretch.amplitude * stretch.amplitude / 2;
    const double stretched = w * stretch.at(t);
    all.push_back({.quantity = Quantity::energy,
                   .time = t,
                   .expected = mass * (stretched * stretched + stretch.rate(t) * stretch.rate(t)) / 2,
                   .allowed =
                       [=](const Stepping& s) {
                         return most * share(s, t) * (2 + share(s, t)) +
                                mass * w * w * stretch.amplitude * round_off(s, t, rounded);
                       },
                   .source = "falls about as e^(-2 c w t); twice the share of the amplitude"});
  }
  all.push_back({.body = "right",
                 .quantity = Quantity::vx,
                 .time = quarter,
                 .expected = stretch.rate(quarter) / (1 + ratio),
                 .allowed =
                     [=](const Stepping& s) {
                       return w * (stretch.amplitude * share(s, quarter) / (1 + ratio) +
                                   round_off(s, quarter, length + stretch.amplitude * (1 + w * quarter)));
                     },
                 .source = "its derivative; the method's order"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "soft-joint",
     .question = "Does a soft distance joint swing and die out with the stiffness and damping of the scene?",
     .parameters =
         {{.name = "frequency", .value = 2, .min = 0.1, .max = 20, .unit = "rad/s", .about = "sqrt(k/m), undamped"},
          {.name = "damping", .value = 0.1, .min = 0, .max = 0.8, .about = "as a share of the critical one"},
          {.name = "ratio", .value = 3, .min = 0.1, .max = 10, .about = "mass of the right disc over that of the left"},
          {.name = "amplitude", .value = 0.8, .min = 0.1, .max = 1, .unit = "m", .about = "at the start"}},
     .variants = {{"damped", {}},
                  {"undamped", {{"damping", 0}}},
                  {"strongly", {{"damping", 0.5}, {"frequency", 5}}},
                  {"slowly", {{"damping", 0.7}, {"frequency", 0.15}, {"amplitude", 1}, {"ratio", 10}}}},
     .scene = scene,
     .expectations = expectations,
     .smoothness = [](const Parameters&) { return Smoothness::free; }}};

}  // namespace
}  // namespace plumb::scenarios::soft_joint
