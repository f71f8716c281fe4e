#include "scenarios/friction/leaning_ladder.h"

#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double half = 2;      // m, from the centre to either end
constexpr double belly = 0.1;   // m, from the centre to either side

Body ladder(double angle, double friction) {
  return {.name = "ladder",
          .position = {half * std::cos(angle), half * std::sin(angle)},
          .angle = -angle,
          .shapes = {{.geometry = Polygon{{{half, 0}, {0, belly}, {-half, 0}, {0, -belly}}},
                      .surface = surface(friction, 0)}}};
}

}  // namespace

double ladder_half() { return half; }

double ladder_gyration() {
  const Mass mass = mass_of(ladder(0, 0));
  return mass.inertia / mass.mass + half * half;
}

Scene leaning_ladder(double angle, double friction, double duration) {
  Scene scene{.gravity = {0, -gravity}, .duration = duration};
  Body wall = level_ground(surface(0, 0));
  wall.name = "wall";
  wall.shapes[0].geometry = HalfSpace{.normal = {1, 0}};
  scene.bodies = {level_ground(surface(friction, 0)), wall, ladder(angle, friction)};
  return scene;
}

// From rest a'' = -(g l (cos a - 2 mu sin a) + 2 mu l^2 sin^2 a a'^2)/(I/m + l^2 (1 - mu sin 2a)), until the head
// leaves the wall: at sin a = (2/3) sin a0 without friction, and no earlier with it. The pull p = g l cos a/(I/m + l^2)
// of a frictionless foot, largest there, is never exceeded, so that the head is at the wall for sqrt(2 (a0 - a)/p) at
// least. Errors grow like cosh(q t), sinh(q t)/q with q^2 = g l (1 + 2 mu)/(I/m + l^2 (1 - mu)), the most its slope in
// a can be; with W <= p t the speed at the end:
//   start    both ends off by the gap: 2 gap/l;
//   contact  noticed a lag late: the speed g lag of a free fall may all become a turn, g lag/l;
//   first    the method's drift makes it half a step early or late: 2 |drift| h W;
//   lost     contacts are found once a step and let the ends go along their tangents, which takes (W dt)^2/2 of the
//            speed, t/dt times;
//   second   a phase of (q h)^2/24 q t.
// Standing, friction takes the lag's speed away again with what it has in hand, p' = g l (2 mu sin a - cos a)/(...);
// and it may creep.
std::vector<Expectation> leaning_ladder_expectations(double angle, double friction, double latest) {
  const bool stands = 2 * friction * std::tan(angle) >= 1;
  const double leaves = std::asin(2 * std::sin(angle) / 3);
  const double pull = gravity * half * std::cos(leaves) / ladder_gyration();
  const double at_the_wall = std::floor(60 * std::sqrt(2 * (angle - leaves) / pull)) / 60;  // s, on the usual grid
  const double time = stands ? latest : std::min(latest, at_the_wall);
  const double q = std::sqrt(gravity * half * (1 + 2 * friction) / (ladder_gyration() - half * half * friction));
  const double grown = std::sinh(q * time) / q;
  const double fastest = pull * time;
  const double in_hand = gravity * half * (2 * friction * std::sin(angle) - std::cos(angle)) / ladder_gyration();

  const auto turn = [=](const Stepping& s) {
    const double kick = gravity * lag(s) / half;
    const double round = round_off(s, time, 4 * half + gravity * time * time);
    if (stands) return 2 * s.gap / half + kick * (kick / (2 * in_hand) + s.h) + s.creep * time / half + round;
    const double lost = (angle - leaves) * fastest * fastest * s.dt * time / 2;
    const double second = q * q * s.h * s.h / 24 * fastest * time;
    return (2 * s.gap / half + second + round) * std::cosh(q * time) + kick * grown +
           2 * std::abs(s.drift) * s.h * fastest + lost;
  };
  const auto place = [=](const Stepping& s) { return half * turn(s) + s.gap; };
  const std::string law = stands ? "stands, as tan a >= 1/(2 mu)" : "slides, as tan a < 1/(2 mu)";
  const std::string why = stands ? "; a gap, a lag that friction makes good" : "; a gap and a lag at the start, drift";
  std::vector<Expectation> all;
  for (const Quantity quantity : {Quantity::angle, Quantity::x, Quantity::y}) {
    const bool angular = quantity == Quantity::angle;
    all.push_back({.body = "ladder",
                   .quantity = quantity,
                   .time = time,
                   .allowed = angular ? std::function<double(const Stepping&)>(turn) : place,
                   .source = law + why + (angular ? "" : ", times l")});
  }
  return all;
}

}  // namespace plumb
