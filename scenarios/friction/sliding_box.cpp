#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::stopping_distance {
namespace {

constexpr double gravity = 10;  // m/s^2
const Vec size{1, 0.5};         // m; too low to tip: mu < b/h = 2

double stop(const Parameters& p) { return p.at("speed") / (p.at("friction") * gravity); }

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "stopping-distance",
              .about = "A box slides over level ground until friction stops it.",
              .gravity = {0, -gravity},
              .duration = std::ceil(stop(p)) + 1};
  scene.bodies.push_back(level_ground(rough));
  Body sliding = box("box", {0, size.y / 2}, size, rough);
  sliding.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(sliding);
  return scene;
}

// It stops after v/(mu g) at v^2/(2 mu g). Contact may be found a lag late. The drift of the deceleration is
// drift (mu g) (v/(mu g)) h. A method that resolves nothing within a step
// - applies the step in which it stops as a whole: with a fraction u of the step left until the stop, friction over the
//   whole step moves the box mu g h^2 (1 - u)^2/2 too far, and in the next step, until friction is seen to push a
//   body at rest, u mu g h^2/2 back: together less than mu g h^2/2;
// - and lets the box sink in by the slop, during which friction is late by mu times that; while it brakes one end may
//   be deeper by the slop, which moves its centre, at half its height, by slop (height/length)/2.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double end = scene(p).duration;
  const double reach = v * v / (2 * p.at("friction") * gravity) + v * end;
  const double mu = p.at("friction");
  const auto place = [=](const Stepping& s) {
    return v * std::abs(s.drift) * s.h + slid_late(s, mu * gravity) + mu * gravity * s.h * s.h / 2 +
           (mu + size.y / size.x / 2) * s.slop + round_off(s, end, reach);
  };
  const auto speed = [=](const Stepping& s) { return round_off(s, end, v); };
  return {{.body = "box",
           .quantity = Quantity::x,
           .allowed = place,
           .source = "v^2/(2 mu g); contact a lag late, drift, the step in which it stops, penetration"},
          {.body = "box",
           .quantity = Quantity::speed,
           .allowed = speed,
           .source = "at rest after v/(mu g), on level ground without creep"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "stopping-distance",
     .question = "Does a sliding box stop where Coulomb friction has used up its energy?",
     .parameters = {{.name = "speed", .value = 5, .min = 0.1, .max = 20, .unit = "m/s", .about = "at the start"},
                    {.name = "friction", .value = 0.3, .min = 0.1, .max = 1.5, .about = "of box and ground"}},
     .variants = {{"mu=0.3", {}}, {"mu=0.8", {{"friction", 0.8}}}},
     .closed_form = "slide",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::stopping_distance

namespace plumb::scenarios::breakaway {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s
const Vec size{1, 0.5};         // m; too low to tip: mu < b/h = 2

Scene scene(const Parameters& p) {
  Surface rough = surface(p.at("static"), 0);
  rough.dynamic_friction = p.at("dynamic");
  Scene scene{.name = "breakaway",
              .about = "A box on level ground is pulled with a force between its sliding and its sticking friction.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  Body pulled = box("box", {0, size.y / 2}, size, rough);
  pulled.velocity = {p.at("speed"), 0};
  scene.forces.push_back(Constant{.body = 1, .force = {p.at("pull") * mass_of(pulled).mass, 0}});
  scene.bodies.push_back(pulled);
  return scene;
}

// At rest it stays, as pull <= mu_s g; once moving it accelerates all the time, by pull - mu_d g > 0.
//   Contact may be found a lag late: until then nothing brakes the box, which the impact makes up for.
//   Position: the drift of its acceleration. While the box sinks in by the slop friction is late by mu times that; and
//     one end may be deeper by the slop, which moves its centre by slop (height/length)/2.
//   The box at rest may creep, by the share of its friction in gravity.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double mu = v > 0 ? p.at("dynamic") : p.at("static");
  const double a = v > 0 ? p.at("pull") - p.at("dynamic") * gravity : 0;
  const double late = v > 0 ? mu * gravity : p.at("pull");  // m/s^2, while there is no friction
  const double end = duration;
  const double reach = v * end + gravity * end * end;
  const auto creep = [=, pull = p.at("pull")](const Stepping& s) { return v > 0 ? 0 : s.creep * pull / gravity; };
  const auto speed = [=](const Stepping& s) {
    return creep(s) + (v > 0 ? still_sinking(s, mu, end) : 0) + round_off(s, end, v + gravity * end);
  };
  const auto place = [=](const Stepping& s) {
    return slid_late(s, late) + creep(s) * end + drifted(s, a, end) + (mu + size.y / size.x / 2) * s.slop +
           round_off(s, end, reach);
  };
  return {{.body = "box",
           .quantity = Quantity::vx,
           .expected = v + a * end,
           .allowed = speed,
           .source = "sticks up to mu_s, slides with mu_d; may creep at rest"},
          {.body = "box",
           .quantity = Quantity::x,
           .expected = v * end + a * end * end / 2,
           .allowed = place,
           .source = "v t + (pull - mu_d g) t^2/2, or 0 at rest; contact a lag late, drift, penetration"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "breakaway",
     .question =
         "Does a pull between sliding and sticking friction leave a resting box at rest and accelerate a sliding one?",
     .parameters =
         {{.name = "static", .value = 0.6, .min = 0.55, .max = 1.5, .about = "coefficient of friction while sticking"},
          {.name = "dynamic", .value = 0.3, .min = 0, .max = 0.45, .about = "coefficient of friction while sliding"},
          {.name = "pull", .value = 5, .min = 4.6, .max = 5.4, .unit = "m/s^2", .about = "force divided by mass"},
          {.name = "speed", .value = 0, .min = 0, .max = 20, .unit = "m/s", .about = "at the start"}},
     .variants = {{"rests", {}}, {"slides", {{"speed", 2}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::breakaway

namespace plumb::scenarios::mixing_rules {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 1;  // s, short enough that no rule stops it: sqrt(a^2 + b^2) g t is less than the speed
constexpr double speed = 12;    // m/s, at the start
const Vec size{1, 0.5};         // m; too low to tip: mu < b/h = 2

Surface surface_of(const Parameters& p, const char* whose) { return surface(p.at(whose), 0); }

Mixing mixing_of(const Parameters& p) {
  return {.friction = static_cast<FrictionMixing>(static_cast<int>(p.at("rule")))};
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "mixing-rules",
              .about = "A box slides over ground with a different coefficient of friction.",
              .gravity = {0, -gravity},
              .duration = duration,
              .mixing = mixing_of(p)};
  scene.bodies.push_back(level_ground(surface_of(p, "ground")));
  Body sliding = box("box", {0, size.y / 2}, size, surface_of(p, "box"));
  sliding.velocity = {speed, 0};
  scene.bodies.push_back(sliding);
  return scene;
}

// Slows down by mu g t. The distance is off by the drift of mu g, by contact that is found a lag late, by mu times the
// slop while the box sinks in, and by its lean, slop (height/length)/2.
std::vector<Expectation> expectations(const Parameters& p) {
  const double mu = mixed_dynamic_friction(mixing_of(p), surface_of(p, "box"), surface_of(p, "ground"));
  const double a = mu * gravity;
  const double t = duration;
  const auto speed_error = [=](const Stepping& s) { return still_sinking(s, mu, t) + round_off(s, t, speed); };
  const auto place = [=](const Stepping& s) {
    return slid_late(s, a) + drifted(s, a, t) + (mu + size.y / size.x / 2) * s.slop + round_off(s, t, 2 * speed * t);
  };
  return {{.body = "box",
           .quantity = Quantity::vx,
           .expected = speed - a * t,
           .allowed = speed_error,
           .source = "v - mu g t, mu by the rule, of the whole normal impulse"},
          {.body = "box",
           .quantity = Quantity::x,
           .expected = speed * t - a * t * t / 2,
           .allowed = place,
           .source = "v t - mu g t^2/2, mu by the rule; contact a lag late, drift, penetration"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "mixing-rules",
     .question = "Does the friction between two surfaces follow the scene's mixing rule?",
     .parameters = {{.name = "rule",
                     .value = 0,
                     .min = 0,
                     .max = 5,
                     .about = "0 geometric, 1 Pythagorean, 2 average, 3 min, 4 max, 5 product",
                     .whole = true},
                    {.name = "box", .value = 0.2, .min = 0, .max = 0.8, .about = "friction of the box"},
                    {.name = "ground", .value = 0.8, .min = 0, .max = 0.8, .about = "friction of the ground"}},
     .variants = {{"geometric", {}},
                  {"pythagorean", {{"rule", 1}}},
                  {"average", {{"rule", 2}}},
                  {"min", {{"rule", 3}}},
                  {"max", {{"rule", 4}}},
                  {"product", {{"rule", 5}}}},
     .closed_form = "slide",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::mixing_rules
