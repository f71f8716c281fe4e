#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::spinning_obb {
namespace {

constexpr double gravity = 10;  // m/s^2

Scene scene(const Parameters& p) {
  const Surface bouncy = surface(p.at("friction"), p.at("restitution"));
  Scene scene{.name = "spinning-obb",
              .about = "A box is thrown with spin over level ground.",
              .gravity = {0, -gravity},
              .duration = p.at("duration")};
  scene.bodies.push_back(level_ground(bouncy));
  Body thrown = box("box", {0, p.at("height")}, {p.at("width"), p.at("width") / 2}, bouncy);
  thrown.angle = p.at("angle");
  thrown.velocity = {p.at("vx"), p.at("vy")};
  thrown.angular_velocity = p.at("spin");
  scene.bodies.push_back(thrown);
  return scene;
}

struct Throw {
  double mass = 0, inertia = 0;
  Vec half;           // m, half the side lengths
  double radius = 0;  // m, of the circle through the corners
  double height = 0, vx = 0, vy = 0, angle = 0, spin = 0;
  double friction = 0, restitution = 0, end = 0;

  // s, when the centre passes height y on its way down. A corner lands between the times for y = radius and for y =
  // half the height.
  double down_at(double y) const {
    return (vy + std::sqrt(std::max(vy * vy + 2 * gravity * (height - y), 0.0))) / gravity;
  }
};

Throw throw_of(const Parameters& p) {
  const Mass mass = mass_of(scene(p).bodies[1]);
  const Vec half{p.at("width") / 2, p.at("width") / 4};
  return {.mass = mass.mass,
          .inertia = mass.inertia,
          .half = half,
          .radius = std::hypot(half.x, half.y),
          .height = p.at("height"),
          .vx = p.at("vx"),
          .vy = p.at("vy"),
          .angle = p.at("angle"),
          .spin = p.at("spin"),
          .friction = p.at("friction"),
          .restitution = p.at("restitution"),
          .end = p.at("duration")};
}

// In free flight the position is off by the drift g t h and round-off only; velocities and spin by round-off only.
std::vector<Expectation> in_flight(const Throw& b) {
  const double t = b.end;
  const double speed = std::abs(b.vx) + std::abs(b.vy) + gravity * t;
  const double reach = b.height + speed * t;
  const auto rounds = [t](double size) { return [=](const Stepping& s) { return round_off(s, t, size); }; };
  const auto falls = [=](double per_metre) {
    return [=](const Stepping& s) { return per_metre * (drifted(s, gravity, t) + round_off(s, t, reach)); };
  };
  const double turn = 4 + std::abs(b.spin) * t;  // rad, including the initial angle
  // Round-off of the kinetic energy: m v^2 and I w^2 times that of the velocities.
  const double energy = b.mass * speed * speed + b.inertia * b.spin * b.spin;
  return {
      {.body = "box", .quantity = Quantity::x, .allowed = rounds(reach), .source = "vx t"},
      {.body = "box", .quantity = Quantity::y, .allowed = falls(1), .source = "vy t - g t^2/2; off by drift g t h"},
      {.body = "box", .quantity = Quantity::angle, .allowed = rounds(turn), .source = "a0 + w t"},
      {.body = "box", .quantity = Quantity::vx, .allowed = rounds(speed), .source = "constant"},
      {.body = "box", .quantity = Quantity::vy, .allowed = rounds(speed), .source = "vy - g t"},
      {.body = "box",
       .quantity = Quantity::angular_velocity,
       .allowed = rounds(1 + std::abs(b.spin)),
       .source = "constant"},
      {.quantity = Quantity::energy,
       .allowed = [=, fall = falls(b.mass * gravity)](const Stepping& s) { return fall(s) + round_off(s, t, energy); },
       .source = "constant; error: m g times the drift of the height"},
  };
}

Vec lowest_corner(const Throw& b, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Vec lowest;
  for (const Vec corner : {b.half, Vec{-b.half.x, b.half.y}, Vec{b.half.x, -b.half.y}, Vec{-b.half.x, -b.half.y}}) {
    const Vec there{c * corner.x - s * corner.y, s * corner.x + c * corner.y};
    if (there.y < lowest.y) lowest = there;
  }
  return lowest;
}

// The error of the impulse at a corner r. A box has I = m R^2/3. Friction mu s against the slip direction s gives the
// impulse P the lever arm l = r x (n - s mu t) = r_x + s mu r_y, and
//   P = (1 + e) m u/D,   D = 1 + 3 r_x l/R^2,   velocity jumps: P/m up, mu P/m along, 3 l P/(m R^2) in spin.
// The impact is late by up to the lag, and early or late by the drift of the height divided by the corner's speed.
// During that delay the corner's speed u changes by (g + w^2 R) per second and the box turns at w, which changes r_x by
// |r_y|, l by q R with q = sqrt(1 + mu^2), and D by 3 (|r_y| l + |r_x| q R)/R^2, each times the angle. This gives the
// errors of the jumps. A position is off by the jump's error times the time since the impact, plus the jump itself
// times its delay.
// The engine may correct the corner's penetration by moving the box: upwards, which only undoes some of being late, and
// by turning it by at most 3 r_x/R^2 times it. The corner's orientation is known except for its landing time, which
// lies within the fall from R to half the box's height. r_x, l and D are taken at the middle of that interval and
// widened by the angle that the box turns in the rest of it.
struct Landing {
  double delay = 0;                           // s
  double up = 0, along = 0, about = 0;        // jumps, m/s, m/s, rad/s
  double d_up = 0, d_along = 0, d_about = 0;  // their errors
  double tilted = 0;                          // rad, the turn that corrects the penetration
};

Landing landing(const Throw& b, const Stepping& s) {
  const double first = b.down_at(b.radius);
  const double last = b.down_at(b.half.y);
  const double spin = std::abs(b.spin);
  const double mu = b.friction;
  const double q = std::sqrt(1 + mu * mu);
  const double r2 = b.radius * b.radius;
  const Vec r = lowest_corner(b, b.angle + b.spin * (first + last) / 2);

  Landing l;
  const double slowest = gravity * first - b.vy - spin * b.radius;
  l.delay = lag(s) + drifted(s, gravity, last) / std::max(slowest, 0.0);
  const double turn = spin * ((last - first) / 2 + l.delay);
  const double level = r.x + std::copysign(mu, b.vx) * r.y;
  const double rx = std::abs(r.x) + b.radius * turn;
  const double lever = std::abs(level) + q * b.radius * turn;
  const double stiff = std::max(1 + 3 * r.x * level / r2 - 3 * q * turn, 0.0);
  const double u = gravity * last - b.vy + spin * rx;

  l.up = (1 + b.restitution) * u / stiff;
  l.d_up = ((1 + b.restitution) * (gravity + spin * spin * b.radius) +
            l.up * 3 * spin * (std::abs(r.y) * lever + rx * q * b.radius) / r2) *
           l.delay / stiff;
  l.along = mu * l.up;
  l.d_along = mu * l.d_up;
  l.about = 3 * lever * l.up / r2;
  l.d_about = 3 * (lever * l.d_up + q * b.radius * spin * l.delay * l.up) / r2;
  l.tilted = 3 * rx * u * lag(s) / r2;
  return l;
}

std::vector<Expectation> after_landing(const Throw& b) {
  const double since = b.end - b.down_at(b.radius);
  const double speed = 2 * (std::abs(b.vx) + std::abs(b.vy) + gravity * b.end);
  const double reach = b.height + speed * b.end;
  const auto expect = [&](Quantity quantity, auto allowed, const char* source) {
    return Expectation{
        .body = "box",
        .quantity = quantity,
        .allowed = [=](const Stepping& s) { return allowed(landing(b, s), s) + round_off(s, b.end, reach); },
        .source = std::string(source) + "; the impact is detected late"};
  };
  return {
      expect(
          Quantity::x, [=](const Landing& l, const Stepping&) { return l.d_along * since + l.along * l.delay; },
          "slowed by friction mu J"),
      expect(
          Quantity::y,
          [=](const Landing& l, const Stepping& s) {
            return l.d_up * since + l.up * l.delay + s.skin + drifted(s, gravity, b.end);
          },
          "J = (1+e) u/(K_nn - mu K_nt)"),
      expect(
          Quantity::angle,
          [=](const Landing& l, const Stepping&) { return l.d_about * since + l.about * l.delay + l.tilted; },
          "spin from r x J/I"),
      expect(
          Quantity::vx, [](const Landing& l, const Stepping&) { return l.d_along; }, "mu J/m"),
      expect(
          Quantity::vy, [](const Landing& l, const Stepping&) { return l.d_up; }, "J/m"),
      expect(
          Quantity::angular_velocity, [](const Landing& l, const Stepping&) { return l.d_about; }, "r x J/I"),
  };
}

std::vector<Expectation> expectations(const Parameters& p) {
  const Throw b = throw_of(p);
  return b.end < b.down_at(b.radius) ? in_flight(b) : after_landing(b);
}

Smoothness smoothness(const Parameters& p) {
  const Throw thrown = throw_of(p);
  return thrown.end < thrown.down_at(thrown.radius) ? Smoothness::free : Smoothness::none;
}

const Catalog<Scenario>::Entry entry{
    {.name = "spinning-obb",
     .question =
         "Does a thrown box fly on a parabola, keep its spin, and rebound from the ground as the impact laws say?",
     .parameters =
         {{.name = "height", .value = 40, .min = 1, .max = 1000, .unit = "m", .about = "of the centre at the start"},
          {.name = "vx",
           .value = 3,
           .min = -100,
           .max = 100,
           .unit = "m/s",
           .about = "horizontal velocity at the start"},
          {.name = "vy", .value = 5, .min = -100, .max = 100, .unit = "m/s", .about = "upward velocity at the start"},
          {.name = "angle", .value = 0.3, .min = -3, .max = 3, .unit = "rad", .about = "at the start"},
          {.name = "spin", .value = 1.2, .min = -100, .max = 100, .unit = "rad/s", .about = "at the start"},
          {.name = "width", .value = 1, .min = 0.1, .max = 2, .unit = "m", .about = "of the box, twice its height"},
          {.name = "friction", .value = 0.2, .min = 0, .max = 1, .about = "of box and ground"},
          {.name = "restitution", .value = 0.5, .min = 0, .max = 1, .about = "of box and ground"},
          {.name = "duration", .value = 2, .min = 0.1, .max = 100, .unit = "s", .about = "of the run"}},
     .variants = {{"free-fall", {{"vx", 0}, {"vy", 0}, {"angle", 0}, {"spin", 0}}},
                  {"flight", {}},
                  {"landing", {{"height", 2}, {"vx", 4}, {"vy", 0}, {"angle", -1}, {"spin", 0.3}, {"duration", 0.75}}}},
     .closed_form = "first-impact",
     .scene = scene,
     .expectations = expectations,
     .canonical = true,
     .smoothness = smoothness,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::spinning_obb
