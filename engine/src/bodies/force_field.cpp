#include "bodies/force_field.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real greatest_exponent = 16;  // beyond this, powers of lengths in m overflow a float

[[noreturn]] void refuse_force(const char* what) { throw std::invalid_argument(what); }

void require_body(BodyId id, const BodySet& bodies, const char* what) {
  if (!bodies.contains(id)) throw std::out_of_range(std::string(what) + " is not a body of this world");
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

/// base^(halves/2) from products, square roots and one quotient. Unlike std::pow, the bits are the same everywhere.
Real power_of_halves(Real base, int halves) {
  const int n = halves < 0 ? -halves : halves;
  const Real whole = integer_power(base, n / 2);
  const Real result = n % 2 == 1 ? whole * std::sqrt(base) : whole;
  return halves < 0 ? 1 / result : result;
}

/// One end of a spring: a point on a body or in the world.
struct SpringEnd {
  std::size_t row = 0;
  bool on_body = false;
  bool present = true;  // false if the body is not in the world
  Vec2 arm;             // from the centre of mass, world frame
  Vec2 point;           // world frame
  Vec2 velocity;        // of the point

  SpringEnd(BodyId body, Vec2 anchor, const BodySet& bodies, const std::vector<Velocity>& velocities) : point(anchor) {
    if (body == BodyId{}) return;
    row = body.index;
    on_body = true;
    present = bodies.detail[row].inserted;
    arm = bodies.pose[row].q * (anchor - bodies.detail[row].mass.center);
    point = bodies.pose[row].p + arm;
    const Velocity& of_body = bodies.pushable(row) ? velocities[row] : bodies.velocity[row];
    velocity = of_body.v + cross(of_body.w, arm);
  }

  void pull(Vec2 force, const BodySet& bodies, std::vector<Velocity>& out) const {
    if (!on_body) return;
    out[row].v += bodies.inverse_mass[row].m * force;
    out[row].w += bodies.inverse_mass[row].i * cross(arm, force);
  }
};

/// Adds the acceleration of row i, m/s^2, and what it gives back.
void accelerate(const Attraction& attraction, std::size_t i, const BodySet& bodies, std::vector<Velocity>& out) {
  const std::size_t from = attraction.from.index;
  const Real inverse_mass = bodies.inverse_mass[i].m;
  if (i == from || inverse_mass == 0 || !bodies.detail[from].inserted) return;
  const Vec2 line = bodies.pose[from].p - bodies.pose[i].p;
  const Real r = length(line);
  if (r == 0 || r > attraction.reach) return;
  // `line` has length r instead of 1, so divide by one more power of r.
  const int halves = static_cast<int>(2 * attraction.exponent) + 2;
  const Vec2 acceleration = attraction.strength / power_of_halves(r, halves) * line;
  out[i].v += acceleration;
  const Real inverse_from = bodies.inverse_mass[from].m;
  if (attraction.mutual && inverse_from > 0) out[from].v -= inverse_from / inverse_mass * acceleration;
}

/// Adds the acceleration that the force gives to each body: v in m/s^2, w in rad/s^2.
void accelerate(const Spring& spring, const BodySet& bodies, const std::vector<Velocity>& velocities,
                std::vector<Velocity>& out) {
  const SpringEnd a(spring.a, spring.anchor_a, bodies, velocities);
  const SpringEnd b(spring.b, spring.anchor_b, bodies, velocities);
  if (!a.present || !b.present) return;
  const Vec2 line = b.point - a.point;
  const Real distance = length(line);
  if (distance == 0) return;
  const Vec2 direction = line / distance;
  const Real separating_speed = dot(b.velocity - a.velocity, direction);
  const Vec2 pull = (spring.stiffness * (distance - spring.length) + spring.damping * separating_speed) * direction;
  a.pull(pull, bodies, out);
  b.pull(-pull, bodies, out);
}

/// m, how near something comes within `time` s that is at `line` and goes straight on.
Real nearest(Vec2 line, Vec2 velocity, Real time) {
  const Real squared = dot(velocity, velocity);
  const Real then = squared > 0 ? std::clamp(-dot(line, velocity) / squared, Real{0}, time) : Real{0};
  return length(line + then * velocity);
}

/// See ForceField::passing_rate.
Real rate_past(const Attraction& attraction, std::size_t i, const BodySet& bodies, Real time) {
  const std::size_t from = attraction.from.index;
  if (i == from || bodies.inverse_mass[i].m == 0 || !bodies.detail[from].inserted) return 0;
  if (attraction.exponent <= -1) return 0;
  const Vec2 line = bodies.pose[from].p - bodies.pose[i].p;
  const Vec2 velocity = bodies.velocity[from].v - bodies.velocity[i].v;
  const Real r = nearest(line, velocity, time);
  if (r > attraction.reach) return 0;
  const Real pull = std::abs(attraction.strength) / power_of_halves(r, static_cast<int>(2 * attraction.exponent));
  const Real share = bodies.inverse_mass[from].m / bodies.inverse_mass[i].m;
  const Real acceleration = attraction.mutual ? (1 + share) * pull : pull;
  constexpr Real felt = static_cast<Real>(1e-6);  // m/s
  if (!(acceleration * time > felt)) return 0;
  return std::max(length(velocity), std::sqrt(acceleration * r)) / r;
}

void accelerate(const ConstantForce& constant, const BodySet& bodies, std::vector<Velocity>& out) {
  const std::size_t i = constant.body.index;
  out[i].v += bodies.inverse_mass[i].m * constant.force;
  out[i].w += bodies.inverse_mass[i].i * constant.torque;
}

/// Throws std::invalid_argument for invalid values, std::out_of_range for bodies that don't exist.
void check_force(const Attraction& attraction, const BodySet& bodies) {
  require_body(attraction.from, bodies, "Attraction: from");
  if (!is_finite(attraction.strength)) refuse_force("Attraction: strength must be finite");
  const Real halves = 2 * attraction.exponent;
  if (!is_finite(halves) || std::abs(attraction.exponent) > greatest_exponent || halves != std::floor(halves)) {
    refuse_force("Attraction: exponent must be a multiple of 1/2 from -16 to 16; other powers differ between machines");
  }
  if (!(attraction.reach > 0)) refuse_force("Attraction: reach must be above 0 (m)");
}

void check_force(const Spring& spring, const BodySet& bodies) {
  if (spring.a == spring.b) refuse_force("Spring: needs two different ends");
  if (spring.a != BodyId{}) require_body(spring.a, bodies, "Spring: a");
  if (spring.b != BodyId{}) require_body(spring.b, bodies, "Spring: b");
  if (!is_finite(spring.anchor_a) || !is_finite(spring.anchor_b)) refuse_force("Spring: anchors must be finite");
  if (!is_finite(spring.stiffness) || spring.stiffness < 0)
    refuse_force("Spring: stiffness must be finite and not negative (N/m)");
  if (!is_finite(spring.length) || spring.length < 0)
    refuse_force("Spring: length must be finite and not negative (m)");
  if (!is_finite(spring.damping) || spring.damping < 0)
    refuse_force("Spring: damping must be finite and not negative (N s/m)");
}

void check_force(const ConstantForce& constant, const BodySet& bodies) {
  require_body(constant.body, bodies, "ConstantForce: body");
  if (!is_finite(constant.force) || !is_finite(constant.torque))
    refuse_force("ConstantForce: force and torque must be finite");
}

/// Appends the rows of the bodies whose motion the force makes depend on each other: that of all others on the first.
void append_bodies(const Attraction& attraction, const BodySet& bodies, Real margin, std::vector<std::uint32_t>& out) {
  const std::uint32_t from = attraction.from.index;
  if (!bodies.detail[from].inserted) return;
  out.push_back(from);
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (i == from || !bodies.detail[i].inserted || !bodies.dynamic(i)) continue;
    if (length(bodies.pose[from].p - bodies.pose[i].p) <= attraction.reach + margin) out.push_back(i);
  }
}

