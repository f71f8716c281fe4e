#include "reports/judge/method_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <variant>

#include "reference/scene_facts.h"
#include "reports/judge/contacts.h"
#include "reports/judge/groups.h"
#include "reports/judge/overlap.h"
#include "scenarios/allowance.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// Bodies in a row of contacts or joints.
class Rows {
 public:
  explicit Rows(const Scene& scene) : scene_(scene), next_(scene.bodies.size()) {}

  /// Whether the two were not connected before.
  bool connect(std::size_t a, std::size_t b) {
    next_[b].insert(a);
    return next_[a].insert(b).second;
  }

  /// Connections in the longest of the shortest ways from a fixed body. In a group without one, at most twice as many
  /// as from any of its bodies.
  int longest() const {
    std::vector<int> depth(next_.size(), -1);
    std::vector<std::size_t> fixed;
    for (std::size_t i = 0; i < next_.size(); ++i) {
      if (scene_.bodies[i].type != BodyType::dynamic) fixed.push_back(i);
    }
    int most = reach(fixed, depth);
    for (std::size_t i = 0; i < next_.size(); ++i) {
      if (depth[i] < 0) most = std::max(most, 2 * reach({i}, depth));
    }
    return most;
  }

 private:
  int reach(std::vector<std::size_t> from, std::vector<int>& depth) const {
    for (const std::size_t one : from) depth[one] = 0;
    int most = 0;
    for (std::size_t done = 0; done < from.size(); ++done) {
      const std::size_t at = from[done];
      for (const std::size_t other : next_[at]) {
        if (depth[other] >= 0) continue;
        depth[other] = depth[at] + 1;
        most = std::max(most, depth[other]);
        from.push_back(other);
      }
    }
    return most;
  }

  const Scene& scene_;
  std::vector<std::set<std::size_t>> next_;
};

// Bodies that start this close, as a share of the smallest body, may be in contact for an engine with a skin.
constexpr double starts_touching = 0.05;

void connect_touching(const Scene& scene, std::span<const BodyState> start, Rows& rows) {
  const Overlap overlap(scene);
  Overlap::Gaps gaps = overlap.gaps(start);
  const double near = starts_touching * smallest_body(scene);
  for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < scene.bodies.size(); ++b) {
      const bool may = (scene.bodies[a].layers & scene.bodies[b].layers) != 0 &&
                       (scene.bodies[a].type == BodyType::dynamic || scene.bodies[b].type == BodyType::dynamic);
      if (may && gaps.between(a, b) <= near) rows.connect(a, b);
    }
  }
}

struct BodyStress {
  double radius = 0;   // m
  double damping = 0;  // 1/s
  double smooth = 0, bends = 0, jolts = 0, pushed = 0, carried = 0, changes = 0;
  double strays = 0, begun = 0;                // begun: m/s^3, the rates at which accelerations began to change
  double jammed = 0, turned = 0, turning = 0;  // turning: m/s^2, the changes in jams, each times the rotation
  std::optional<bool> touched;                 // in the step before
  int alike = 0;                               // steps since that changed

  void add(const BodyState& before, const BodyState& after, bool touches, double load, double dt) {
    const Triple change{after.velocity.x - before.velocity.x, after.velocity.y - before.velocity.y,
                        radius * (after.angular_velocity - before.angular_velocity)};
    const double size = length_of(change);
    carried += changes * dt;
    changes += size + load;
    (touches ? pushed : smooth) += size;
    alike = touched == touches ? alike + 1 : 0;
    strays += begun * dt;
    const Triple now = scaled_by(1 / dt, change);
    const Triple rate_now = scaled_by(1 / dt, minus(now, acceleration));
    if (alike > 0) bends += change_to(now, smooth_acceleration);
    if (alike == 2) begun += length_of(rate_now);
    if (alike > 1) jolts += change_to(rate_now, smooth_rate);
    // What damps and what drives may balance, and each is still integrated with an error.
    const double path = dt * std::hypot(length(after.velocity), radius * after.angular_velocity);
    bends += damping * damping * path;
    jolts += damping * damping * damping * path;
    acceleration = now;
    touched = touches;
  }

