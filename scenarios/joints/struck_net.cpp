#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::struck_net {
namespace {

constexpr double pitch = 1;       // m
constexpr double radius = 0.4;    // m, of all discs
constexpr double moment = 0.143;  // s, of the impact: between two steps
constexpr double after = 0.357;   // s

std::string name(int row, int column) { return std::to_string(row + 1) + "." + std::to_string(column + 1); }

// From the middle of the net; rows are counted from below.
Vec place(int side, int row, int column) {
  const double middle = (side - 1) / 2.0;
  return {(column - middle) * pitch, (row - middle) * pitch};
}

int side(const Parameters& p) { return 2 * static_cast<int>(p.at("half")); }

// Each disc is hinged to its neighbours at the midpoints. The striker comes along the uppermost row, from the left.
Scene scene(const Parameters& p) {
  const int n = side(p);
  const Surface smooth = surface(0, p.at("restitution"));
  Scene scene{.name = "struck-net",
              .about = "A disc hits a corner of a free net of discs, each hinged to its neighbours.",
              .gravity = {0, 0},
              .duration = moment + after};
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const Vec at = place(n, row, column);
      scene.bodies.push_back(disc(name(row, column), at, radius, smooth));
      const std::size_t here = scene.bodies.size() - 1;
      if (column > 0) scene.joints.push_back(Revolute{.a = here - 1, .b = here, .anchor = {at.x - pitch / 2, at.y}});
      if (row > 0) {
        const std::size_t below = here - static_cast<std::size_t>(n);
        scene.joints.push_back(Revolute{.a = below, .b = here, .anchor = {at.x, at.y - pitch / 2}});
      }
    }
  }
  const Vec corner = place(n, n - 1, 0);
  Body striker = disc("striker", {corner.x - 2 * radius - p.at("speed") * moment, corner.y}, radius,
                      surface(0, p.at("restitution"), p.at("ratio")));
  striker.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(striker);
  return scene;
}

// What the net does after the blow J = (1+e) v/(1/m + 1/M + y^2/I) as the rigid body that it is: hinges on four sides
// leave the discs only one motion among themselves, in which each turns against its neighbours like meshed gears. The
// blow goes through a disc's centre, which that motion does not move, and in a net with an even number of discs along
// each side as many turn one way as the other, so that it takes no part in the net's turning either.
struct Blow {
  double jump = 0;     // m/s, of the net's centre, along x
  double spin = 0;     // rad/s
  double rebound = 0;  // m/s, what the striker loses

  explicit Blow(const Parameters& p) {
    const Scene built = scene(p);
    const int n = side(p);
    const Mass knot = mass_of(built.bodies[0]);
    double inertia = 0;
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const Vec at = place(n, row, column);
        inertia += knot.inertia + knot.mass * (at.x * at.x + at.y * at.y);
      }
    }
    const double mass = n * n * knot.mass;
    const double striker = mass_of(built.bodies.back()).mass;
    const double y = place(n, n - 1, 0).y;
    const double impulse = (1 + p.at("restitution")) * p.at("speed") / (1 / striker + 1 / mass + y * y / inertia);
    jump = impulse / mass;
    spin = -y * impulse / inertia;
    rebound = impulse / striker;
  }
};

// How far off a method may be:
//   impact       found late or early, the velocity jump times that time; overlap that is removed;
//   turning      as of bodies that a joint holds together: (W h)^2/3 of W, at first order (W h)^2/2 in each step;
//   slop         of all hinges on the way to the corner, sideways and, over the net's width, in angle;
//   rounding     of places: in a sub-step hinges miss by so much, and discs that turn like gears may take it up;
//   iterations   hand the blow on from disc to disc, through as many as there are on two sides, so that what they leave
//                is missing beyond.
std::vector<Expectation> expectations(const Parameters& p) {
  const int n = side(p);
  const Blow blow(p);
  const double v = p.at("speed");
  const double width = (n - 1) * pitch;
  const double turned = blow.spin * after;
  const double fastest = blow.jump + std::abs(blow.spin) * width + v;
  const double reach = width + v;
  const auto left = [=](const Stepping& s) { return unsolved(s, 2 * n); };
  const auto spin = [=](const Stepping& s) {
    const double k = blow.spin * s.h;
    const double lost = first_order(s) ? k * k / 2 * after / s.h : 0;
    const double rounded = s.h > 0 ? 4 * s.epsilon * reach / (s.h * pitch / 2) : 0;
    return std::abs(blow.spin) * (k * k / 3 + lost) + fastest * left(s) / pitch + rounded +
           round_off(s, after, fastest / pitch);
  };
  const auto turn = [=](const Stepping& s) {
    return spin(s) * after + std::abs(blow.spin) * found_off(s, v) +
           2 * (s.joint_slop + s.contact_gap() + v * lag(s)) / pitch + round_off(s, after, reach);
  };
  const auto where = [=](const Stepping& s) {
    return width * turn(s) + fastest * (found_off(s, v) + after * left(s)) + 2 * n * s.joint_slop + s.contact_gap() +
           v * lag(s) + round_off(s, after, reach);
  };
  const auto leaves = [=](const Stepping& s) { return blow.rebound * left(s) + round_off(s, after, v); };

  std::vector<Expectation> all{{.body = "striker",
                                .quantity = Quantity::vx,
                                .expected = v - blow.rebound,
                                .allowed = leaves,
                                .source = "v - J/m, J = (1+e) v/(1/m + 1/M + y^2/I)"}};
  for (const int row : {0, n - 1}) {
    for (const int column : {0, n - 1}) {
      const std::string knot = name(row, column);
      const Vec from = place(n, row, column);
      const double c = std::cos(turned);
      const double s = std::sin(turned);
      const char* const law = "the net moves on as one rigid body, with J/M and y J/I";
      all.push_back({.body = knot,
                     .quantity = Quantity::angular_velocity,
                     .expected = blow.spin,
                     .allowed = spin,
                     .source = law});
      all.push_back({.body = knot, .quantity = Quantity::angle, .expected = turned, .allowed = turn, .source = law});
      if (row > 0) {  // the lower ones are near where the net turns about at first
        all.push_back({.body = knot,
                       .quantity = Quantity::x,
                       .expected = blow.jump * after + from.x * c - from.y * s,
                       .allowed = where,
                       .source = law});
      }
      all.push_back({.body = knot,
                     .quantity = Quantity::y,
                     .expected = from.x * s + from.y * c,
                     .allowed = where,
                     .source = law});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "struck-net",
     .question = "Does a net of hinged discs that is struck at a corner fly and turn on as one body?",
     .parameters =
         {{.name = "half", .value = 2, .min = 1, .max = 8, .about = "half the discs along each side", .whole = true},
          {.name = "speed", .value = 4, .min = 1, .max = 10, .unit = "m/s", .about = "of the striker"},
          {.name = "ratio", .value = 3, .min = 0.5, .max = 10, .about = "density of the striker, of the net's discs'"},
          {.name = "restitution", .value = 0.5, .min = 0, .max = 1, .about = "of all discs"}},
     .variants = {{"sixteen", {}},
                  {"elastic, 64", {{"half", 4}, {"restitution", 1}, {"ratio", 5}}},
                  {"inelastic, 64", {{"half", 4}, {"restitution", 0}, {"ratio", 5}, {"speed", 8}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::struck_net