void append_bodies(const Spring& spring, const BodySet& bodies, Real, std::vector<std::uint32_t>& out) {
  const auto absent = [&](BodyId end) { return end != BodyId{} && !bodies.detail[end.index].inserted; };
  if (absent(spring.a) || absent(spring.b)) return;
  for (const BodyId end : {spring.a, spring.b}) {
    if (end != BodyId{}) out.push_back(end.index);
  }
}

void append_bodies(const ConstantForce& constant, const BodySet&, Real, std::vector<std::uint32_t>& out) {
  out.push_back(constant.body.index);
}

/// Whether the force refers to the body.
bool refers_to(const Attraction& attraction, BodyId body) { return attraction.from == body; }
bool refers_to(const Spring& spring, BodyId body) { return spring.a == body || spring.b == body; }
bool refers_to(const ConstantForce& constant, BodyId body) { return constant.body == body; }

/// Adds what acts on particular bodies.
void pull(const Force& force, const BodySet& bodies, const std::vector<Velocity>& velocities,
          std::vector<Velocity>& out) {
  if (const auto* spring = std::get_if<Spring>(&force)) accelerate(*spring, bodies, velocities, out);
  if (const auto* constant = std::get_if<ConstantForce>(&force)) accelerate(*constant, bodies, out);
}