  void add_jam(double change, double spin, double dt, bool first) {
    turned += turning * dt;
    turning += change * spin;
    if (!first) jammed += change;
  }

 private:
  using Triple = std::array<double, 3>;  // of both coordinates and the rim

  // The size of the change since the last one that no contact began or ended in.
  static double change_to(const Triple& now, std::optional<Triple>& last) {
    const double size = last ? length_of(minus(now, *last)) : 0;
    last = now;
    return size;
  }
  static double length_of(const Triple& a) { return std::hypot(a[0], a[1], a[2]); }
  static Triple scaled_by(double factor, const Triple& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }
  static Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

  Triple acceleration{};  // in the step before
  std::optional<Triple> smooth_acceleration, smooth_rate;
};

class Jams {
 public:
  Jams(const Scene& scene, const Trace& trace) : scene_(scene), trace_(trace) {
    for (const Body& body : scene.bodies) radii_.push_back(bounding_radius(body));
  }

  std::vector<double> at(std::size_t moment) const {
    std::vector<double> jams(radii_.size());
    if (moment == 0 || trace_.contacts(moment).empty()) return jams;
    const auto then = trace_.states(moment - 1);
    const auto now = trace_.states(moment);
    const double fall = length(scene_.gravity) * (trace_.time(moment) - trace_.time(moment - 1));
    std::vector<bool> struck(radii_.size());  // by group
    std::vector<bool> touches(radii_.size());
    Groups groups(radii_.size());
    for_all_pairs(moment, [&](std::size_t a, std::size_t b) {
      if (moves(a) && moves(b)) groups.join(a, b);
    });
    for (const ContactState& contact : trace_.contacts(moment)) {
      touches[contact.a] = touches[contact.b] = true;
      const bool approaches = -dot(contact.normal, velocity_before(scene_, contact, then, now)) > fall;
      if (approaches) struck[groups.of(moves(contact.a) ? contact.a : contact.b)] = true;
    }
    for (std::size_t i = 0; i < jams.size(); ++i) {
      if (!moves(i) || !touches[i] || struck[groups.of(i)]) continue;
      const double jump = change(moment, i) - std::max(change(moment - 1, i), change(moment + 1, i));
      if (jump > 2 * fall) jams[i] = jump;
    }
    return jams;
  }

 private:
  bool moves(std::size_t body) const { return scene_.bodies[body].type == BodyType::dynamic; }

  template <class Join>
  void for_all_pairs(std::size_t moment, Join join) const {
    for (const ContactState& contact : trace_.contacts(moment)) join(contact.a, contact.b);
    for (const Joint& joint : scene_.joints) std::visit([&](const auto& of) { join(of.a, of.b); }, joint);
  }

  // m/s, of a body's velocity and its rim's in the step to a moment; 0 if there is no such step.
  double change(std::size_t moment, std::size_t body) const {
    if (moment == 0 || moment >= trace_.size()) return 0;
    const BodyState& then = trace_.states(moment - 1)[body];
    const BodyState& now = trace_.states(moment)[body];
    return std::hypot(length(now.velocity - then.velocity),
                      radii_[body] * (now.angular_velocity - then.angular_velocity));
  }

  const Scene& scene_;
  const Trace& trace_;
  std::vector<double> radii_;  // m
};

}  // namespace

