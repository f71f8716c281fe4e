#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/friction/leaning_ladder.h"
#include "scenarios/parts.h"

namespace plumb::scenarios::sliding_ladder {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double after = 0.75;  // s, it has left and not yet landed

Scene scene(const Parameters& p) {
  Scene scene = leaning_ladder(p.at("angle") * degree, 0, after);
  scene.name = "sliding-ladder";
  scene.about = "A ladder slides down a smooth wall, on a smooth floor.";
  return scene;
}

// The head leaves where sin a = (2/3) sin a0, with a'^2 = 2 w^2 (sin a0 - sin a), w^2 = g l/(I/m + l^2); from then on
// nothing pushes along the floor and the centre keeps l sin a a'. That is the most that x' ever comes to, so that an
// error in a or in time is of second order there. The speed is off by the lag's g lag at the start, by the method's
// drift in the energy, and by what steps along the tangent lose: (W dt)^2/2 of it, t/dt times. Contacts are settled
// once a step: it may leave a step early or late, and one step's push of the wall, at most that of the start, w^2 l sin
// a0 cos a0 dt, be missing or too much.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  std::vector<Expectation> all = leaning_ladder_expectations(angle, 0, after);
  const double high = std::sin(angle);
  const double w = std::sqrt(gravity * ladder_half() / ladder_gyration());
  const double fastest = w * std::sqrt(2 * high / 3);
  const double speed = ladder_half() * fastest * 2 / 3 * high;
  const auto allowed = [=](const Stepping& s) {
    const double lost = fastest * fastest * s.dt * after / 2;
    const double push = w * w * ladder_half() * high * std::cos(angle);
    return push * s.dt + gravity * (lag(s) + 2 * std::abs(s.drift) * s.h) + speed * (lost + s.gap / ladder_half()) +
           round_off(s, after, speed + gravity * after);
  };
  all.push_back({.body = "ladder",
                 .quantity = Quantity::vx,
                 .expected = speed,
                 .allowed = allowed,
                 .source = "leaves the wall at sin a = (2/3) sin a0 and keeps l sin a a'; a lag, drift"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "sliding-ladder",
     .question = "Does a ladder on smooth ground leave the wall when its head is down to two thirds of its height?",
     .parameters = {{.name = "angle", .value = 60, .min = 50, .max = 70, .unit = "deg", .about = "above the level"}},
     .variants = {{"60deg", {}}},
     .closed_form = "ladder",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::sliding_ladder
