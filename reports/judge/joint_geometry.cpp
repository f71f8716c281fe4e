#include "reports/judge/joint_geometry.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/judge/mechanics.h"
#include "scenarios/scene/vec.h"

namespace plumb {

JointGeometry::JointGeometry(const Scene& scene) {
  const std::vector<BodyState> start = initial_states(scene);
  for (const Body& body : scene.bodies) masses_.push_back(mass_of(body));
  for (const Joint& joint : scene.joints) {
    const JointFacts facts = facts_of(joint);
    const auto local = [&](std::size_t body, Vec point) {
      return rotated(point - start[body].position, -start[body].angle);
    };
    Ends ends{.keeps = facts.keeps,
              .a = facts.a,
              .b = facts.b,
              .at_a = local(facts.a, facts.anchor_a),
              .at_b = local(facts.b, facts.anchor_b),
              .length = facts.length,
              .angle = start[facts.b].angle - start[facts.a].angle};
    if (facts.keeps == Keeps::line) ends.axis = rotated(1 / length(facts.axis) * facts.axis, -start[facts.a].angle);
    if (facts.limits != nullptr) ends.limits = *facts.limits;
    if (facts.motor != nullptr) ends.motor = *facts.motor;
    for (const std::size_t body : {facts.a, facts.b}) {
      const double mass = masses_[body].mass;
      if (mass > 0) ends.rate += facts.stiffness / mass;
    }
    ends_.push_back(ends);
  }
}

JointGeometry::Travel JointGeometry::travel_of(const Ends& joint, const BodyState& a, const BodyState& b) {
  if (joint.keeps != Keeps::line) {
    return {b.angle - a.angle - joint.angle, b.angular_velocity - a.angular_velocity};
  }
  const auto velocity = [](const BodyState& of, Vec arm) {
    return of.velocity + of.angular_velocity * Vec{-arm.y, arm.x};
  };
  const Vec axis = rotated(joint.axis, a.angle);
  const Vec on_b = b.position + rotated(joint.at_b, b.angle);
  const Vec apart = on_b - a.position - rotated(joint.at_a, a.angle);
  return {dot(axis, apart), dot(axis, velocity(b, on_b - b.position) - velocity(a, on_b - a.position))};
}

std::optional<LimitRoom> JointGeometry::room_of(const Ends& joint, const BodyState& a, const BodyState& b) {
  if (!joint.limits) return std::nullopt;
  const auto [way, rate] = travel_of(joint, a, b);
  return LimitRoom{way - joint.limits->low, joint.limits->high - way, rate};
}

double JointGeometry::beyond_limits(const Ends& joint, const BodyState& a, const BodyState& b) {
  const auto room = room_of(joint, a, b);
  return room ? std::max({0.0, -room->low, -room->high}) : 0;
}

double JointGeometry::gap_beyond_limits(const Ends& joint, const BodyState& a, const BodyState& b) {
  const double arm = joint.keeps == Keeps::line ? 1 : length(joint.at_a) + length(joint.at_b);
  return beyond_limits(joint, a, b) * arm;
}

std::vector<JointRow> JointGeometry::rows(std::span<const BodyState> states) const {
  std::vector<JointRow> rows;
  for (std::size_t index = 0; index < ends_.size(); ++index) {
    const Ends& joint = ends_[index];
    const Vec point_a = states[joint.a].position + rotated(joint.at_a, states[joint.a].angle);
    const Vec point_b = states[joint.b].position + rotated(joint.at_b, states[joint.b].angle);
    const auto along = [&](Vec direction, Vec on_a) {
      rows.push_back({joint.a, joint.b, direction, -cross(on_a - states[joint.a].position, direction),
                      cross(point_b - states[joint.b].position, direction)});
    };
    switch (joint.keeps) {
      case Keeps::point:
      case Keeps::pose:
        along({1, 0}, point_a);
        along({0, 1}, point_a);
        break;
      case Keeps::line: {
        const Vec axis = rotated(joint.axis, states[joint.a].angle);
        along({-axis.y, axis.x}, point_b);
        if (joint.motor || joint.limits) along(axis, point_b);
        if (!joint.motor && joint.limits) rows.back().limits_of = index;
        break;
      }
      case Keeps::rod:
      case Keeps::spring: {
        const Vec between = point_b - point_a;
        const double distance = length(between);
        along(distance > 0 ? 1 / distance * between : Vec{1, 0}, point_a);
        break;
      }
    }
    const bool turns = joint.keeps == Keeps::line || joint.keeps == Keeps::pose;
    const bool turned = joint.motor.has_value() && joint.keeps == Keeps::point;
    if (turns || turned || joint.limits) rows.push_back({joint.a, joint.b, {}, -1, 1});
    if (!turns && !turned && joint.limits) rows.back().limits_of = index;
  }
  return rows;
}

double JointGeometry::error(std::size_t index, std::span<const BodyState> states) const {
  const Ends& joint = ends_[index];
  const BodyState& a = states[joint.a];
  const BodyState& b = states[joint.b];
  const Vec between = b.position + rotated(joint.at_b, b.angle) - a.position - rotated(joint.at_a, a.angle);
  const double turned = std::abs(b.angle - a.angle - joint.angle) * (length(joint.at_a) + length(joint.at_b));
  switch (joint.keeps) {
    case Keeps::point:
      return length(between) + gap_beyond_limits(joint, a, b);
    case Keeps::pose:
      return length(between) + turned;
    case Keeps::line:
      return std::abs(cross(rotated(joint.axis, a.angle), between)) + turned + gap_beyond_limits(joint, a, b);
    case Keeps::rod:
      return std::abs(length(between) - joint.length);
    case Keeps::spring:
      return 0;
  }
  return 0;
}

double JointGeometry::stored(std::size_t index, std::span<const BodyState> states, double frequency) const {
  const Ends& joint = ends_[index];
  if (joint.keeps == Keeps::line || joint.keeps == Keeps::spring) return 0;
  const BodyState& a = states[joint.a];
  const BodyState& b = states[joint.b];
  const Vec arm_a = rotated(joint.at_a, a.angle);
  const Vec arm_b = rotated(joint.at_b, b.angle);
  const Vec apart = b.position + arm_b - a.position - arm_a;
  double xx = 0;  // 1/kg, the inverse effective mass of the anchors
  double xy = 0;
  double yy = 0;
  double about = 0;
  for (const auto& [body, arm] : {std::pair{joint.a, arm_a}, std::pair{joint.b, arm_b}}) {
    const Mass& mass = masses_[body];
    const double inverse = mass.mass > 0 ? 1 / mass.mass : 0;
    const double turns = mass.inertia > 0 ? 1 / mass.inertia : 0;
    xx += inverse + turns * arm.y * arm.y;
    xy -= turns * arm.x * arm.y;
    yy += inverse + turns * arm.x * arm.x;
    about += turns;
  }
  const double square = frequency * frequency;
  if (joint.keeps == Keeps::rod) {
    const double distance = length(apart);
    if (distance == 0) return 0;
    const Vec along = 1 / distance * apart;
    const double inverse = xx * along.x * along.x + 2 * xy * along.x * along.y + yy * along.y * along.y;
    const double longer = distance - joint.length;
    return inverse > 0 ? square * longer * longer / inverse / 2 : 0;
  }
  const double determinant = xx * yy - xy * xy;
  double sum = 0;
  if (determinant > 0) {
    sum = (yy * apart.x * apart.x - 2 * xy * apart.x * apart.y + xx * apart.y * apart.y) / determinant;
  }
  const double turned = b.angle - a.angle - joint.angle;
  if (joint.keeps == Keeps::pose && about > 0) sum += turned * turned / about;
  return square * sum / 2;
}

double JointGeometry::passes_limits(std::size_t index, std::span<const BodyState> states, double dt,
                                    double spin) const {
  const Ends& joint = ends_[index];
  BodyState a = states[joint.a];
  BodyState b = states[joint.b];
  for (BodyState* moved : {&a, &b}) {
    moved->position = moved->position + dt * moved->velocity;
    moved->angle += dt * moved->angular_velocity;
  }
  b.angle += dt * spin;
  return gap_beyond_limits(joint, a, b);
}

double JointGeometry::swung_by(std::size_t index, double force_a, double force_b) const {
  if (slides(index)) return 0;
  const Ends& joint = ends_[index];
  const auto swings = [](const Mass& of, double force, double arm) {
    return of.mass > 0 && arm > 0 ? force * arm / (of.inertia + of.mass * arm * arm) : 0;
  };
  return swings(masses_[joint.a], force_a, length(joint.at_a)) + swings(masses_[joint.b], force_b, length(joint.at_b));
}

double JointGeometry::driven_by(std::size_t index, std::span<const BodyState> states, double dt) const {
  const Ends& joint = ends_[index];
  if (!joint.motor || slides(index)) return 0;
  double per_torque = 0;
  for (const std::size_t body : {joint.a, joint.b}) {
    if (masses_[body].inertia > 0) per_torque += 1 / masses_[body].inertia;
  }
  const double missing = joint.motor->speed - travel_of(joint, states[joint.a], states[joint.b]).rate;
  return std::min(std::abs(missing), dt * joint.motor->strength * per_torque);
}

std::optional<LimitRoom> JointGeometry::room(std::size_t index, std::span<const BodyState> states) const {
  const Ends& joint = ends_[index];
  return room_of(joint, states[joint.a], states[joint.b]);
}

double JointGeometry::drive(std::size_t index, double dt) const {
  const Ends& joint = ends_[index];
  if (!joint.motor) return 0;
  const double impulse = dt * joint.motor->strength;
  double energy = 0;
  for (const std::size_t body : {joint.a, joint.b}) {
    const double mass = slides(index) ? masses_[body].mass : masses_[body].inertia;
    if (mass > 0) energy += impulse * impulse / mass;
  }
  return energy;
}

bool JointGeometry::switches(std::size_t index, std::span<const BodyState> then, std::span<const BodyState> now) const {
  constexpr double at_speed = 1e-6;  // of the speeds: far beyond rounding, and what no step leaves by chance
  const Ends& joint = ends_[index];
  if (!joint.motor) return false;
  const double before = travel_of(joint, then[joint.a], then[joint.b]).rate - joint.motor->speed;
  const double after = travel_of(joint, now[joint.a], now[joint.b]).rate - joint.motor->speed;
  const double near = at_speed * std::max({std::abs(joint.motor->speed), std::abs(before), std::abs(after)});
  const bool was = std::abs(before) <= near;
  const bool is = std::abs(after) <= near;
  return was != is || (!was && (before < 0) != (after < 0));
}

std::pair<double, double> JointGeometry::arms(std::size_t index) const {
  return {length(ends_[index].at_a), length(ends_[index].at_b)};
}

double JointGeometry::acceleration(std::span<const BodyState> states, double gravity) const {
  double sum = ends_.empty() ? 0 : gravity;
  for (const Ends& joint : ends_) {
    const double of_a = states[joint.a].angular_velocity;
    const double of_b = states[joint.b].angular_velocity;
    sum += of_a * of_a * length(joint.at_a) + of_b * of_b * length(joint.at_b);
    const double distance = joint.keeps == Keeps::rod ? joint.length : 0;
    if (distance > 0) {
      const Vec apart = states[joint.b].velocity - states[joint.a].velocity;
      sum += dot(apart, apart) / distance;
    }
  }
  return sum;
}

double JointGeometry::spin(std::span<const BodyState> states) const {
  double fastest = 0;
  for (const Ends& joint : ends_) {
    fastest =
        std::max({fastest, std::abs(states[joint.a].angular_velocity), std::abs(states[joint.b].angular_velocity)});
    if (joint.keeps == Keeps::rod && joint.length > 0) {
      fastest = std::max(fastest, length(states[joint.b].velocity - states[joint.a].velocity) / joint.length);
    }
  }
  return fastest;
}

double JointGeometry::linearisation(std::size_t index, std::span<const BodyState> states, double dt) const {
  const Ends& joint = ends_[index];
  const BodyState& a = states[joint.a];
  const BodyState& b = states[joint.b];
  const auto leaves = [&](const BodyState& of, Vec arm) {
    const double turned = of.angular_velocity * dt;
    return length(arm) * turned * turned / 2;
  };
  double off = leaves(a, joint.at_a) + leaves(b, joint.at_b);
  const double moved = dt * (length(b.velocity - a.velocity) + std::abs(a.angular_velocity) * length(joint.at_a) +
                             std::abs(b.angular_velocity) * length(joint.at_b));
  if (joint.keeps == Keeps::rod && joint.length > 0) off += moved * moved / (2 * joint.length);
  if (joint.keeps == Keeps::spring) off += joint.rate * dt * dt * moved;
  return off;
}

}  // namespace plumb
