#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::disc_pair {
namespace {

constexpr double duration = 1;                 // s
constexpr double moment = 0.493;               // s, of the impact: between two steps
constexpr double radii[] = {0.5, 0.4};         // m
constexpr double across = 25 * degree;         // rad, of the line of centres at the impact
constexpr Vec common{0.7, -0.4};               // m/s, of both discs together
constexpr double shares[] = {0.6, -0.4};       // of the relative velocity, in each disc's
constexpr double reach = radii[0] + radii[1];  // m, between the centres at the impact

// Masses, kg, and moments of inertia, kg m^2, at the impact; velocities before it.
struct Pair {
  std::array<double, 2> mass, inertia, spin;
  std::array<Vec, 2> velocity;
};

// Velocities and spins after the impact, and the impulses along and across the line of centres, N s.
struct Outcome {
  std::array<Vec, 2> velocity;
  std::array<double, 2> spin;
  double normal = 0, tangential = 0;
};

// Jn = (1+e) vn/(1/m1 + 1/m2) along the line of centres n; across it, Jt = min(mu Jn, u/kt) against the slip u of the
// points that touch, kt = 1/m1 + 1/m2 + a1^2/I1 + a2^2/I2: both directions are independent, as the arms a are along n.
Outcome collide(const Pair& pair, Vec n, std::array<double, 2> arms, double friction, double e) {
  const Vec t = perpendicular(n);
  const Vec relative = pair.velocity[0] - pair.velocity[1];
  const double slip = dot(relative, t) + pair.spin[0] * arms[0] + pair.spin[1] * arms[1];
  const double along = 1 / pair.mass[0] + 1 / pair.mass[1];
  const double sideways = along + arms[0] * arms[0] / pair.inertia[0] + arms[1] * arms[1] / pair.inertia[1];
  Outcome after;
  after.normal = (1 + e) * std::max(dot(relative, n), 0.0) / along;
  after.tangential = std::copysign(std::min(friction * after.normal, std::abs(slip) / sideways), slip);
  for (std::size_t i = 0; i < 2; ++i) {
    const double sign = i == 0 ? -1 : 1;
    const Vec push = after.normal * n + after.tangential * t;
    after.velocity[i] = {pair.velocity[i].x + sign * push.x / pair.mass[i],
                         pair.velocity[i].y + sign * push.y / pair.mass[i]};
    after.spin[i] = pair.spin[i] - arms[i] * after.tangential / pair.inertia[i];
  }
  return after;
}

Scene scene(const Parameters& p) {
  const Surface of = surface(p.at("friction"), p.at("restitution"));
  Scene scene{.name = "disc-pair",
              .about = "Two spinning discs, both free, hit each other obliquely.",
              .gravity = {0, 0},
              .duration = duration};
  const double heading = across + p.at("incidence") * degree;
  const Vec relative{p.at("speed") * std::cos(heading), p.at("speed") * std::sin(heading)};
  for (const int i : {0, 1}) {
    const Vec velocity{common.x + shares[i] * relative.x, common.y + shares[i] * relative.y};
    const double along = i * reach;
    Body one = disc(i == 0 ? "one" : "other",
                    {along * std::cos(across) - velocity.x * moment, along * std::sin(across) - velocity.y * moment},
                    radii[i], surface(of.dynamic_friction, of.restitution, i == 0 ? 1 : p.at("ratio")));
    one.velocity = velocity;
    one.angular_velocity = p.at(i == 0 ? "first" : "second");
    scene.bodies.push_back(one);
  }
  return scene;
}

// The largest differences from the exact outcome.
struct Errors {
  std::array<Vec, 2> velocity{};
  std::array<double, 2> spin{};
};

struct Impact {
  Pair pair;
  Vec relative;     // m/s, of the first to the second
  double approach;  // m/s
  double friction, restitution;
  Outcome exact;

  // An impact that is found late or early sees the line of centres turned and the discs in each other or apart; its
  // point is between the two surfaces, or each arm ends on its own. One slower than the threshold may be inelastic.
  Errors errors(const Stepping& s) const {
    Errors worst;
    constexpr int parts = 8;
    const double early = s.skin / approach;
    const bool slow = approach < s.restitution_threshold;
    for (int i = 0; i <= parts; ++i) {
      const double late = -early + (lag(s) + early) * i / parts;
      const Vec between{reach * std::cos(across) - relative.x * late, reach * std::sin(across) - relative.y * late};
      const double distance = length(between);
      const double in = reach - distance;
      for (const auto& [first, second] : {std::array{0.0, 0.0}, {in, 0.0}, {0.0, in}, {in / 2, in / 2}}) {
        for (const double e : {restitution, slow ? 0 : restitution}) {
          add(worst, collide(pair, {between.x / distance, between.y / distance}, {radii[0] - first, radii[1] - second},
                             friction, e));
        }
      }
    }
    return worst;
  }

