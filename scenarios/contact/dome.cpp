#include <cmath>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/contact/rolls_off.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::dome {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double radius = 0.5;  // m, of the disc
constexpr double around = 2;    // m, between the centres while they touch
constexpr double flies = 0.2;   // s, for which it is watched once it has left

double start_of(const Parameters& p) { return p.at("angle") * degree; }

RollsOff disc_of(const Parameters& p) {
  return {.gravity = gravity, .around = around, .radius = radius, .friction = p.at("friction")};
}

RollsOff::Left slid(const Parameters& p, double until) { return disc_of(p).from({start_of(p), 0, 0}, until); }
RollsOff::Left leaves(const Parameters& p) { return slid(p, 100); }

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

// On the dome it is off as RollsOff says. In flight what was wrong in velocity moves it on, and the method drifts.
std::vector<Expectation> expectations(const Parameters& p) {
  const double mu = p.at("friction");
  const RollsOff of = disc_of(p);
  const RollsOff::Left end = leaves(p);
  const double w = of.growth();
  const double fastest = end.state[1];
  const auto turn = [=](const Stepping& s, double t, double reached) { return of.off(s, t, reached, fastest); };
  const double total = duration(p);
  const double flight = total - end.time;
  const double speed = around * fastest;
  const Vec velocity{speed * std::cos(end.state[0]), -speed * std::sin(end.state[0])};
  const Vec from{around * std::sin(end.state[0]), around * std::cos(end.state[0])};
  const double early = std::floor(60 * 0.8 * end.time) / 60;
  const RollsOff::State then = slid(p, early).state;
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
