// What nothing touches moves by the scene's forces and the impulses of its joints alone.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "reports/judge/groups.h"
#include "reports/judge/invariant.h"
#include "reports/judge/joint_geometry.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/neighbours.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/vec.h"

// No word of the engine says what touches: the shapes and the velocities do (see Neighbours). For a body alone,
// m dv = F dt and I dw = T dt. For bodies held by joints (d'Alembert), the rest M dv - F dt must be J^T lambda for some
// impulses lambda along the joints' directions J. The check measures what is left of it after the best fit of lambda,
// in the norm sum |p|^2/m + L^2/I, times the root of the group's mass: for one body that is |m dv - F dt|.
//
// A limit of a joint gives an impulse only in a step in which the joint may reach it, and only away from it. The joint
// may turn by the larger of what it did turn and what its velocities before or after would give, by what the forces
// add, (F/(m r) + T/I) dt^2 at the arms r, and by the stated slop; a slider likewise, by r times that. The stated lead
// of impacts makes the step longer. Where the fit lets one limit pull, the best fit without that one is the best one
// that is allowed, as the square of what is left is convex in every impulse. If that lets another one pull, the first
// fit stays, which leaves less.
//
// The tolerance covers:
// - the forces, known at both ends of the step (see AppliedForces::change_in);
// - the joints' directions, which turn within the step from J0 to J1. The fit takes their mean; whenever within the
//   step an impulse acts, its direction is off by at most half of J1 - J0, and by an eighth of both rates for the arc.
//   A method with one solve a step takes J0 or J1 for all impulses, so either may fit better. What counts is the size
//   of the impulse and, as it may pass zero within the step, half of what it changed by since the step before: if it
//   changes evenly, it is off from its mean by no more. The anchors may be apart by the stated slop, and the impulse
//   may act at either. Where a body on a path gets another velocity at the start of a step, by c, that impulse is along
//   J0, and the others of the step may hide it from the fit: at most sqrt(m) c in the norm below, m the group's mass;
// - damping c, which a first-order method takes from either end: c dt of the change that the damping and the forces
//   make;
// - sleep, which stops a body of at most the stated speed;
// - round-off, once for the body and once for each of its joints: of the largest momentum so far, as a small velocity
//   may be the difference of larger ones, or of positions (see `differenced`);
// - the round-off of places. A joint puts its bodies where its anchors meet, known to u X, X the distances of both
//   bodies and anchors. A method that keeps the energy of what joints hold takes the work of the forces from these
//   places: E = sum |F| u X too much or too little in each of n sub-steps. With w the length of the momentum in the
//   norm above, w^2/2 is off by n E: w by n E/w, and where it passes zero within the step by sqrt(2 n E). Where no
//   force works, one that puts places right by velocities still gives each body u X/h.
namespace plumb::invariants::free_motion {
namespace {

// Impulses of a group in coordinates in which the kinetic energy is half the square of the length: p/sqrt(m),
// L/sqrt(I). Three for each body.
using Vector = std::vector<double>;

double norm(const Vector& v) {
  double square = 0;
  for (const double one : v) square += one * one;
  return std::sqrt(square);
}

double product(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

struct Row {
  std::size_t a = 0, b = 0;  // bodies, in the group
  double at_a[3], at_b[3];   // in the coordinates above

  double times(const Vector& v) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += at_a[i] * v[3 * a + i] + at_b[i] * v[3 * b + i];
    return sum;
  }
  void add_to(Vector& v, double factor) const {
    for (std::size_t i = 0; i < 3; ++i) {
      v[3 * a + i] += factor * at_a[i];
      v[3 * b + i] += factor * at_b[i];
    }
  }
  double size() const {
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) square += at_a[i] * at_a[i] + at_b[i] * at_b[i];
    return std::sqrt(square);
  }
};

// What is left of v after the best fit of the rows, and the fit: conjugate gradients on the normal equations (CGLS;
// Bjoerck, Numerical Methods for Least Squares Problems, 7.4.1), which also serves rows that depend on each other.
// Each step of theirs leaves less of v. Where one doesn't, only rounding is left to be fitted, and further steps would
// grow without bound.
struct Fit {
  Vector rest, lambda;
};

Fit fitted(Vector v, const std::vector<Row>& rows) {
  Fit fit{std::move(v), Vector(rows.size())};
  const auto gradient_of = [&](const Vector& rest) {
    Vector gradient;
    for (const Row& row : rows) gradient.push_back(row.times(rest));
    return gradient;
  };
  Vector gradient = gradient_of(fit.rest);
  Vector direction = gradient;
  double square = product(gradient, gradient);
  const double enough = 1e-30 * square;
  double left = product(fit.rest, fit.rest);
  for (std::size_t i = 0; i < 8 * rows.size() && square > enough; ++i) {
    Vector image(fit.rest.size());
    for (std::size_t r = 0; r < rows.size(); ++r) rows[r].add_to(image, direction[r]);
    const double curvature = product(image, image);
    if (!(curvature > 0)) break;
    const double step = square / curvature;
    for (std::size_t k = 0; k < image.size(); ++k) image[k] = fit.rest[k] - step * image[k];
    const double less = product(image, image);
    if (!(less < left)) break;
    left = less;
    fit.rest = std::move(image);
    for (std::size_t r = 0; r < rows.size(); ++r) fit.lambda[r] += step * direction[r];
    gradient = gradient_of(fit.rest);
    const double next = product(gradient, gradient);
    for (std::size_t r = 0; r < rows.size(); ++r) direction[r] = gradient[r] + next / square * direction[r];
    square = next;
  }
  return fit;
}

Row combined(double of_one, const Row& one, double of_other, const Row& other) {
  Row sum = one;
  for (std::size_t i = 0; i < 3; ++i) {
    sum.at_a[i] = of_one * one.at_a[i] + of_other * other.at_a[i];
    sum.at_b[i] = of_one * one.at_b[i] + of_other * other.at_b[i];
  }
  return sum;
}

class FreeMotion {
 public:
  explicit FreeMotion(const InvariantContext& context)
      : context_(context),
        forces_(context.scene),
        joints_(context.scene),
        members_(context.scene.bodies.size()),
        place_(context.scene.bodies.size()),
        largest_(context.scene.bodies.size()),
        last_(joints_.rows(context.trace.states(0)).size()) {
    Groups groups(members_.size());
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      const auto [a, b] = joints_.bodies(joint);
      if (moves(a) && moves(b)) groups.join(a, b);
    }
    for (std::size_t i = 0; i < members_.size(); ++i) {
      if (!moves(i)) continue;
      std::vector<std::size_t>& of = members_[groups.of(i)];
      place_[i] = of.size();
      of.push_back(i);
    }
  }

