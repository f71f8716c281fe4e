#include "reports/judge/method_error.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

#include "reports/judge/overlap.h"
#include "reports/vec.h"
#include "scenarios/allowance.h"
#include "scenarios/scene/joints.h"

namespace plumb {
namespace {

// Which dynamic bodies contacts and joints have connected.
class Groups {
 public:
  explicit Groups(std::size_t bodies) : parent_(bodies), size_(bodies, 1) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void connect(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parent_[b] = a;
    size_[a] += size_[b];
  }
  int size(std::size_t i) { return size_[root(i)]; }

 private:
  std::vector<std::size_t> parent_;
  std::vector<int> size_;
};

struct BodyStress {
  double radius = 0;
  double smooth = 0, bends = 0, pushed = 0, carried = 0, changes = 0;
  Vec acceleration;
  double angular_acceleration = 0;
  std::optional<bool> touched;  // in the step before

  void add(const BodyState& before, const BodyState& after, bool touches, double dt) {
    const Vec change = after.velocity - before.velocity;
    const double turning = radius * (after.angular_velocity - before.angular_velocity);
    const double size = std::hypot(length(change), turning);
    carried += changes * dt;
    changes += size;
    (touches ? pushed : smooth) += size;
    const Vec now = (1 / dt) * change;
    if (touched == touches) bends += std::hypot(length(now - acceleration), turning / dt - angular_acceleration);
    acceleration = now;
    angular_acceleration = turning / dt;
    touched = touches;
  }
};

}  // namespace

std::vector<Stress> stress_along(const Scene& scene, const Trace& trace) {
  const auto dynamic = [&](std::size_t i) { return scene.bodies[i].type == BodyType::dynamic; };
  std::vector<BodyStress> bodies(scene.bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].radius = bounding_radius(scene.bodies[i]);
  Groups groups(scene.bodies.size());
  Stress stress;
  for (const Joint& joint : scene.joints) {
    const auto [a, b] = std::visit([](const auto& one) { return std::pair(one.a, one.b); }, joint);
    if (dynamic(a) && dynamic(b)) groups.connect(a, b);
    stress.joints = std::max({stress.joints, groups.size(a), groups.size(b)});
  }
  std::vector<Stress> along{stress};
  std::vector<bool> touches(scene.bodies.size());
  bool touched = false;
  for (std::size_t moment = 1; moment < trace.size(); ++moment) {
    const double dt = trace.time(moment) - trace.time(moment - 1);
    std::fill(touches.begin(), touches.end(), false);
    bool any = false;
    for (const ContactState& contact : trace.contacts(moment)) {
      if (contact.normal_impulse <= 0) continue;
      any = true;
      touches[contact.a] = touches[contact.b] = true;
      if (dynamic(contact.a) && dynamic(contact.b)) groups.connect(contact.a, contact.b);
      for (const std::size_t one : {contact.a, contact.b}) {
        if (dynamic(one)) stress.contacts = std::max(stress.contacts, groups.size(one));
      }
    }
    stress.time = trace.time(moment);
    if (touched) stress.touched += dt;
    touched = touched || any;
    const bool spreads = any && !scene.joints.empty();  // joints pass a push on within the step
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!dynamic(i)) continue;
      const double before = bodies[i].pushed;
      bodies[i].add(trace.states(moment - 1)[i], trace.states(moment)[i], touches[i] || spreads, dt);
      const double hit = bodies[i].pushed - before;
      const double fall = length(scene.gravity) * dt;
      if (hit > 2 * fall && (stress.slowest == 0 || hit < stress.slowest)) stress.slowest = hit;
      stress.smooth = std::max(stress.smooth, bodies[i].smooth);
      stress.bends = std::max(stress.bends, bodies[i].bends);
      stress.pushed = std::max(stress.pushed, bodies[i].pushed);
      stress.carried = std::max(stress.carried, bodies[i].carried);
    }
    along.push_back(stress);
  }
  return along;
}

double method_error(const Stepping& s, const Stress& stress, bool bounces) {
  const bool second = s.order >= 2 && s.drift == 0;
  const double smooth = second ? s.h * s.h / 3 * stress.bends : std::max(std::abs(s.drift), 0.5) * s.h * stress.smooth;
  const double late = std::max(lag(s), s.order_in_contact >= 2 ? 0 : s.h / 2) * stress.pushed;
  const double gaps = s.contact_gap() * stress.contacts + s.joint_slop * stress.joints;
  const bool stopped = bounces && stress.slowest > 0 && stress.slowest < 2 * s.restitution_threshold;
  const double speed = (stress.contacts > 0 ? s.creep : 0) + (stopped ? s.restitution_threshold : 0);
  const double left = unsolved(s, std::max({stress.contacts, stress.joints, 1})) * stress.carried;
  return smooth + late + gaps + speed * stress.touched + left;
}

}  // namespace plumb