 private:
  void add(Errors& worst, const Outcome& other) const {
    for (std::size_t i = 0; i < 2; ++i) {
      Vec& v = worst.velocity[i];
      v.x = std::max(v.x, std::abs(other.velocity[i].x - exact.velocity[i].x));
      v.y = std::max(v.y, std::abs(other.velocity[i].y - exact.velocity[i].y));
      worst.spin[i] = std::max(worst.spin[i], std::abs(other.spin[i] - exact.spin[i]));
    }
  }
};

Impact impact_of(const Scene& scene, const Parameters& p) {
  Impact made{.friction = p.at("friction"), .restitution = p.at("restitution")};
  for (std::size_t i = 0; i < 2; ++i) {
    const Mass mass = mass_of(scene.bodies[i]);
    made.pair.mass[i] = mass.mass;
    made.pair.inertia[i] = mass.inertia;
    made.pair.velocity[i] = scene.bodies[i].velocity;
    made.pair.spin[i] = scene.bodies[i].angular_velocity;
  }
  made.relative = made.pair.velocity[0] - made.pair.velocity[1];
  made.approach = p.at("speed") * std::cos(p.at("incidence") * degree);
  made.exact =
      collide(made.pair, {std::cos(across), std::sin(across)}, {radii[0], radii[1]}, made.friction, made.restitution);
  return made;
}

// Velocities and spins are off as the law itself says for an impact that is found late or early. Positions are off by
// their jump times that time, by these errors for the rest of the run and, after an impact without a rebound, by the
// gap. Momentum is kept by any pair of opposite forces, angular momentum if both act at one point: it may change by Jt
// times the distance of the two arms' ends, the overlap, and by the push that removes it, times the slip of the
// centres.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene built = scene(p);
  const Impact impact = impact_of(built, p);
  constexpr double after = duration - moment;
  const double fastest = p.at("speed") + 1 + std::abs(p.at("first")) + std::abs(p.at("second"));
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, 2 * (1 + fastest) / radii[1]); };
  const auto rests = [=](const Stepping& s) {
    return impact.restitution == 0 || impact.approach < s.restitution_threshold ? s.contact_gap() : 0;
  };
  std::vector<Expectation> all;
  double angular = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Body& body = built.bodies[i];
    const Vec end = impact.exact.velocity[i];
    const double spin = impact.exact.spin[i];
    const double mass = impact.pair.mass[i];
    angular += mass * cross(body.position, body.velocity) + impact.pair.inertia[i] * body.angular_velocity;
    const auto vx = [=](const Stepping& s) { return impact.errors(s).velocity[i].x + exact(s); };
    const auto vy = [=](const Stepping& s) { return impact.errors(s).velocity[i].y + exact(s); };
    const auto about = [=](const Stepping& s) { return impact.errors(s).spin[i] + exact(s); };
    const Vec jump{std::abs(end.x - body.velocity.x), std::abs(end.y - body.velocity.y)};
    const double turned = std::abs(spin - body.angular_velocity);
    const auto x = [=](const Stepping& s) {
      return jump.x * found_off(s, impact.approach) + rests(s) + vx(s) * after + exact(s);
    };
    const auto y = [=](const Stepping& s) {
      return jump.y * found_off(s, impact.approach) + rests(s) + vy(s) * after + exact(s);
    };
    const auto turn = [=](const Stepping& s) {
      return turned * found_off(s, impact.approach) + about(s) * after + exact(s);
    };
    const auto add = [&](Quantity quantity, double expected, const auto& allowed, const char* source) {
      all.push_back(
          {.body = body.name, .quantity = quantity, .expected = expected, .allowed = allowed, .source = source});
    };
    add(Quantity::vx, end.x, vx, "Jn = (1+e) vn/(1/m1 + 1/m2), Jt = min(mu Jn, u/kt); found late or early");
    add(Quantity::vy, end.y, vy, "Jn = (1+e) vn/(1/m1 + 1/m2), Jt = min(mu Jn, u/kt); found late or early");
    add(Quantity::angular_velocity, spin, about, "w - r Jt/I for both; found late or early");
    add(Quantity::x, body.position.x + body.velocity.x * moment + end.x * after, x, "the velocity jump times the lag");
    add(Quantity::y, body.position.y + body.velocity.y * moment + end.y * after, y, "the velocity jump times the lag");
    add(Quantity::angle, body.angular_velocity * moment + spin * after, turn, "the jump of the spin times the lag");
  }
  const double reduced = 1 / (1 / impact.pair.mass[0] + 1 / impact.pair.mass[1]);
  const double most = (1 + impact.friction) * impact.exact.normal + reduced * p.at("speed");  // N s
  all.push_back({.quantity = Quantity::angular_momentum,
                 .expected = angular,
                 .allowed =
                     [=](const Stepping& s) {
                       const double apart = std::max(impact.approach * lag(s), s.skin) + rests(s);
                       return most * apart + (impact.pair.mass[0] + impact.pair.mass[1]) * fastest * exact(s);
                     },
                 .source = "kept, as both impulses act at one point; the arms' ends may be apart by the overlap"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "disc-pair",
     .question = "Do two free discs that meet obliquely take the velocities and spins that restitution and friction "
                 "give them?",
     .parameters =
         {{.name = "speed", .value = 6, .min = 3, .max = 20, .unit = "m/s", .about = "of one to the other"},
          {.name = "incidence",
           .value = 40,
           .min = -60,
           .max = 60,
           .unit = "deg",
           .about = "of that velocity from the line of centres at the impact"},
          {.name = "ratio", .value = 2, .min = 0.01, .max = 100, .about = "of the densities, second to first"},
          {.name = "first", .value = 3, .min = -50, .max = 50, .unit = "rad/s", .about = "spin of the first disc"},
          {.name = "second", .value = -2, .min = -50, .max = 50, .unit = "rad/s", .about = "spin of the second disc"},
          {.name = "friction", .value = 0.1, .min = 0, .max = 2, .about = "of both discs"},
          {.name = "restitution", .value = 0.6, .min = 0, .max = 1, .about = "of both discs"}},
     .variants = {{"slips", {}},
                  {"grips", {{"friction", 0.9}}},
                  {"e=0 slips", {{"restitution", 0}}},
                  {"e=0 grips", {{"restitution", 0}, {"friction", 0.9}, {"ratio", 0.2}}},
                  {"smooth", {{"restitution", 1}, {"friction", 0}, {"incidence", -30}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::disc_pair
