#include <cmath>
#include <string>

#include "scenarios/joints/swing.h"
#include "scenarios/parts.h"
#include "scenarios/sag.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::slider {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 2;  // s
const Vec size{5, 0.5};         // m, of the sled: long, so that the joint's slop tilts it little
const Vec anchor{2, 0.2};       // m, in the sled's frame: far from its centre

Vec axis_of(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  return {std::cos(angle), std::sin(angle)};
}

Scene scene(const Parameters& p) {
  const Vec up = axis_of(p);
  Scene scene{.name = "slider",
              .about = "A sled slides on a tilted rail without friction.",
              .gravity = {0, -gravity},
              .duration = duration};
  // Neither body's frame is the rail's: the joint must take the axis and the angle as they are at the start.
  scene.bodies.push_back({.name = "rail", .type = BodyType::fixed, .position = {1, 2}, .angle = 0.4, .layers = 0});
  Body sled = box("sled", {0, 0}, size, {});
  sled.angle = p.at("tilt") * degree;
  sled.velocity = {p.at("speed") * up.x, p.at("speed") * up.y};
  sled.layers = 0;
  const Vec at{anchor.x * std::cos(sled.angle) - anchor.y * std::sin(sled.angle),
               anchor.x * std::sin(sled.angle) + anchor.y * std::cos(sled.angle)};
  scene.bodies.push_back(sled);
  scene.joints.push_back(Prismatic{.a = 0, .b = 1, .anchor = at, .axis = up});
  return scene;
}