  InvariantCheck check() {
    for (std::size_t moment = 1; moment < context_.trace.size(); ++moment) {
      const Step step = step_to(moment);
      std::vector<bool> touched(members_.size());
      for (const BodyGap& pair : context_.neighbours.in_step(moment)) touched[pair.a] = touched[pair.b] = true;
      for (const std::vector<std::size_t>& group : members_) {
        const auto is_touched = [&](std::size_t body) { return touched[body]; };
        if (group.empty() || std::any_of(group.begin(), group.end(), is_touched)) continue;
        add(step, group);
      }
    }
    return worst_.result();
  }

 private:
  bool moves(std::size_t body) const { return forces_.masses()[body].mass > 0; }

  Row row_of(const JointRow& joint) const {
    Row row{place_[joint.a], place_[joint.b], {}, {}};
    const auto fill = [&](std::size_t body, double sign, double turn, double(&at)[3]) {
      if (!moves(body)) return;
      const Mass& mass = forces_.masses()[body];
      at[0] = sign * joint.direction.x / std::sqrt(mass.mass);
      at[1] = sign * joint.direction.y / std::sqrt(mass.mass);
      at[2] = mass.inertia > 0 ? turn / std::sqrt(mass.inertia) : 0;
    };
    fill(joint.a, -1, joint.turn_a, row.at_a);
    fill(joint.b, 1, joint.turn_b, row.at_b);
    return row;
  }

  // A step, and what joints would be like a step after its start, and a step before its end, at the velocities there.
  struct Step {
    std::size_t moment;
    std::vector<Wrench> start, end;
    std::vector<WrenchError> off;  // of their mean
    std::vector<JointRow> rows_start, rows_end, rows_ahead, rows_behind;
  };

