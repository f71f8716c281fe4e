#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::disc_on_wedge {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 1;  // s
constexpr double radius = 0.5;  // m
constexpr double base = 12;     // m, of the wedge: long enough that no disc leaves its face
constexpr double start = 2;     // m, from the top along the face

struct Face {
  Vec normal, down;
};

Face face_at(double angle) { return {{std::sin(angle), std::cos(angle)}, {std::cos(angle), -std::sin(angle)}}; }

// The centre of the disc after it has slid this far.
Vec center_at(double angle, double slid) {
  const auto [normal, down] = face_at(angle);
  const double along = start + slid;
  return {along * down.x + radius * normal.x, base * std::tan(angle) + along * down.y + radius * normal.y};
}

Scene scene(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const Surface smooth = surface(0, 0);
  Scene scene{.name = "disc-on-wedge",
              .about = "A disc is released on the face of a smooth, fixed wedge.",
              .gravity = {0, -gravity},
              .duration = duration};
  const Polygon triangle{{{0, 0}, {base, 0}, {0, base * std::tan(angle)}}};
  scene.bodies.push_back(
      {.name = "wedge", .type = BodyType::fixed, .shapes = {{.geometry = triangle, .surface = smooth}}});
  scene.bodies.push_back(disc("disc", center_at(angle, 0), radius, smooth));
  return scene;
}

// s = g sin(a) t^2/2 along the face, without spin. A contact that is found a lag late leaves what is along the face as
// it is, and lets the disc fall g lag (lag + h) into it; besides, there are the gap and the integrator's drift.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  const double acceleration = gravity * std::sin(angle);
  const double t = duration;
  const Vec end = center_at(angle, acceleration * t * t / 2);
  const auto place = [=](const Stepping& s) {
    return drifted(s, acceleration, t) + s.contact_gap() + gravity * lag(s) * (lag(s) + s.h) +
           round_off(s, t, base + gravity * t * t);
  };
  const auto speed = [=](const Stepping& s) { return still_sinking(s, 1, t) + round_off(s, t, gravity * t); };
  const auto spin = [=](const Stepping& s) { return round_off(s, t, gravity * t / radius); };
  return {{.body = "disc",
           .quantity = Quantity::x,
           .expected = end.x,
           .allowed = place,
           .source = "slides g sin(a) t^2/2; late contact, drift, gap"},
          {.body = "disc",
           .quantity = Quantity::y,
           .expected = end.y,
           .allowed = place,
           .source = "slides g sin(a) t^2/2; late contact, drift, gap"},
          {.body = "disc",
           .quantity = Quantity::speed,
           .expected = acceleration * t,
           .allowed = speed,
           .source = "g sin(a) t; sinks in by the slop meanwhile"},
          {.body = "disc",
           .quantity = Quantity::angular_velocity,
           .expected = 0,
           .allowed = spin,
           .source = "the force of a smooth face goes through the centre"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "disc-on-wedge",
     .question = "Does a disc slide down the face of a smooth wedge with g sin(a), without spin?",
     .parameters = {{.name = "angle", .value = 30, .min = 5, .max = 60, .unit = "deg", .about = "of the face"}},
     .variants = {{"30deg", {}}, {"60deg", {{"angle", 60}}}},
     .scene = scene,
     .expectations = expectations,
     .smoothness = [](const Parameters&) { return Smoothness::sliding; }}};

}  // namespace
}  // namespace plumb::scenarios::disc_on_wedge
