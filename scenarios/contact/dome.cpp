#include <array>
#include <cmath>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/integrate.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::dome {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double radius = 0.5;  // m, of the disc
constexpr double around = 2;    // m, between the centres while they touch
constexpr double flies = 0.2;   // s, for which it is watched once it has left
constexpr double step = 1e-4;   // s, of the integration

// Angle of the line of centres from the vertical, its rate, and the disc's clockwise spin.
using State = std::array<double, 3>;

double load(const State& y) { return gravity * std::cos(y[0]) - around * y[1] * y[1]; }  // N/kg

bool sticks(const State& y, double mu) { return gravity * std::sin(y[0]) / 3 <= mu * load(y); }

State rate(const State& y, double mu, bool rolling) {
  const double pull = gravity * std::sin(y[0]);
  const double friction = rolling ? pull / 3 : mu * load(y);
  return {y[1], (pull - friction) / around, 2 * friction / radius};
}

struct Left {
  double time = 0;  // s
  State state{};
};

// Until a moment, or until nothing presses the disc on. A smooth disc leaves at cos = 2/3 cos0, one that rolled all
// the way at 4/7 cos0; with a finite mu it slips before, for there the load vanishes and friction does not.
Left slid(double start, double mu, double until) {
  Left now{0, {start, 0, 0}};
  bool rolling = sticks(now.state, mu);
  double h = step;
  while (h > 1e-15 && now.time < until) {
    const double takes = std::min(h, until - now.time);
    const State next = runge_kutta(now.state, takes, [&](const State& y) { return rate(y, mu, rolling); });
    const bool slips = rolling && !sticks(next, mu);
    if (load(next) < 0 || slips) {
      h /= 2;
      if (slips && h < 1e-12) {
        rolling = false;
        h = step;
      }
      continue;
    }
    now = {now.time + takes, next};
  }
  return now;
}

double start_of(const Parameters& p) { return p.at("angle") * degree; }

Left leaves(const Parameters& p) { return slid(start_of(p), p.at("friction"), 100); }

double duration(const Parameters& p) { return whole_steps(leaves(p).time + flies); }

Scene scene(const Parameters& p) {
  const double angle = start_of(p);
  const Surface of = surface(p.at("friction"), 0);
  Scene scene{.name = "dome",
              .about = "A disc is let go on top of a fixed one, a little to the side.",
              .gravity = {0, -gravity},
              .duration = duration(p)};
  scene.bodies = {fixed(disc("dome", {0, 0}, around - radius, of)),
                  disc("disc", {around * std::sin(angle), around * std::cos(angle)}, radius, of)};
  return scene;
}

// On the dome a'' = c w^2 sin a, w^2 = g/R. Errors grow at most as cosh(w t). With A the angle and W its rate when it
// leaves, an engine may until then be off by
//   first   half a step ahead or behind, a lag at the start, and, as forces and tangents are those of up to a step
//           earlier or later, w^2 h W in acceleration: h W (|drift| + w t/2);
//   gap     gap/R of the angle, and of w^2;
//   second  (w h)^2 of the angle and its phase;
//   stick   friction that is not known to the share creep/(g t).
// In flight what was wrong in velocity moves it on, and the method drifts.
std::vector<Expectation> expectations(const Parameters& p) {
  const double mu = p.at("friction");
  const Left end = leaves(p);
  const double w = std::sqrt(gravity / around);
  const double fastest = end.state[1];
  const auto turn = [=](const Stepping& s, double t, double reached) {
    const double growth = std::cosh(w * t);
    const double first = s.h * fastest * std::abs(s.drift) + lag(s) * (lag(s) + s.h) * w * w * growth +
                         (first_order_in_contact(s) ? s.h * fastest * w * t / 2 : 0);
    const double gap = s.contact_gap() / around * (growth + w * t) + mu * s.slop / around;
    const double second = w * s.h * w * s.h * (reached + fastest * t);
    return first + gap + second + s.creep * t / around + round_off(s, t, 1 + fastest * t) * growth;
  };
  const double total = duration(p);
  const double flight = total - end.time;
  const double speed = around * fastest;
  const Vec velocity{speed * std::cos(end.state[0]), -speed * std::sin(end.state[0])};
  const Vec from{around * std::sin(end.state[0]), around * std::cos(end.state[0])};
  const double early = std::floor(60 * 0.8 * end.time) / 60;
  const State then = slid(start_of(p), mu, early).state;
  const auto moves = [=](const Stepping& s) { return around * w * turn(s, end.time, end.state[0]); };
  const auto lands = [=](const Stepping& s) {
    return around * turn(s, end.time, end.state[0]) + s.contact_gap() + moves(s) * flight +
           drifted(s, gravity, flight) + round_off(s, total, around + speed * total);
  };
  const std::string law = mu == 0 ? "slides off at cos = 2/3 cos0" : "rolls, slips and leaves where the load is 0";
  std::vector<Expectation> all;
  all.push_back({.body = "disc",
                 .quantity = Quantity::x,
                 .time = early,
                 .expected = around * std::sin(then[0]),
                 .allowed = [=](const Stepping& s) { return around * turn(s, early, then[0]) + s.contact_gap(); },
                 .source = "on the dome, R a'' = g sin a - f"});
  all.push_back({.body = "disc",
                 .quantity = Quantity::vx,
                 .expected = velocity.x,
                 .allowed = moves,
                 .source = law + ", with v^2 = g R cos a; then in free flight"});
  all.push_back({.body = "disc",
                 .quantity = Quantity::angular_velocity,
                 .expected = -end.state[2],
                 .allowed =
                     [=](const Stepping& s) {
                       return mu == 0 ? round_off(s, total, speed / radius)
                                      : 2 / radius * moves(s) + speed / radius * s.contact_gap() / radius;
                     },
                 .source = mu == 0 ? "a smooth dome turns nothing" : "the integral of 2 f/r while it rolls and slips"});
  all.push_back({.body = "disc",
                 .quantity = Quantity::x,
                 .expected = from.x + velocity.x * flight,
                 .allowed = lands,
                 .source = law + "; then in free flight"});
  all.push_back({.body = "disc",
                 .quantity = Quantity::y,
                 .expected = from.y + velocity.y * flight - gravity * flight * flight / 2,
                 .allowed = lands,
                 .source = law + "; then in free flight"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "dome",
     .question = "Does a disc leave a dome where its weight no longer bends its path: smooth at 2/3 of the cosine?",
     .parameters =
         {{.name = "angle", .value = 20, .min = 10, .max = 45, .unit = "deg", .about = "of the start, from the top"},
          {.name = "friction", .value = 0, .min = 0, .max = 20, .about = "of disc and dome"}},
     .variants =
         {{"smooth", {}}, {"steep", {{"angle", 40}}}, {"rolls", {{"friction", 10}}}, {"slips", {{"friction", 0.3}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::dome