  Step step_to(std::size_t moment) const {
    const auto& trace = context_.trace;
    const double dt = trace.time(moment) - trace.time(moment - 1);
    const auto then = trace.states(moment - 1);
    const auto now = trace.states(moment);
    const std::vector<BodyState> ahead = moved_on(then, dt);
    const std::vector<BodyState> behind = moved_on(now, -dt);
    return {moment,
            forces_.at(then),
            forces_.at(now),
            forces_.change_in(then, now, dt),
            joints_.rows(then),
            joints_.rows(now),
            joints_.rows(ahead),
            joints_.rows(behind)};
  }

  // The impulses that a row may have: of a limit only those that push away from it.
  struct Signs {
    bool positive = true, negative = true;
    bool allow(double impulse) const { return impulse > 0 ? positive : impulse == 0 || negative; }
  };

  // The directions of a group's joints, and by how much each may be off from their mean over the step.
  struct Directions {
    std::vector<std::size_t> which;  // of all joints' rows
    std::vector<Row> start, mean, end;
    std::vector<double> off;
    std::vector<Signs> signs;
  };

  // The limits that a joint may reach within a step.
  Signs limits_in(const Step& step, std::size_t joint) const {
    const auto& trace = context_.trace;
    const double dt = trace.time(step.moment) - trace.time(step.moment - 1);
    const auto then = trace.states(step.moment - 1);
    const auto now = trace.states(step.moment);
    const auto [a, b] = joints_.bodies(joint);
    const auto [arm_a, arm_b] = joints_.arms(joint);
    const bool slides = joints_.slides(joint);
    const double slop = context_.stepping.joint_slop;
    double reach = slop > 0 ? slop / (slides ? 1 : arm_a + arm_b) : 0;
    for (const auto& [body, arm] : {std::pair{a, arm_a}, std::pair{b, arm_b}}) {
      const Mass& mass = forces_.masses()[body];
      const double per_force = slides ? 1 : arm > 0 ? 1 / arm : 0;
      const double per_torque = slides ? arm : 1;
      if (mass.mass > 0) reach += dt * dt * length(step.start[body].force) / mass.mass * per_force;
      if (mass.inertia > 0) reach += dt * dt * std::abs(step.start[body].torque) / mass.inertia * per_torque;
    }
    const LimitRoom room = joints_.room(joint, then).value();
    const LimitRoom after = joints_.room(joint, now).value();
    const double ahead = 1 + context_.stepping.impact_lead * context_.stepping.h / dt;
    reach += ahead * std::max({std::abs(after.low - room.low), dt * std::abs(room.rate), dt * std::abs(after.rate)});
    return {.positive = room.low <= reach, .negative = room.high <= reach};
  }

  // What the stated slop between the anchors changes of the arms on both bodies.
  double apart(const JointRow& joint) const {
    double sum = 0;
    for (const std::size_t body : {joint.a, joint.b}) {
      const double inertia = forces_.masses()[body].inertia;
      if (inertia > 0 && joint.direction != Vec{}) sum += context_.stepping.joint_slop / std::sqrt(inertia);
    }
    return sum;
  }

