#include "bodies/generators.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/finite.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real steepest = 16;  // beyond it, powers of lengths in m leave the range of float

[[noreturn]] void refuse(const char* what) { throw std::invalid_argument(what); }

void need_body(BodyId id, const BodySet& bodies, const char* what) {
  if (!bodies.contains(id)) throw std::out_of_range(std::string(what) + " names a body that is not there");
}

/// base^n for n >= 0, by squaring.
Real integer_power(Real base, int n) {
  Real result = 1;
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) result *= base;
    base *= base;
  }
  return result;
}

/// base^(halves/2) from products, roots and one quotient: the same bits everywhere, as std::pow is not.
Real power_of_halves(Real base, int halves) {
  const int n = halves < 0 ? -halves : halves;
  const Real whole = integer_power(base, n / 2);
  const Real result = n % 2 == 1 ? whole * std::sqrt(base) : whole;
  return halves < 0 ? 1 / result : result;
}

/// One end of a spring: a point of a body or of the world.
struct End {
  std::size_t row = 0;
  bool of_body = false;
  bool present = true;  // a body out of the world exerts nothing
  Vec2 arm;             // from the centre of mass, world frame
  Vec2 point;           // world frame
  Vec2 velocity;        // of the point

  End(BodyId body, Vec2 anchor, const BodySet& bodies) : point(anchor) {
    if (body == BodyId{}) return;
    row = body.index;
    of_body = true;
    present = bodies.detail[row].inserted;
    arm = bodies.pose[row].q * (anchor - bodies.detail[row].mass.center);
    point = bodies.pose[row].p + arm;
    velocity = bodies.velocity[row].v + cross(bodies.velocity[row].w, arm);
  }

  void pull(Vec2 force, const BodySet& bodies, std::vector<Velocity>& out) const {
    if (!of_body) return;
    out[row].v += bodies.inverse_mass[row].m * force;
    out[row].w += bodies.inverse_mass[row].i * cross(arm, force);
  }
};

}  // namespace

void accelerate(const Attraction& attraction, const BodySet& bodies, std::vector<Velocity>& out) {
  const std::size_t from = attraction.from.index;
  if (!bodies.detail[from].inserted) return;
  // The line to `from` is not of unit length, so one more power of r divides it.
  const int halves = static_cast<int>(2 * attraction.exponent) + 2;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Real inverse_mass = bodies.inverse_mass[i].m;
    if (i == from || inverse_mass == 0) continue;
    const Vec2 line = bodies.pose[from].p - bodies.pose[i].p;
    const Real r = length(line);
    if (r == 0 || r > attraction.reach) continue;
    const Vec2 acceleration = attraction.strength / power_of_halves(r, halves) * line;
    out[i].v += acceleration;
    if (attraction.mutual) out[from].v -= bodies.inverse_mass[from].m / inverse_mass * acceleration;
  }
}

void accelerate(const Spring& spring, const BodySet& bodies, std::vector<Velocity>& out) {
  const End a(spring.a, spring.anchor_a, bodies);
  const End b(spring.b, spring.anchor_b, bodies);
  if (!a.present || !b.present) return;
  const Vec2 line = b.point - a.point;
  const Real distance = length(line);
  if (distance == 0) return;
  const Vec2 direction = line / distance;
  const Real parting = dot(b.velocity - a.velocity, direction);
  const Vec2 pull = (spring.stiffness * (distance - spring.length) + spring.damping * parting) * direction;
  a.pull(pull, bodies, out);
  b.pull(-pull, bodies, out);
}

void accelerate(const ConstantForce& constant, const BodySet& bodies, std::vector<Velocity>& out) {
  const std::size_t i = constant.body.index;
  out[i].v += bodies.inverse_mass[i].m * constant.force;
  out[i].w += bodies.inverse_mass[i].i * constant.torque;
}

void check(const Attraction& attraction, const BodySet& bodies) {
  need_body(attraction.from, bodies, "Attraction: from");
  if (!finite(attraction.strength)) refuse("Attraction: strength must be finite");
  const Real halves = 2 * attraction.exponent;
  if (!finite(halves) || std::abs(attraction.exponent) > steepest || halves != std::floor(halves)) {
    refuse("Attraction: exponent must be a multiple of 1/2 from -16 to 16; other powers differ between machines");
  }
  if (!(attraction.reach > 0)) refuse("Attraction: reach must be above 0 (m)");
}

void check(const Spring& spring, const BodySet& bodies) {
  if (spring.a == spring.b) refuse("Spring: needs two different ends");
  if (spring.a != BodyId{}) need_body(spring.a, bodies, "Spring: a");
  if (spring.b != BodyId{}) need_body(spring.b, bodies, "Spring: b");
  if (!finite(spring.anchor_a) || !finite(spring.anchor_b)) refuse("Spring: anchors must be finite");
  if (!finite(spring.stiffness) || spring.stiffness < 0)
    refuse("Spring: stiffness must be finite and not negative (N/m)");
  if (!finite(spring.length) || spring.length < 0) refuse("Spring: length must be finite and not negative (m)");
  if (!finite(spring.damping) || spring.damping < 0) refuse("Spring: damping must be finite and not negative (N s/m)");
}

void check(const ConstantForce& constant, const BodySet& bodies) {
  need_body(constant.body, bodies, "ConstantForce: body");
  if (!finite(constant.force) || !finite(constant.torque)) refuse("ConstantForce: force and torque must be finite");
}

void append_bodies(const Attraction& attraction, const BodySet& bodies, std::vector<std::uint32_t>& out) {
  const std::uint32_t from = attraction.from.index;
  if (!bodies.detail[from].inserted) return;
  out.push_back(from);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (i == from || !bodies.detail[i].inserted || !bodies.dynamic(i)) continue;
    if (length(bodies.pose[from].p - bodies.pose[i].p) <= attraction.reach) out.push_back(i);
  }
}

void append_bodies(const Spring& spring, const BodySet& bodies, std::vector<std::uint32_t>& out) {
  const auto away = [&](BodyId end) { return end != BodyId{} && !bodies.detail[end.index].inserted; };
  if (away(spring.a) || away(spring.b)) return;
  for (const BodyId end : {spring.a, spring.b}) {
    if (end != BodyId{}) out.push_back(end.index);
  }
}

void append_bodies(const ConstantForce& constant, const BodySet&, std::vector<std::uint32_t>& out) {
  out.push_back(constant.body.index);
}

bool names(const Attraction& attraction, BodyId body) { return attraction.from == body; }
bool names(const Spring& spring, BodyId body) { return spring.a == body || spring.b == body; }
bool names(const ConstantForce& constant, BodyId body) { return constant.body == body; }

}  // namespace impulse::inline IMPULSE_PRECISION
