#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::spring_stop {
namespace {

constexpr double duration = 2;   // s
constexpr double length = 2;     // m, of the spring
constexpr double radius = 0.25;  // m

// The wall touches the disc where the spring is at rest.
Scene scene(const Parameters& p) {
  const Surface of = surface(0, p.at("restitution"));
  Scene scene{.name = "spring-stop",
              .about = "A spring throws a disc at a wall again and again.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(half_space("wall", {.normal = {1, 0}, .offset = length - radius}, of));
  scene.bodies.push_back(disc("disc", {length + p.at("amplitude"), 0}, radius, of));
  const double w = p.at("frequency");
  scene.forces.push_back(Spring{.b = 1, .stiffness = mass_of(scene.bodies[1]).mass * w * w, .length = length});
  return scene;
}

// x = A e^n |cos w t| after n impacts, each a quarter of a period after a turning point and pi/w after the last (Shaw,
// Holmes 1983, a stop at the middle). With k = w f, f the interval of forces:
//   spring    half a step early or late for first-order methods, and a phase of k^2/24 w t;
//   impacts   found u late or early, the disc turns round by v u inside the wall, or outside, and takes u/e to come
//   out:
//             u (1 + 1/e) later, and a share of (w u)^2 (1 + 1/e^2) of the energy stays in the spring;
//             The step of an impact may take its force, at most w^2 v f, from anywhere within it: the force of before
//             the impact, k^2 v, may act after it, on e v;
//   energy    first-order methods keep E + drift k w x v, and turn v round where x is at most v u.
std::vector<Expectation> expectations(const Parameters& p) {
  const double w = p.at("frequency");
  const double e = p.at("restitution");
  const double amplitude = p.at("amplitude");
  const double mass = mass_of(scene(p).bodies[1]).mass;
  const double pi = std::numbers::pi;
  const int impacts = static_cast<int>(std::floor(w * duration / pi + 0.5));
  const double left = amplitude * std::pow(e, impacts);  // m, the amplitude at the end
  const double phase = w * duration;
  const double way = impacts % 2 == 0 ? 1 : -1;
  const auto speed_of = [=](int n) { return amplitude * w * std::pow(e, n); };  // m/s, before impact n + 1
  const auto round = [=](const Stepping& s) { return round_off(s, duration, length + amplitude * (1 + phase)); };
  const auto slow = [=](const Stepping& s) { return speed_of(impacts - 1) < s.restitution_threshold; };
  const auto late = [=](const Stepping& s) {  // rad
    double all = 0;
    for (int n = 0; n < impacts; ++n) all += w * found_off(s, speed_of(n)) * (1 + 1 / e);
    return all;
  };
  const auto grown = [=](const Stepping& s) {
    const double k = w * s.dt;
    return grows(s) ? std::pow(1 + k * k, duration / (2 * s.dt)) - 1 : 0;
  };
  const auto share = [=](const Stepping& s) {  // of the amplitude, by which a state is off
    const double k = w * force_interval(s);
    return std::abs(s.drift) * k + k * k / 24 * phase + k * k / 8 + impacts * k * k / e + late(s) + grown(s) +
           (slow(s) ? 1 : 0);
  };
  const auto energy = [=](const Stepping& s) {
    const double k = w * force_interval(s);
    double all = std::abs(s.drift) * k + k * k / 4 + grown(s) * (2 + grown(s)) + (slow(s) ? 1 : 0);
    for (int n = 0; n < impacts; ++n) {
      const double u = w * found_off(s, speed_of(n));
      all += 2 * k * k / e + u * u * (1 + 1 / (e * e)) + 2 * std::abs(s.drift) * k * u * (1 + e) / (e * e);
    }
    return all;
  };
  const double total = mass * w * w * left * left / 2;
  return {{.body = "disc",
           .quantity = Quantity::x,
           .expected = length + way * left * std::cos(phase),
           .allowed = [=](const Stepping& s) { return left * share(s) + round(s); },
           .source = "A e^n |cos w t|; the spring's phase, and impacts found late or early"},
          {.body = "disc",
           .quantity = Quantity::vx,
           .expected = -way * left * w * std::sin(phase),
           .allowed = [=](const Stepping& s) { return w * (left * share(s) + round(s)); },
           .source = "A e^n w sin w t; the spring's phase, and impacts found late or early"},
          {.quantity = Quantity::energy,
           .expected = total,
           .allowed = [=](const Stepping& s) { return total * energy(s) + 2 * mass * w * w * amplitude * round(s); },
           .source = "e^2 of the energy is left after each impact; what stays in the spring"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "spring-stop",
     .question = "Does a disc that a spring throws at a wall swing on with e^n of its amplitude?",
     .parameters = {{.name = "frequency", .value = 4.5, .min = 2.5, .max = 10, .unit = "rad/s", .about = "sqrt(k/m)"},
                    {.name = "amplitude", .value = 1.2, .min = 0.5, .max = 1.5, .unit = "m", .about = "at the start"},
                    {.name = "restitution", .value = 0.8, .min = 0.5, .max = 1, .about = "of disc and wall"}},
     .variants = {{"e=0.8", {}}, {"e=1", {{"restitution", 1}, {"frequency", 3.5}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::spring_stop