// s = v t - g sin a t^2/2 along the axis; nothing turns. Wherever the anchor is, the rail takes the torque. Off by the
// method's drift along the axis, and by the slop of the joint across it and, at both ends of the sled, in angle.
std::vector<Expectation> expectations(const Parameters& p) {
  const Vec up = axis_of(p);
  const double t = duration;
  const double s_end = p.at("speed") * t - gravity * up.y * t * t / 2;
  const double reach = size.x + (p.at("speed") + gravity * t) * t;
  const auto place = [=](const Stepping& s) {
    return drifted(s, gravity * up.y, t) + s.joint_slop + round_off(s, t, reach);
  };
  const auto turn = [=](const Stepping& s) { return 2 * s.joint_slop / size.x + round_off(s, t, reach); };
  return {{.body = "sled",
           .quantity = Quantity::x,
           .expected = s_end * up.x,
           .allowed = place,
           .source = "v t - g sin a t^2/2 along the rail; drift and slop"},
          {.body = "sled",
           .quantity = Quantity::y,
           .expected = s_end * up.y,
           .allowed = place,
           .source = "v t - g sin a t^2/2 along the rail; drift and slop"},
          {.body = "sled",
           .quantity = Quantity::angle,
           .expected = p.at("tilt") * degree,
           .allowed = turn,
           .source = "keeps the angle it had to the rail; slop"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "slider",
     .question = "Does a sled on a tilted rail slide with g sin a and keep its angle?",
     .parameters =
         {{.name = "angle", .value = 30, .min = -90, .max = 90, .unit = "deg", .about = "of the rail"},
          {.name = "tilt", .value = 30, .min = -180, .max = 180, .unit = "deg", .about = "of the sled"},
          {.name = "speed", .value = 0, .min = 0, .max = 20, .unit = "m/s", .about = "up the rail, at the start"}},
     .variants = {{"slides", {}},
                  {"kicked", {{"angle", -60}, {"tilt", 70}, {"speed", 4}}},
                  {"falls", {{"angle", 90}, {"tilt", 0}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::slider

namespace plumb::scenarios::cantilever {
namespace {

constexpr double duration = 2;  // s
const Vec size{1, 0.4};         // m, of a segment

int count(const Parameters& p) { return static_cast<int>(p.at("segments")); }

Scene scene(const Parameters& p) {
  Scene scene{.name = "cantilever", .about = "Boxes welded end to end stick out of a wall.", .duration = duration};
  scene.bodies.push_back({.name = "wall", .type = BodyType::fixed, .layers = 0});
  for (int i = 1; i <= count(p); ++i) {
    Body segment = box("segment " + std::to_string(i), {(i - 0.5) * size.x, 0}, size, {});
    segment.layers = 0;
    const std::size_t number = scene.bodies.size();
    scene.bodies.push_back(segment);
    scene.joints.push_back(Weld{.a = number - 1, .b = number, .anchor = {(i - 1) * size.x, 0}});
  }
  return scene;
}

// Nothing moves. A weld may be off by the slop, and its segment turn by the slop over half its length; all that hangs
// from it sinks by that angle times the distance: slop times 1, 3, 5 ... from the last weld back to the first, and once
// for each weld. Where joints are springs, each gives way by what hangs from it.
std::vector<Expectation> expectations(const Parameters& p) {
  const double n = count(p);
  const Scene beam = scene(p);
  const std::size_t last = beam.bodies.size() - 1;
  const std::string tip = "segment " + std::to_string(count(p));
  const auto turn = [=](const Stepping& s) {
    return 2 * n * s.joint_slop / size.x + sag_angle(s, beam, last) + round_off(s, duration, n);
  };
  const auto place = [=](const Stepping& s) {
    return (n * n + n) * s.joint_slop + sag(s, beam, last) + n * round_off(s, duration, n);
  };
  return {{.body = tip,
           .quantity = Quantity::y,
           .expected = 0,
           .allowed = place,
           .source = "rigid: does not sink; slop of each weld, and the angle it allows"},
          {.body = tip,
           .quantity = Quantity::angle,
           .expected = 0,
           .allowed = turn,
           .source = "rigid: does not bend; slop over half a segment, for each weld"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "cantilever",
     .question = "Does a beam welded to a wall carry its own weight?",
     .parameters = {{.name = "segments", .value = 1, .min = 1, .max = 20, .about = "welded end to end", .whole = true}},
     .variants = {{"one", {}}, {"four", {{"segments", 4}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::cantilever

namespace plumb::scenarios::rod_pendulum {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double period = 2;    // s, whatever the amplitude: the rod's length follows from it

double amplitude(const Parameters& p) { return p.at("angle") * degree; }

double length(const Parameters& p) { return simple_pendulum(period, amplitude(p), gravity); }

Vec release(const Parameters& p) { return {length(p) * std::sin(amplitude(p)), -length(p) * std::cos(amplitude(p))}; }

Scene scene(const Parameters& p) {
  Scene scene{.name = "rod-pendulum",
              .about = "A disc swings at the end of a massless rod.",
              .gravity = {0, -gravity},
              .duration = period};
  // The rod's upper end is far from the middle of the body that holds it.
  scene.bodies.push_back({.name = "ceiling", .type = BodyType::fixed, .position = {1, 0.5}, .angle = 0.7, .layers = 0});
  Body bob = disc("bob", release(p), 0.2, {});
  bob.layers = 0;
  scene.bodies.push_back(bob);
  scene.joints.push_back(Distance{.a = 0, .b = 1, .anchor_b = release(p), .length = length(p)});
  return scene;
}

// theta'' = -w^2 sin theta, w^2 = g/L: the rod pulls at the disc's centre and does not turn it. After half a period it
// is at rest on the other side. With the largest angular velocity W = 2 w sin(a/2):
//   first order   the method's drift makes it half a step early or late, 2 |drift| h W, and a step along the tangent of
//                 W h loses (W h)^2/2 of the speed, and as much of the swing;
//   second order  its phase is (w h)^2/24 w t ahead, and after projection back onto the circle (W h)^2/3 W t;
//   explicit      a force taken before the move multiplies the energy by at most 1 + (w h)^2 per step;
//   slop          the rod may be longer by it, and the disc off to the side.
std::vector<Expectation> expectations(const Parameters& p) {
  const double a = amplitude(p);
  const double l = length(p);
  const double w = std::sqrt(gravity / l);
  const double fastest = 2 * w * std::sin(a / 2);
  const double mass = mass_of(scene(p).bodies[1]).mass;
  const auto turn = [=](const Stepping& s, double t) {
    const double round = round_off(s, t, 4 + fastest * t);
    const double slop = (1 + w * t / 2) * s.joint_slop / l;  // a longer rod also swings more slowly
    if (s.h == 0) return slop + round;
    const double swept = fastest * s.h;
    const double lost = s.order >= 2 ? 0 : a * swept * swept / 2 * t / s.h;
    const double second = (w * w * s.h * s.h / 24 + swept * swept / 3) * fastest * t;
    const double grown = s.drift < 0 ? a * (std::pow(1 + w * w * s.h * s.h, t / (2 * s.h)) - 1) : 0;
    return 2 * std::abs(s.drift) * s.h * fastest + lost + second + grown + slop + round;
  };
  const auto place = [=](double t) { return [=](const Stepping& s) { return l * turn(s, t) + s.joint_slop; }; };
  const double middle = period / 4;
  const double other_side = period / 2;
  return {{.body = "bob",
           .quantity = Quantity::x,
           .time = middle,
           .expected = 0,
           .allowed = place(middle),
           .source = "below the pivot after a quarter of the period, by the arithmetic-geometric mean"},
          {.body = "bob",
           .quantity = Quantity::y,
           .time = middle,
           .expected = -l,
           .allowed = place(middle),
           .source = "below the pivot after a quarter of the period"},
          {.body = "bob",
           .quantity = Quantity::x,
           .time = other_side,
           .expected = -release(p).x,
           .allowed = place(other_side),
           .source = "as far on the other side after half the period"},
          {.body = "bob",
           .quantity = Quantity::y,
           .time = other_side,
           .expected = release(p).y,
           .allowed = place(other_side),
           .source = "as high on the other side after half the period"},
          {.body = "bob",
           .quantity = Quantity::angle,
           .expected = 0,
           .allowed = [=](const Stepping& s) { return round_off(s, period, 1); },
           .source = "the rod pulls at the centre: no torque"},
          {.quantity = Quantity::energy,
           .expected = mass * gravity * release(p).y,
           .allowed = [=](const Stepping& s) { return 2 * mass * gravity * l * turn(s, period); },
           .source = "constant; error: m g L times the angle's, kinetic and potential"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "rod-pendulum",
     .question = "Does a disc on a massless rod swing with the period of the elliptic integral?",
     .parameters = {{.name = "angle",
                     .value = 60,
                     .min = 5,
                     .max = 120,
                     .unit = "deg",
                     .about = "of release, from the downward vertical"}},
     .variants = {{"60deg", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::rod_pendulum