/// By gravity and by forces of this step.
Velocity thrust(Vec2 gravity, const BodySet& bodies, std::size_t i) {
  const InverseMass inverse = bodies.inverse_mass[i];
  const Vec2 falling = inverse.m > 0 ? bodies.response[i].gravity_scale * gravity : Vec2{};
  return {falling + inverse.m * bodies.force[i], inverse.i * bodies.torque[i]};
}

bool damped(const Response& response) { return response.linear_damping > 0 || response.angular_damping > 0; }

/// See ForceField::accelerations().
void damp(const BodySet& bodies, std::size_t i, const Velocity& velocity, Real implicit, Real reach,
          std::vector<Velocity>& out) {
  if (bodies.inverse_mass[i].m == 0) return;
  const auto slowed = [&](Real damping) { return std::max(1 + implicit * damping, reach * damping); };
  const Real linear = bodies.response[i].linear_damping;
  const Real angular = bodies.response[i].angular_damping;
  if (linear > 0) out[i].v = (out[i].v - linear * velocity.v) / slowed(linear);
  if (angular > 0) out[i].w = (out[i].w - angular * velocity.w) / slowed(angular);
}

}  // namespace

void ForceField::attract(const BodySet& bodies, std::size_t row, std::vector<Velocity>& out) const {
  for (const std::uint32_t slot : attractions_) accelerate(std::get<Attraction>(*slots_[slot].force), row, bodies, out);
}

void ForceField::accelerations(const BodySet& bodies, Real implicit, std::vector<Velocity>& out, Real reach) const {
  const std::size_t n = bodies.size();
  out.resize(n);
  for (std::size_t i = 0; i < n; ++i) out[i] = thrust(gravity, bodies, i);
  for (std::size_t i = 0; i < n && !attractions_.empty(); ++i) attract(bodies, i, out);
  for (const Slot& slot : slots_) {
    if (slot.force) pull(*slot.force, bodies, bodies.velocity, out);
  }
  for (std::size_t i = 0; i < n; ++i) damp(bodies, i, bodies.velocity[i], implicit, reach, out);
}

void ForceField::accelerations(const BodySet& bodies, std::span<const std::uint32_t> rows, std::span<const Pull> pulls,
                               Real implicit, const std::vector<Velocity>& held, const std::vector<Velocity>& later,
                               std::vector<Velocity>& out) const {
  for (const std::uint32_t i : rows) out[i] = thrust(gravity, bodies, i);
  for (const std::uint32_t i : rows) attract(bodies, i, out);
  for (const Pull& one : pulls) pull(*slots_[one.slot].force, bodies, later, out);
  for (const std::uint32_t i : rows) damp(bodies, i, held[i], implicit, 0, out);
}

Real ForceField::passing_rate(const BodySet& bodies, std::span<const std::uint32_t> rows, Real time) const {
  Real fastest = 0;
  for (const std::uint32_t i : rows) {
    for (const std::uint32_t slot : attractions_) {
      fastest = std::max(fastest, rate_past(std::get<Attraction>(*slots_[slot].force), i, bodies, time));
    }
  }
  return fastest;
}

bool ForceField::vary(const BodySet& bodies) const {
  const auto varying = [](const Slot& slot) {
    return slot.force && !std::holds_alternative<ConstantForce>(*slot.force);
  };
  return std::any_of(slots_.begin(), slots_.end(), varying) ||
         std::any_of(bodies.response.begin(), bodies.response.end(), damped);
}

