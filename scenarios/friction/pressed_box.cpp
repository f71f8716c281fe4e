#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::pressed_box {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 1;  // s
constexpr double size = 1;      // m, of the square box

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "pressed-box",
              .about = "A constant force presses a box on a wall.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(half_space("wall", {.normal = {1, 0}, .offset = 0}, rough));
  scene.bodies.push_back(box("box", {size / 2, 0}, {size, size}, rough));
  const double mass = mass_of(scene.bodies[1]).mass;
  scene.forces.push_back(Constant{.body = 1, .force = {-mass * p.at("press"), 0}});
  return scene;
}

// It sticks if mu F > m g, else falls with g - mu F/m. Friction acts half a box beside the centre, so that the wall's
// push moves down by at most mu times that and never leaves the box's side, as mu < 1.
//   Contact   may be found a lag late; the blow that ends the approach then has the impulses that were missing.
//   Sinking   in by the slop, at the speed u, leaves friction short of mu times u: on average mu slop/t. Of one that
//             sticks, what mu slop/h has let slip stops within its square over twice the margin mu F/m - g.
//   Speed     of one that slips: it may also lean by the gap at both ends, gap/size of the push. Of one that sticks: it
//             creeps, friction bears all of gravity.
//   Position  these over time, the drift, the fall before the contact, and the gap.
std::vector<Expectation> expectations(const Parameters& p) {
  const double mu = p.at("friction");
  const double press = p.at("press");
  const bool sticks = mu * press > gravity;
  const double falls = sticks ? 0 : gravity - mu * press;
  const double t = duration;
  const double reach = size + press * t * t;
  const auto speed = [=](const Stepping& s) {
    const double lean = 2 * s.contact_gap() / size;
    return (sticks ? s.creep : press * lean * t) + still_sinking(s, mu, t) + round_off(s, t, reach);
  };
  const auto slipped = [=](const Stepping& s) {
    const double let_go = s.h > 0 ? mu * s.slop / s.h : 0;
    return sticks ? let_go * let_go / (2 * (mu * press - gravity)) : 0;
  };
  const auto place = [=](const Stepping& s) {
    return speed(s) * t + drifted(s, falls, t) + slid_late(s, gravity) + slipped(s) + (1 + mu) * s.contact_gap() +
           round_off(s, t, reach);
  };
  return {{.body = "box",
           .quantity = Quantity::vy,
           .expected = -falls * t,
           .allowed = speed,
           .source = sticks ? "sticks, as mu F > m g; creep" : "(g - mu F/m) t; sinking, lean"},
          {.body = "box",
           .quantity = Quantity::y,
           .expected = -falls * t * t / 2,
           .allowed = place,
           .source = sticks ? "sticks, as mu F > m g; contact a lag late, gap, creep"
                            : "(g - mu F/m) t^2/2; contact a lag late, drift, gap"},
          {.body = "box",
           .quantity = Quantity::angle,
           .expected = 0,
           .allowed = [=](const Stepping& s) { return 2 * s.contact_gap() / size + round_off(s, t, reach); },
           .source = "its side stays on the wall; the gap at both ends"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "pressed-box",
     .question = "Does a box pressed on a wall stick if and only if friction can carry its weight?",
     .parameters =
         {{.name = "press", .value = 20, .min = 0.1, .max = 100, .unit = "m/s^2", .about = "force divided by mass"},
          {.name = "friction", .value = 0.7, .min = 0, .max = 0.8, .about = "of box and wall"}},
     .variants = {{"sticks", {}}, {"falls", {{"friction", 0.2}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::pressed_box
