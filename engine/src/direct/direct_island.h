#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "joints/joint_set.h"
#include "direct/constraint_system.h"
#include "solver/motion.h"
#include "solver/partition.h"
#include "solver/solver.h"
#include "direct/touch.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A contact of a small island within a step.
struct DirectContact {
  std::uint32_t contact = 0;  // index
  std::uint32_t a = 0, b = 0;
  InverseMass mass_a, mass_b;
  std::size_t count = 0;
  Real static_friction = 0, dynamic_friction = 0, restitution = 0;
  bool slips = false;     // slides, so that the dynamic coefficient counts
  bool may_join = false;  // with another contact of one body on the ground
  Touch touch;
  TouchFrame frame;                   // at the present poses
  std::array<Vec2, 2> impulse{};      // N s, of each point in this sub-step, along normal and tangent
  std::array<Vec2, 2> total{};        // in this step, blows included
  Vec2 acted;                         // N s, of both in the world's frame
  std::array<std::uint32_t, 2> row{}; // of each point in the system
  std::uint32_t friction_row = 0;

  Real friction() const { return slips ? dynamic_friction : static_friction; }
};

/// What islands share in a step.
struct DirectStep {
  StepData& data;
  const std::vector<Pose>& start;       // of each body
  std::vector<Motion>& motion;          // of each body since then
  std::vector<Velocity>& acceleration;  // of each body, by forces
  std::vector<Velocity>& flight;        // of each body, by forces and by what bore it in the last sub-step
  std::vector<Velocity>& later;         // storage, of each body
  std::vector<Velocity>& held;          // storage, of each body
};

/// Steps a small island: all its constraints are solved as one system.
class DirectIsland {
 public:
  struct Members {
    std::span<const std::uint32_t> bodies;
    std::span<const Tie> contacts;
    std::span<ActiveJoint* const> joints;
    std::span<const Pull> pulls;
    bool varies = false;
  };
  void step(DirectStep& step, const Members& members);
  /// Whether the number of points of a contact has changed since the last call.
  bool counts_changed() { return std::exchange(counts_changed_, false); }

 private:
  void begin();
  void substep();
  void end();
  void refresh();
  bool find(DirectContact& contact, const Motion& a, const Motion& b);
  void kick();
  void press();
  void drift();
  void relax();
  void note_loads(const std::vector<Velocity>& before);
  void note(DirectContact& contact, std::size_t point, Vec2 impulse, Vec2 normal);
  void list_contact(DirectContact& contact, const TouchFrame& frame, bool rubs);
  void list_joint(const JointBlock& block);
  void bias_press();
  Real residual_of_press() const;
  bool stick_or_slip();
  void read_impulses(bool pressing);
  JointBlock ahead(const ActiveJoint& joint, Real t) const;
  Motion motion_after(std::uint32_t body, Real t) const;

  // Blows.
  struct Candidate {
    std::uint32_t aims = 0;
  };
  struct Event {
    Real time = 0, speed = 0;
    std::uint32_t contact = 0, aims = 0;
  };
  static bool later_event(const Event& left, const Event& right);
  Motion flown_motion(std::uint32_t body, Real t) const;
  Velocity flown_velocity(std::uint32_t body, Real t) const;
  Real approach(const DirectContact& contact, const TouchFrame& frame, std::size_t point, Real t) const;
  void aim(std::uint32_t contact, Real now);
  void strike(std::uint32_t contact, Real tau);
  void solve_blow(std::vector<Velocity>& velocity);
  void resolve_blows();

  DirectStep* step_ = nullptr;
  Members members_;
  Real h_ = 0;
  int substeps_ = 1;
  Real slow_ = 0;  // m/s, approaches below are no blows
  std::vector<DirectContact> contacts_;
  ConstraintSystem system_;
  std::vector<std::uint32_t> joint_rows_;  // first of each joint in the system
  std::vector<Velocity> before_;
  bool counts_changed_ = false;
  std::vector<Candidate> candidates_;
  std::vector<Event> events_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
