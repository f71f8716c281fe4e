#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::limiting_friction {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s
const Vec size{1, 0.5};         // m; too low to tip: mu < b/h = 2

double pull(const Parameters& p) { return p.at("static") * gravity * (1 + p.at("margin")); }

Scene scene(const Parameters& p) {
  Surface rough = surface(p.at("static"), 0);
  rough.dynamic_friction = p.at("dynamic");
  Scene scene{.name = "limiting-friction",
              .about = "A resting box is pulled with almost exactly the largest force that friction can balance.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  const Body pulled = box("box", {0, size.y / 2}, size, rough);
  scene.forces.push_back(Constant{.body = 1, .force = {pull(p) * mass_of(pulled).mass, 0}});
  scene.bodies.push_back(pulled);
  return scene;
}

// Rests iff pull <= mu_s g; otherwise it accelerates from the start by pull - mu_d g, so that a small error of mu_s
// becomes a large distance. Load and friction are late by the same share of a step, so only what they do not share can
// decide otherwise: what the iterations leave of the one that is solved first. Where that exceeds the margin, a method
// may do either. Besides:
//   Contact may be found a lag late: until then nothing brakes the box, which the impact makes up for.
//   Position: the drift of its acceleration. While the box sinks in by the slop friction is late by mu times that; and
//     one end may be deeper by the slop, which moves its centre by slop (height/length)/2.
//   The box at rest may creep, by the share of its friction in gravity.
std::vector<Expectation> expectations(const Parameters& p) {
  const bool rests = p.at("margin") <= 0;
  const double mu = rests ? p.at("static") : p.at("dynamic");
  const double sliding = pull(p) - p.at("dynamic") * gravity;
  const double a = rests ? 0 : sliding;
  const double late = rests ? pull(p) : mu * gravity;  // m/s^2, while there is no friction
  const double end = duration;
  const double reach = gravity * end * end;
  const double margin = std::abs(p.at("margin"));
  const auto creep = [=, share = pull(p) / gravity](const Stepping& s) { return rests ? s.creep * share : 0; };
  const auto either = [=](const Stepping& s) { return unsolved(s, 2) > margin ? sliding : 0; };  // m/s^2
  const auto speed = [=](const Stepping& s) { return creep(s) + either(s) * end + round_off(s, end, gravity * end); };
  const auto place = [=](const Stepping& s) {
    return slid_late(s, late) + creep(s) * end + either(s) * end * end / 2 + drifted(s, a, end) +
           (mu + size.y / size.x / 2) * s.slop + round_off(s, end, reach);
  };
  return {{.body = "box",
           .quantity = Quantity::vx,
           .expected = a * end,
           .allowed = speed,
           .source = "0 up to mu_s g, else (pull - mu_d g) t; may creep at rest"},
          {.body = "box",
           .quantity = Quantity::x,
           .expected = a * end * end / 2,
           .allowed = place,
           .source = "0 up to mu_s g, else (pull - mu_d g) t^2/2; contact a lag late, drift, penetration"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "limiting-friction",
     .question = "Does a resting box break away at the limit of static friction, and not before?",
     .parameters =
         {{.name = "static", .value = 0.6, .min = 0.5, .max = 1.5, .about = "coefficient of friction while sticking"},
          {.name = "dynamic", .value = 0.3, .min = 0, .max = 0.45, .about = "coefficient of friction while sliding"},
          {.name = "margin",
           .value = 5e-5,
           .min = -0.05,
           .max = 0.05,
           .about = "by which the pull exceeds the limit, relative to it"}},
     .variants = {{"holds", {{"margin", -5e-5}}}, {"breaks", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::limiting_friction