std::vector<Stress> stress_along(const Scene& scene, const Trace& trace) {
  const auto dynamic = [&](std::size_t i) { return scene.bodies[i].type == BodyType::dynamic; };
  std::vector<BodyStress> bodies(scene.bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].radius = bounding_radius(scene.bodies[i]);
    bodies[i].damping = std::max(scene.bodies[i].linear_damping, scene.bodies[i].angular_damping);
  }
  Stress stress;
  Rows rows(scene);
  for (const Joint& joint : scene.joints) {
    const auto [a, b] = std::visit([](const auto& one) { return std::pair(one.a, one.b); }, joint);
    rows.connect(a, b);
  }
  stress.joints = rows.longest();
  connect_touching(scene, trace.states(0), rows);
  const int connected = rows.longest();
  if (connected > stress.joints) stress.contacts = connected;
  std::vector<Stress> along{stress};
  const std::vector<std::vector<double>> jams = jams_in(scene, trace);
  std::vector<bool> touches(scene.bodies.size());
  bool touched = false;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    std::fill(touches.begin(), touches.end(), false);
    bool any = false;
    bool longer = false;
    for (const ContactState& contact : trace.contacts(moment)) {
      if (contact.normal_impulse <= 0) continue;
      any = true;
      touches[contact.a] = touches[contact.b] = true;
      longer = rows.connect(contact.a, contact.b) || longer;
    }
    if (longer || (any && stress.contacts == 0)) stress.contacts = rows.longest();
    if (touched) stress.touched += dt;
    touched = touched || any;
    const bool spreads = any && !scene.joints.empty();  // joints pass a push on within the step
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!dynamic(i)) continue;
      const double before = bodies[i].pushed;
      const double fall = length(scene.gravity) * dt;
      const bool held = touches[i] || !scene.joints.empty();
      bodies[i].add(trace.states(moment - 1)[i], trace.states(moment)[i], touches[i] || spreads, held ? fall : 0, dt);
      bodies[i].add_jam(jams[moment][i], std::abs(trace.states(moment)[i].angular_velocity), dt, moment == 1);
      const double hit = bodies[i].pushed - before;
      if (hit > 2 * fall && (stress.slowest == 0 || hit < stress.slowest)) stress.slowest = hit;
      stress.smooth = std::max(stress.smooth, bodies[i].smooth);
      stress.bends = std::max(stress.bends, bodies[i].bends);
      stress.jolts = std::max(stress.jolts, bodies[i].jolts);
      stress.strays = std::max(stress.strays, bodies[i].strays);
      stress.pushed = std::max(stress.pushed, bodies[i].pushed);
      stress.carried = std::max(stress.carried, bodies[i].carried);
      stress.jammed = std::max(stress.jammed, bodies[i].jammed);
      stress.turned = std::max(stress.turned, bodies[i].turned);
    }
    along.push_back(stress);
  }
  return along;
}

MethodError method_error(const Stepping& s, const Stress& stress, bool bounces) {
  const bool second = s.order >= 2 && s.drift == 0;
  const double smooth = second ? s.h * s.h * (stress.bends / 3 + stress.strays / 12)
                               : std::max(std::abs(s.drift), 0.5) * s.h * stress.smooth;
  const double found_late = std::max(lag(s), s.order_in_contact >= 2 ? 0 : s.h / 2);
  const double late = found_late * (stress.pushed - stress.jammed);
  const double jams = s.dt * (stress.jammed + stress.turned);
  const double gaps = s.contact_gap() * stress.contacts + s.joint_slop * stress.joints;
  const bool stops = bounces && stress.slowest > 0 && stress.slowest < 2 * s.restitution_threshold;
  const double stopped = stops ? s.restitution_threshold : 0;
  const double speed = (stress.contacts > 0 ? s.creep : 0) + stopped;
  const double left = unsolved(s, std::max({stress.contacts, stress.joints, 1})) * stress.carried;
  return {.place = smooth + late + jams + gaps + speed * stress.touched + left,
          .speed = (second ? s.h * s.h / 6 * stress.jolts : s.h / 2 * stress.bends) + stopped};
}

std::vector<std::vector<double>> jams_in(const Scene& scene, const Trace& trace) {
  const Jams jams(scene, trace);
  std::vector<std::vector<double>> all;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) all.push_back(jams.at(moment));
  return all;
}

}  // namespace plumb