void ForceField::find_varying(const BodySet& bodies, std::vector<std::uint8_t>& out) const {
  out.resize(bodies.size());
  const bool attracted = !attractions_.empty();  // whatever their reach: a body may come into it
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = bodies.pushable(i) && (attracted || damped(bodies.response[i])) ? 1 : 0;
  }
  for (const Slot& slot : slots_) {
    const auto* spring = slot.force ? std::get_if<Spring>(&*slot.force) : nullptr;
    if (spring == nullptr) continue;
    for (const BodyId end : {spring->a, spring->b}) {
      if (end != BodyId{} && bodies.pushable(end.index)) out[end.index] = 1;
    }
  }
}

void ForceField::list_pulls(const BodySet& bodies, std::vector<Pull>& out) const {
  out.clear();
  std::vector<std::uint32_t> rows;
  for (std::uint32_t slot = 0; slot < slots_.size(); ++slot) {
    if (!slots_[slot].force || std::holds_alternative<Attraction>(*slots_[slot].force)) continue;
    rows.clear();
    std::visit([&](const auto& force) { append_bodies(force, bodies, 0, rows); }, *slots_[slot].force);
    const auto moved = std::find_if(rows.begin(), rows.end(), [&](std::uint32_t row) { return bodies.pushable(row); });
    if (moved != rows.end()) out.push_back({slot, *moved});
  }
}

ForceId ForceField::add(const Force& force, const BodySet& bodies) {
  std::visit([&bodies](const auto& one) { check_force(one, bodies); }, force);
  if (free_slots_.empty()) {
    slots_.emplace_back();
    free_slots_.push_back(static_cast<std::uint32_t>(slots_.size() - 1));
  }
  const std::uint32_t i = free_slots_.back();
  free_slots_.pop_back();
  slots_[i].force = force;
  if (std::holds_alternative<Attraction>(force)) {
    attractions_.insert(std::upper_bound(attractions_.begin(), attractions_.end(), i), i);
  }
  return {i, slots_[i].generation};
}

bool ForceField::contains(ForceId id) const {
  return id.index < slots_.size() && slots_[id.index].force && slots_[id.index].generation == id.generation;
}

void ForceField::require(ForceId id) const {
  if (!contains(id))
    throw std::out_of_range("World: no force " + std::to_string(id.index) +
                            "; it was removed or one of its bodies was destroyed");
}

std::vector<std::uint32_t> ForceField::bodies_of(ForceId id, const BodySet& bodies) const {
  require(id);
  std::vector<std::uint32_t> rows;
  std::visit([&](const auto& force) { append_bodies(force, bodies, 0, rows); }, *slots_[id.index].force);
  return rows;
}

void ForceField::append_pairs(const BodySet& bodies, std::vector<std::pair<std::uint32_t, std::uint32_t>>& out,
                              Real margin) const {
  std::vector<std::uint32_t> rows;
  for (const Slot& slot : slots_) {
    if (!slot.force) continue;
    rows.clear();
    std::visit([&](const auto& force) { append_bodies(force, bodies, margin, rows); }, *slot.force);
    for (std::size_t i = 1; i < rows.size(); ++i) out.emplace_back(rows[0], rows[i]);
  }
}

void ForceField::append_sprung(const BodySet& bodies, std::vector<std::uint32_t>& rows) const {
  for (const Slot& slot : slots_) {
    if (!slot.force) continue;
    if (const auto* spring = std::get_if<Spring>(&*slot.force)) append_bodies(*spring, bodies, 0, rows);
  }
}

bool ForceField::attracts(const BodySet& bodies, std::size_t row) const {
  std::vector<Velocity> pull(attractions_.empty() ? 0 : row + 1);
  if (pull.empty()) return false;
  attract(bodies, row, pull);
  return pull[row].v != Vec2{};
}

void ForceField::remove(ForceId id) {
  require(id);
  free_slot(id.index);
}

void ForceField::forget(BodyId body) {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto involved = [body](const auto& force) { return refers_to(force, body); };
    if (slots_[i].force && std::visit(involved, *slots_[i].force)) free_slot(i);
  }
}

void ForceField::free_slot(std::size_t slot) {
  std::erase(attractions_, slot);
  slots_[slot].force.reset();
  ++slots_[slot].generation;
  free_slots_.push_back(static_cast<std::uint32_t>(slot));
}

}  // namespace impulse::inline IMPULSE_PRECISION
