#include <algorithm>
#include <cmath>
#include <cstdint>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::conveyor {
namespace {

constexpr double gravity = 10;    // m/s^2
constexpr double duration = 2;    // s
constexpr double friction = 0.3;  // of box and belt
const Vec size{1, 0.5};           // m; too low to tip: mu < b/h = 2
const Vec belt{60, 1};            // m, a box rather than a half-space, because every engine can move one

// High bits, where a mask of 16 bits would be empty; the curtain shares none with the box.
constexpr std::uint32_t goods = 1u << 20;
constexpr std::uint32_t curtains = 1u << 27 | 1u << 4;

Scene scene(const Parameters& p) {
  const Surface rubber = surface(friction, 0);
  Scene scene{.name = "conveyor",
              .about = "A box is put on a belt that moves and rises.",
              .gravity = {0, -gravity},
              .duration = duration};
  Body moving = box("belt", {0, -belt.y / 2}, belt, rubber);
  moving.type = BodyType::kinematic;
  moving.velocity = {p.at("speed"), p.at("rise")};
  moving.layers = goods | 1u << 31;
  Body curtain = fixed(box("curtain", {size.x, 2}, {0.2, 8}, rubber));
  curtain.layers = curtains;
  Body carried = box("box", {0, size.y / 2}, size, rubber);
  carried.velocity = {0, p.at("rise")};
  carried.gravity_scale = p.at("scale");
  carried.layers = goods;
  scene.bodies = {moving, curtain, carried};
  return scene;
}

// Friction accelerates the box with mu s g, s its gravity scale, until it is as fast as the belt, V.
//   Contact   may be detected a lag late, until when mu s g lag of the speed is missing, and the box falls. While it
//             slips and sinks in, mu times the speed at which it sinks is missing as well.
//   Carried   it may creep.
//   Position  that speed and the creep times the time, the drift, mu times the gap while the box sinks in, and its
//             lean, gap (height/length).
std::vector<Expectation> expectations(const Parameters& p) {
  const double a = friction * p.at("scale") * gravity;
  const double v = p.at("speed");
  const double slipping = std::abs(v) / a;  // s, until it is carried
  const double way = v > 0 ? 1 : -1;
  const double reach = belt.x / 2 + (std::abs(v) + p.at("rise") + gravity * duration) * duration;
  const auto missing = [=](const Stepping& s) { return a * lag(s); };
  std::vector<Expectation> all;
  for (const double t : {duration / 4, duration}) {
    const bool carried = t >= slipping;
    const auto speed_error = [=](const Stepping& s) {
      return (carried ? s.creep : missing(s) + still_sinking(s, friction, t)) + round_off(s, t, reach);
    };
    const auto place = [=](const Stepping& s) {
      return missing(s) * t + drifted(s, a, t) + (friction + size.y / size.x) * s.contact_gap() + s.creep * t +
             round_off(s, t, reach);
    };
    const double slid = std::min(t, slipping);
    all.push_back({.body = "box",
                   .quantity = Quantity::vx,
                   .time = t,
                   .expected = way * a * slid,
                   .allowed = speed_error,
                   .source = "mu s g t up to the belt's speed; friction starts a lag late, or it creeps"});
    all.push_back({.body = "box",
                   .quantity = Quantity::x,
                   .time = t,
                   .expected = way * a * slid * slid / 2 + v * (t - slid),
                   .allowed = place,
                   .source = "mu s g t^2/2, then the belt's speed; friction starts a lag late, drift, gap, creep"});
  }
  const auto height = [=](const Stepping& s) {
    return s.contact_gap() + p.at("scale") * gravity * lag(s) * (lag(s) + s.h) + round_off(s, duration, reach);
  };
  all.push_back({.body = "box",
                 .quantity = Quantity::y,
                 .expected = size.y / 2 + p.at("rise") * duration,
                 .allowed = height,
                 .source = "rises with the belt; gap, and the fall during a lag"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "conveyor",
     .question = "Does a moving belt carry what lies on it, with friction by the gravity it feels?",
     .parameters = {{.name = "speed", .value = 2, .min = -10, .max = 10, .unit = "m/s", .about = "of the belt"},
                    {.name = "rise", .value = 1, .min = 0, .max = 5, .unit = "m/s", .about = "of the belt, upwards"},
                    {.name = "scale",
                     .value = 0.5,
                     .min = 0.1,
                     .max = 4,
                     .about = "gravity on the box divided by that of the scene"}},
     .variants = {{"half gravity", {}}, {"double", {{"scale", 2}, {"speed", -5}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::conveyor
