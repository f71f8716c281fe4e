#include <cmath>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

// Two boxes of different mass, connected by a joint, that fly and turn as one. With its anchors on the line through
// both centres, a rod or a hinge between them pulls along that line and turns neither box. A weld whose anchor is off
// that line must also hold the torque of the pull.
namespace plumb::scenarios::joined_pair {
namespace {

constexpr double duration = 1.5;         // s
constexpr double apart = 2;              // m, from centre to centre
constexpr double along = 25 * degree;    // rad, of the line from the first to the second centre, at the start
constexpr double arms[] = {0.7, 0.4};    // m, from each centre to its anchor of a rod
constexpr double tilts[] = {0.3, -0.5};  // rad, of each box from the line: the joint must keep their difference
const Vec flight{2, 1};                  // m/s, of the common centre
enum class Kind { weld, rod, hinge };

Kind kind_of(const Parameters& p) { return static_cast<Kind>(static_cast<int>(p.at("joint"))); }

Vec on_line(double distance, double angle = along) { return {distance * std::cos(angle), distance * std::sin(angle)}; }

// The two boxes about their common centre, at rest.
struct Pair {
  Body bodies[2];
  Mass masses[2];
  double from_center[2];  // m, along the line
};

Pair pair_of() {
  Pair made;
  made.bodies[0] = box("light", {}, {1, 0.5}, surface(0, 0));
  made.bodies[1] = box("heavy", {}, {0.8, 0.4}, surface(0, 0, 5));
  for (int i = 0; i < 2; ++i) made.masses[i] = mass_of(made.bodies[i]);
  const double total = made.masses[0].mass + made.masses[1].mass;
  made.from_center[0] = -apart * made.masses[1].mass / total;
  made.from_center[1] = apart * made.masses[0].mass / total;
  for (int i = 0; i < 2; ++i) {
    made.bodies[i].position = on_line(made.from_center[i]);
    made.bodies[i].angle = along + tilts[i];
  }
  return made;
}

Joint joint_of(Kind kind, const Pair& pair) {
  const double first = pair.from_center[0] + arms[0];
  const double second = pair.from_center[1] - arms[1];
  switch (kind) {
    case Kind::weld: {
      constexpr double aside = 0.3;  // m
      const Vec on = on_line(first);
      return Weld{.a = 0, .b = 1, .anchor = {on.x - aside * std::sin(along), on.y + aside * std::cos(along)}};
    }
    case Kind::rod:
      return Distance{
          .a = 0, .b = 1, .anchor_a = on_line(first), .anchor_b = on_line(second), .length = second - first};
    case Kind::hinge:
      break;
  }
  return Revolute{.a = 0, .b = 1, .anchor = on_line(first)};
}

Scene scene(const Parameters& p) {
  const Pair pair = pair_of();
  const double turn = p.at("turn");
  Scene scene{.name = "joined-pair",
              .about = "Two boxes connected by a joint fly and turn as one.",
              .gravity = {0, 0},
              .duration = duration,
              .joints = {joint_of(kind_of(p), pair)}};
  for (Body body : pair.bodies) {
    body.velocity = {flight.x - turn * body.position.y, flight.y + turn * body.position.x};
    body.angular_velocity = turn;
    scene.bodies.push_back(body);
  }
  return scene;
}

// The common centre flies straight on, and both bodies circle it at distances r with the angular velocity W: without
// torque about either centre nothing changes W, and the bodies are pulled outwards into line, so that this motion is
// stable.
//   first order   a body moves along its tangent, and the joint then removes the part of its velocity that is no longer
//                 tangential: each step loses (W h)^2/2 of the speed of the circling, which has a share of the
//                 inertia if the bodies turn with it;
//   second order  a step turns by at most tan(W h): (W h)^2/3 of W;
//   slop          each body may be off by it, and so turn by slop/D about the other.
std::vector<Expectation> expectations(const Parameters& p) {
  const Pair pair = pair_of();
  const double turn = p.at("turn");
  const double swept = turn * duration;
  const double reduced = pair.masses[0].mass * pair.masses[1].mass / (pair.masses[0].mass + pair.masses[1].mass);
  const double circling = reduced * apart * apart;
  const double share =
      kind_of(p) == Kind::weld ? circling / (circling + pair.masses[0].inertia + pair.masses[1].inertia) : 1;
  const double reach = apart + std::hypot(flight.x, flight.y) * duration + std::abs(swept);

  const auto angle = [=](const Stepping& s) {
    const double k = turn * s.h;
    const double lost = s.order >= 2 || s.h == 0 ? 0 : share * k * k / 2 * duration / s.h;
    return std::abs(swept) * (lost + k * k / 3) + s.joint_slop / apart + round_off(s, duration, reach);
  };
  std::vector<Expectation> all;
  for (int i = 0; i < 2; ++i) {
    const std::string& name = pair.bodies[i].name;
    const double r = pair.from_center[i];
    const Vec at = on_line(r, along + swept);
    const auto place = [=](const Stepping& s) {
      return std::abs(r) * angle(s) + s.joint_slop + round_off(s, duration, reach);
    };
    all.push_back({.body = name,
                   .quantity = Quantity::x,
                   .expected = flight.x * duration + at.x,
                   .allowed = place,
                   .source = "circles the common centre, which flies straight on"});
    all.push_back({.body = name,
                   .quantity = Quantity::y,
                   .expected = flight.y * duration + at.y,
                   .allowed = place,
                   .source = "circles the common centre, which flies straight on"});
    all.push_back({.body = name,
                   .quantity = Quantity::angle,
                   .expected = pair.bodies[i].angle + swept,
                   .allowed = angle,
                   .source = "turns with the line through both centres"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "joined-pair",
     .question = "Do two bodies that a joint connects fly and turn as one?",
     .parameters =
         {{.name = "joint", .value = 0, .min = 0, .max = 2, .about = "0: weld, 1: rigid rod, 2: hinge", .whole = true},
          {.name = "turn", .value = 2, .min = 0.1, .max = 10, .unit = "rad/s", .about = "angular velocity"}},
     .variants = {{"weld", {}}, {"rod", {{"joint", 1}}}, {"hinge", {{"joint", 2}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::joined_pair
