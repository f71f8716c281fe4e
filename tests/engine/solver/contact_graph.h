#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/method_list.h"
#include "solver/colouring.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Bodies, the first of which nothing moves, and contacts and springs between some of them.
class Graph {
 public:
  explicit Graph(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      BodyDef def;
      if (i == 0) def.type = BodyType::fixed;
      bodies_.insert(bodies_.add(def, std::array{Part{Shape::circle(1), {}}}).index);
    }
  }
  void touch(std::uint32_t a, std::uint32_t b, int points) {
    Contact contact;
    contact.body_a = a;
    contact.body_b = b;
    contact.count = points;
    contacts_.push_back(contact);
  }
  void tie(std::uint32_t a, std::uint32_t b) { forces_.add(Spring{.a = bodies_.id(a), .b = bodies_.id(b)}, bodies_); }
  ForceField& forces() { return forces_; }
  /// Of all contacts, as of one island.
  const Colouring& colour() {
    for (std::uint32_t body = 2; body < bodies_.size() && forces_.empty(); ++body) tie(body - 1, body);
    split();
    JointWorkspace work;
    colouring_.assign(parts_,
                      {.bodies = parts_.bodies(1),
                       .contacts = parts_.contacts(1),
                       .rows = {},
                       .joints = IslandJoints({}, parts_.bodies(1), bodies_, start_, motion_, work)},
                      8);
    return colouring_;
  }
  const Partition& split() {
    StepData data{bodies_, contacts_, joints_, forces_, *integrator_, settings_, workers_};
    data.contact_changes = changes_;
    parts_.split(data);
    return parts_;
  }
  /// From now on contacts have changed as often as that, see ContactSet::changes().
  void count_changes(std::uint64_t changes) { changes_ = changes; }
  void forget_points() { parts_.forget_points(); }
  BodySet& bodies() { return bodies_; }
  std::vector<Contact>& contacts() { return contacts_; }
  const std::vector<Contact>& contacts() const { return contacts_; }

 private:
  BodySet bodies_;
  std::vector<Contact> contacts_;
  std::vector<ActiveJoint> joints_;
  ForceField forces_;
  std::unique_ptr<Integrator> integrator_ = MethodList<Integrator>::make("symplectic-euler");
  Settings settings_;
  Workers workers_{1};
  std::uint64_t changes_ = 0;
  std::vector<Motion> motion_;
  std::vector<Pose> start_;
  Partition parts_;
  Colouring colouring_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
