#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::grazing {
namespace {

constexpr double length = 3;     // m, of the spring at rest
constexpr double radius = 0.25;  // m
constexpr double stop = 1;       // m, from where the spring is at rest to where the disc meets the wall
constexpr int impacts = 2;

// A disc on a spring swings by A_n after n impacts on a wall at d: it meets it with v^2 = w^2 (A^2 - d^2) and leaves it
// with e v, so that A^2 - d^2 = e^(2n) (A_0^2 - d^2) (Shaw, Holmes, J. Sound Vib. 90, 1983). The square root makes the
// time of a grazing impact sensitive, and never the amplitude after it.
struct Swing {
  double w, e, first;  // rad/s; m, the amplitude at the start

  explicit Swing(const Parameters& p) : w(p.at("frequency")), e(p.at("restitution")), first(p.at("reach") * stop) {}

  bool touches() const { return first > stop; }
  double square(int n) const {  // m^2
    return touches() ? stop * stop + std::pow(e, 2 * n) * (first * first - stop * stop) : first * first;
  }
  double speed(int n) const {
    return w * std::sqrt(std::max(square(n) - stop * stop, 0.0));
  }  // m/s, before impact n + 1
  double phase(int n) const { return touches() ? std::acos(stop / std::sqrt(square(n))) : 0; }  // rad, from there to A

  // s, of impact n, counted from 1, from the turning point on the other side; without impacts, of the n-th approach.
  double impact(int n) const {
    double time = (std::numbers::pi - phase(0)) / w;
    for (int i = 1; i < n; ++i) time += (2 * std::numbers::pi - 2 * phase(i)) / w;
    return time;
  }

  // m, from where the spring is at rest, before impact n + 1 and after impact n.
  double at(double t, int n) const {
    const double since = n == 0 ? std::numbers::pi : phase(n) - w * impact(n);
    return std::sqrt(square(n)) * std::cos(w * t + since);
  }
};

// At the end the disc is at the turning point after the last impact.
double turned_back(const Swing& swing, int n) {
  return swing.impact(n) + (std::numbers::pi - swing.phase(n)) / swing.w;
}

Scene scene(const Parameters& p) {
  const Swing swing(p);
  const Surface of = surface(0, swing.e);
  Scene scene{.name = "grazing",
              .about = "A disc on a spring just reaches a wall, or just does not.",
              .gravity = {0, 0},
              .duration = whole_steps(turned_back(swing, impacts))};
  scene.bodies.push_back(half_space("wall", {.normal = {-1, 0}, .offset = -stop - radius}, of));
  scene.bodies.push_back(disc("disc", {-swing.first, 0}, radius, of));
  scene.forces.push_back(Spring{.b = 1,
                                .anchor_a = {-length, 0},
                                .stiffness = mass_of(scene.bodies[1]).mass * swing.w * swing.w,
                                .length = length});
  return scene;
}

// With k = w f, f the interval of forces, the square of the amplitude is off by
//   spring   |drift| k + k^2/4 of it, as methods conserve another energy (see spring), and by its growth;
//   impact   found where the disc is d off, a lag deep, d = v u + A (w u)^2/2, or by the gap: e^2 A^2 + (1 - e^2) d^2
//            is left, so 2 (1 - e^2) stop d;
//   force    the step of an impact may take its force, w^2 stop, from anywhere within it: w^2 stop f/2 (1 + e) of the
//            speed after it, e (1 + e) stop k v/w; with a drift the kept energy changes by twice as much;
//   slow     below the restitution threshold all of e^2 (A^2 - stop^2) is lost.
// Each impact leaves e^2 of what was off before. An impact is then off by half of that, and d, over sqrt(A^2 - stop^2)
// in time, by no more than the phase of all the wall's time, twice: the turning point moves by half the square of the
// sum. Where the disc just does not reach the wall, it may still touch it within all of these.
std::vector<Expectation> expectations(const Parameters& p) {
  const Swing swing(p);
  const double w = swing.w;
  const double e = swing.e;
  const double mass = mass_of(scene(p).bodies[1]).mass;
  const double end = scene(p).duration;
  const double reach = length + swing.first * (1 + w * end);
  struct Off {
    double square = 0, phase = 0;  // m^2, rad
  };
  const auto off = [=](const Stepping& s, int count) {
    const double k = w * force_interval(s);
    const double grown = grows(s) ? std::pow(1 + k * k, end / force_interval(s)) - 1 : 0;
    const double spring = std::abs(s.drift) * k + k * k / 4 + grown;
    const double rounded = 2 * swing.first * round_off(s, end, reach);
    Off sum{swing.square(0) * spring + rounded, k * k / 24 * w * end};
    for (int n = 0; n < count; ++n) {
      const double before = swing.square(n);
      const double fastest = swing.touches() ? swing.speed(n) : w * std::sqrt(before * spring);
      const double found = fastest * lag(s) + std::sqrt(before) * std::pow(w * lag(s), 2) / 2 + s.contact_gap();
      const bool may_touch = swing.touches() || swing.first + found + swing.first * spring > stop;
      if (!may_touch) continue;
      const double slow = fastest < s.restitution_threshold ? e * e * (before - stop * stop) : 0;
      const double forces = e * (1 + e) * stop * k * fastest / w * (1 + 4 * std::abs(s.drift));
      const double now = e * e * sum.square + 2 * (1 - e * e) * stop * found + std::abs(slow) + forces;
      const double root = std::sqrt(std::max(before - stop * stop, 0.0));
      const double most = swing.touches() ? swing.phase(n) : std::acos(std::min(stop / (stop + found), 1.0));
      sum.phase += 2 * (root > 0 ? std::min((sum.square / 2 + stop * found) / (stop * root), most) : most) + w * lag(s);
      sum.square = now + before * spring;
    }
    return sum;
  };
  std::vector<Expectation> all;
  for (const int n : {1, impacts}) {
    const double t = std::floor(60 * turned_back(swing, n)) / 60;
    const double size = std::sqrt(swing.square(n));
    all.push_back({.body = "disc",
                   .quantity = Quantity::x,
                   .time = t,
                   .expected = swing.at(t, swing.touches() ? n : 0),
                   .allowed =
                       [=](const Stepping& s) {
                         const Off now = off(s, n);
                         const double phase = std::abs(s.drift) * w * s.h + now.phase + w / 60;  // a frame early
                         return now.square / (2 * size) + size * (1 - std::cos(std::min(phase, std::numbers::pi))) -
                                size * (1 - std::cos(w / 60)) + round_off(s, t, reach);
                       },
                   .source = "Shaw, Holmes (1983): turns back where A^2 - d^2 is e^(2n) of the first; impacts found "
                             "off, the spring's energy"});
    all.push_back({.quantity = Quantity::energy,
                   .time = t,
                   .expected = mass * w * w * swing.square(n) / 2,
                   .allowed = [=](const Stepping& s) { return mass * w * w / 2 * off(s, n).square; },
                   .source = "of that amplitude; impacts found off, the spring's energy"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "grazing",
     .question = "Does a disc on a spring that just reaches a wall lose what a grazing impact takes, and else nothing?",
     .parameters = {{.name = "reach",
                     .value = 1.2,
                     .min = 0.9,
                     .max = 1.4,
                     .about = "amplitude at the start over the distance of the wall"},
                    {.name = "frequency", .value = 4, .min = 2, .max = 6, .unit = "rad/s", .about = "sqrt(k/m)"},
                    {.name = "restitution", .value = 0.5, .min = 0.2, .max = 0.9, .about = "of disc and wall"}},
     .variants = {{"touches", {}}, {"misses", {{"reach", 0.98}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::grazing