  // m/s, by which bodies on paths that carry the group change their velocities at the start of the step.
  double jump_of_paths(const Step& step, const std::vector<std::size_t>& group) const {
    const auto then = context_.trace.states(step.moment - 1);
    const auto now = context_.trace.states(step.moment);
    double sum = 0;
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      const auto [a, b] = joints_.bodies(joint);
      const std::size_t carrier = moves(a) ? b : a;
      if (!context_.scene.bodies[carrier].path) continue;
      if (std::find(group.begin(), group.end(), moves(a) ? a : b) == group.end()) continue;
      sum += length(now[carrier].velocity - then[carrier].velocity);
    }
    return sum;
  }

  Directions directions_of(const Step& step, const std::vector<std::size_t>& group) const {
    Directions directions;
    for (std::size_t r = 0; r < step.rows_start.size(); ++r) {
      const JointRow& joint = step.rows_start[r];
      if (std::find(group.begin(), group.end(), moves(joint.a) ? joint.a : joint.b) == group.end()) continue;
      const Signs signs = joint.limits_of ? limits_in(step, *joint.limits_of) : Signs{};
      if (!signs.positive && !signs.negative) continue;
      directions.which.push_back(r);
      directions.signs.push_back(signs);
      const Row start = row_of(joint);
      const Row end = row_of(step.rows_end[r]);
      directions.start.push_back(start);
      directions.end.push_back(end);
      directions.mean.push_back(combined(0.5, start, 0.5, end));
      directions.off.push_back(apart(joint) + combined(1, end, -1, start).size() / 2 +
                               (combined(1, row_of(step.rows_ahead[r]), -1, start).size() +
                                combined(1, end, -1, row_of(step.rows_behind[r])).size()) /
                                   8);
    }
    return directions;
  }

  // The best fit of impulses that may be.
  static Fit allowed_fit(const Vector& missing, const std::vector<Row>& rows, const std::vector<Signs>& signs) {
    Fit fit = fitted(missing, rows);
    const auto pulls = [&](const Fit& of) {
      std::vector<std::size_t> all;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        if (!signs[r].allow(of.lambda[r])) all.push_back(r);
      }
      return all;
    };
    const std::vector<std::size_t> pulling = pulls(fit);
    if (pulling.size() != 1) return fit;
    const auto which = static_cast<std::ptrdiff_t>(pulling.front());
    std::vector<Row> others = rows;
    others.erase(others.begin() + which);
    Fit without = fitted(missing, others);
    without.lambda.insert(without.lambda.begin() + which, 0);
    return pulls(without).empty() ? without : fit;
  }

  // In the norm of a group's momentum, by how much the round-off of places changes it in a step.
  double round_off_of_places(const Step& step, const std::vector<std::size_t>& group, double slowest) const {
    const auto& [scene, trace, stepping, neighbours] = context_;
    double energy = 0;   // J
    double squares = 0;  // N^2 s^2/kg
    for (const std::size_t i : group) {
      double farthest = 0;  // m
      for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
        const auto [a, b] = joints_.bodies(joint);
        if (a != i && b != i) continue;
        const auto [arm_a, arm_b] = joints_.arms(joint);
        const auto states = trace.states(step.moment);
        farthest = std::max(farthest, length(states[a].position) + arm_a + length(states[b].position) + arm_b);
      }
      energy += length(step.end[i].force) * stepping.epsilon * farthest;
      const double put_right = stepping.h > 0 ? stepping.epsilon * farthest / stepping.h : 0;  // m/s
      squares += forces_.masses()[i].mass * put_right * put_right;
    }
    const double dt = trace.time(step.moment) - trace.time(step.moment - 1);
    energy *= stepping.h > 0 ? std::max(1.0, dt / stepping.h) : 1;
    const double at_rest = std::sqrt(2 * energy);
    if (energy == 0) return std::sqrt(squares);
    return slowest > at_rest ? energy / slowest : at_rest;
  }

  void add(const Step& step, const std::vector<std::size_t>& group) {
    const auto& [scene, trace, stepping, neighbours] = context_;
    const double time = trace.time(step.moment);
    const double dt = time - trace.time(step.moment - 1);
    Vector missing, force, force_change, momentum, damping, before, after, places;
    double total = 0;
    double most_damped = 0;  // c dt
    bool stopped = stepping.rest_speed > 0;
    for (const std::size_t i : group) {
      const BodyState& then = trace.states(step.moment - 1)[i];
      const BodyState& now = trace.states(step.moment)[i];
      const Mass& mass = forces_.masses()[i];
      const double m = std::sqrt(mass.mass);
      const double k = std::sqrt(mass.inertia);
      const double per_k = k > 0 ? 1 / k : 0;
      const double damped = dt * scene.bodies[i].linear_damping;
      const double spin_damped = dt * scene.bodies[i].angular_damping;
      const auto push = [](Vector& to, Vec linear, double angular) {
        to.insert(to.end(), {linear.x, linear.y, angular});
      };
      push(force, dt / (2 * m) * (step.start[i].force + step.end[i].force),
           dt / 2 * (step.start[i].torque + step.end[i].torque) * per_k);
      force_change.push_back(dt * (step.off[i].force / m + step.off[i].torque * per_k));
      push(momentum, m * now.velocity + m * then.velocity, k * (now.angular_velocity + then.angular_velocity));
      push(damping, damped * m / 2 * (now.velocity + then.velocity),
           spin_damped * k / 2 * (now.angular_velocity + then.angular_velocity));
      push(before, m * then.velocity, k * then.angular_velocity);
      places.push_back(differenced(stepping, m * length(now.position) + k * std::abs(now.angle), dt));
      push(after, m * now.velocity, k * now.angular_velocity);
      push(missing, m * (now.velocity - then.velocity), k * (now.angular_velocity - then.angular_velocity));
      total += mass.mass;
      most_damped = std::max({most_damped, damped, spin_damped});
      stopped = stopped && now.velocity == Vec{} && now.angular_velocity == 0;
    }
    for (std::size_t i = 0; i < missing.size(); ++i) missing[i] += damping[i] - force[i];
    const double scaled = std::sqrt(total);
    const double force_size = norm(force);
    const double momentum_size = norm(momentum);
    double& largest = largest_[group.front()];
    largest = std::max(largest, momentum_size + norm(places));
    const double slowest = product(before, after) > 0 ? std::min(norm(before), norm(after)) : 0;
    const double known = round_off_of_places(step, group, slowest) + norm(force_change) +
                         most_damped * (norm(damping) + force_size) +
                         (stopped ? std::min(momentum_size, 2 * scaled * stepping.rest_speed) : 0) +
                         solver_rounding(stepping) * (largest + force_size) + 2 * 0x1p-53 * time / dt * force_size;
    const Directions directions = directions_of(step, group);
    const double jump = scaled * jump_of_paths(step, group);
    double rest = 0;
    double tolerance = 0;
    Vector impulses;
    for (const std::vector<Row>* rows : {&directions.mean, &directions.start, &directions.end}) {
      const Fit fit = allowed_fit(missing, *rows, directions.signs);
      double joints = 0;
      for (std::size_t r = 0; r < rows->size(); ++r) {
        const double size = (*rows)[r].size();
        joints += std::abs(fit.lambda[r]) * (directions.off[r] + solver_rounding(stepping) * size);
        const Impulse& last = last_[directions.which[r]];
        if (last.moment + 1 == step.moment) joints += std::abs(fit.lambda[r] - last.size) / 2 * directions.off[r];
        if (size > 0) joints += jump / size * directions.off[r];
      }
      const double ratio = error_ratio(norm(fit.rest), known + joints);
      if (rows != &directions.mean && ratio >= error_ratio(rest, tolerance)) continue;
      rest = norm(fit.rest);
      tolerance = known + joints;
      impulses = fit.lambda;
      if (ratio <= 1) break;
    }
    for (std::size_t r = 0; r < impulses.size(); ++r) last_[directions.which[r]] = {step.moment, impulses[r]};
    // At rest, the joints may carry all of the forces: then nothing tests the law.
    const double untold = force_size > 0 ? norm(fitted(force, directions.mean).rest) : momentum_size / 2;
    worst_.add(scaled * rest, scaled * tolerance, scaled * untold, time,
               [&] { return context_.scene.bodies[group.front()].name; });
  }

  struct Impulse {
    std::size_t moment = std::numeric_limits<std::size_t>::max();  // none
    double size = 0;
  };

  const InvariantContext& context_;
  AppliedForces forces_;
  JointGeometry joints_;
  std::vector<std::vector<std::size_t>> members_;  // of the group with that index
  std::vector<std::size_t> place_;                 // of a body in its group
  std::vector<double> largest_;                    // momentum of a group so far, by its first body
  std::vector<Impulse> last_;                      // of each row
  WorstViolation worst_;
};

const Catalog<Invariant>::Entry entry{
    {.name = "free_motion",
     .unit = "kg m/s",
     .definition = "what nothing touches, by the scene's shapes, changes its momentum by the scene's forces and by "
                   "impulses along its joints alone",
     .check = [](const InvariantContext& context) -> std::optional<InvariantCheck> {
       return FreeMotion(context).check();
     }}};

}  // namespace
}  // namespace plumb::invariants::free_motion
