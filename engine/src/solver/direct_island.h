#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact_effect.h"
#include "joints/joint_set.h"
#include "narrow_phase/collide.h"
#include "solver/constraint_system.h"
#include "solver/energy_bound.h"
#include "solver/motion.h"
#include "solver/partition.h"
#include "solver/solver.h"
#include "solver/touch.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A contact of a small island within a step.
struct DirectContact {
  std::uint32_t contact = 0;  // index
  std::uint32_t a = 0, b = 0;
  InverseMass mass_a, mass_b;
  std::size_t count = 0;  // of its points; none while its bodies are far apart
  Real static_friction = 0, dynamic_friction = 0, restitution = 0;
  bool slips = false;           // slides, so that the dynamic coefficient counts
  bool struck = false;          // in the present impact
  Real lets_go = 0;             // the share of what was pressed in this interval that should not have been
  int approached = 0;           // intervals of this sub-step that should have ended with its impact, since the last one
  std::array<bool, 2> waits{};  // of each point: for an impact at the end of the interval
  bool found_again = false;     // within the step
  bool lasts = false;           // is not sought again within the step
  Touch touch;
  TouchFrame frame;                // at the present poses
  TouchFrame pressed_in;           // in which `pressing` acted
  ContactEffect pressed_by;        // what that did, wherever its points were
  std::array<Vec2, 2> impulse{};   // N s, of each point, along normal and tangent, in the last full interval
  std::array<Vec2, 2> pressed{};   // of these, before the drift
  std::array<Vec2, 2> pressing{};  // the same in this interval
  std::array<Real, 2> sliding{};   // m/s, of each point along the tangent, before the interval
  std::array<Vec2, 2> total{};     // in this step, blows included
  ContactEffect effect;            // of all points in this step
  std::uint32_t row = 0;           // of the first point in the system
  std::uint32_t friction_row = 0;  // or no_row

  static constexpr std::uint32_t no_row = ~std::uint32_t{0};
  Real friction() const { return slips ? dynamic_friction : static_friction; }
  /// A share of what was pressed in this interval is no longer counted. Returns what takes it back.
  ContactEffect forget_press(Real share);
};

/// What islands share in a step.
struct DirectStep {
  StepData& data;
  const std::vector<Pose>& start;       // of each body
  std::vector<Motion>& motion;          // of each body since then
  std::vector<Velocity>& acceleration;  // of each body, by forces
  std::vector<Velocity>& flight;        // of each body, by forces and by what bore it lately
  std::vector<Velocity>& later;         // storage, of each body
  std::vector<Velocity>& held;          // storage, of each body
};

/// Steps a small island: all its constraints are solved as one system, and its impacts come at their own times. See
/// engine/accurate.md.
class DirectIsland {
 public:
  struct Members {
    std::span<const std::uint32_t> bodies;
    std::span<const Tie> contacts;
    std::span<ActiveJoint* const> joints;
    std::span<const Pull> pulls;
    bool varies = false;  // whether forces do within the step
  };
  void step(DirectStep& step, const Members& members);
  /// Whether the number of points of a contact has changed since the last call.
  bool counts_changed() { return std::exchange(counts_changed_, false); }

 private:
  /// In an interval: more is far from linear. rad, of bodies and normals; of a body's reach, of the arms of its
  /// contacts.
  static constexpr Real far_turn = static_cast<Real>(0.25);
  static constexpr Real far_swing = static_cast<Real>(0.5);  // the same of the phase of what swings under its load
  /// m, by which an overlap is pushed apart in a sub-step. Bodies that start in each other part without being shot out.
  static constexpr Real most_push = static_cast<Real>(0.001);
  static constexpr Real sought_within = static_cast<Real>(0.05);  // m, gap up to which points are sought

  static constexpr int most_approaches = 4;  // what is still ahead after so many is braked by others, and borne like
                                             // what rests

  struct Impact {
    Real time = 0;   // s from now
    Real speed = 0;  // m/s, closing; rad/s of a hinge's stop
    std::uint32_t contact = DirectContact::no_row;
    std::uint32_t stop = DirectContact::no_row;  // instead of a contact: 2 j or 2 j + 1 of the joint j
  };

  void begin();
  void begin_contacts();
  void substep();
  /// Whether an interval is so short that what rounding or a blow changes in it is no load.
  bool is_brief(Real h) const { return h < h_ / 64; }
  Real longest(Real most) const;
  Real turns(const DirectContact& contact, Real within) const;
  Real fastest() const;
  Real swings(Real h) const;
  Real advance(Real h, const Impact& then);
  std::optional<std::uint32_t> stopped_unforeseen() const;
  Real apart_for(const Impact& then, Real h) const;
  void end();

  // Several sub-steps in one.
  int glide(int most);
  bool seems_to_stay(Real h);
  bool stays(Real h) const;
  bool same_arm(Real change, const InverseMass& mass, std::uint32_t body) const;
  bool looks_the_same(const DirectContact& contact, const TouchFrame& then) const;
  bool is_found_there(const DirectContact& contact, const TouchFrame& frame, const Motion& a, const Motion& b) const;

  // Contacts and joints at present.
  void refresh();
  void find(DirectContact& contact);
  bool slides_far(const DirectContact& contact, const Motion& a, const Motion& b) const;
  bool may_lie_down(const DirectContact& contact, const Motion& a, const Motion& b) const;
  Manifold collide_at(const DirectContact& contact, const Motion& a, const Motion& b, Real margin) const;
  JointBlock ahead(const ActiveJoint& joint, Real t) const;
  JointBlock placed(const ActiveJoint& joint, const Motion& a, const Motion& b) const;
  Motion motion_after(std::uint32_t body, Real t) const;

  // Impulses.
  void kick(Real h);
  bool press(Real h);
  void press_as_linear(Real h);
  void bias_as_linear(Real h);
  void list_for_press(Real h);
  Real most_kinetic(Real before, Real h) const;
  bool overlaps() const;
  bool joints_are_apart() const;
  bool is_driven() const;
  bool list_touched(Real h);
  void note_press();
  void take_back();
  void drift(Real h);
  void relax(Real h);
  void list_contact(DirectContact& contact);
  void list_joint(const JointBlock& block);
  Constraint& stop_row(std::uint32_t stop);
  static void leave_out(Constraint& row);
  Real place_of(std::uint32_t a, std::uint32_t b) const;
  void bias_press(Real h);
  Real least_gap(Real now, Real h) const;
  /// m or rad, by which the error of a joint may be rounded.
  Real rounding_of(const JointRow& row) const { return row.axis == Vec2{} ? turns_round_by_ : rounding_; }
  Real least_error(const JointRow& row, Real h) const;
  Real missed(Real h) const;
  bool stick_or_slip();
  Vec2 solved(const DirectContact& contact, std::size_t point) const;
  void note(DirectContact& contact, const std::array<Vec2, 2>& before) const;
  bool let_go();
  void push(const DirectContact& contact, const ContactEffect& by);
  void note_velocities(std::vector<Velocity>& to) const;
  void let_wait(DirectContact& contact, bool struck) const;
  bool strikes(const DirectContact& contact, Real speed) const;
  Real gained_by(const DirectContact& contact) const;
  bool is_borne(std::uint32_t body) const;
  void restore_velocities();
  void note_loads(Real h);

  // Impacts.
  Real motors_reach(Real within);
  std::vector<Real> motors_lack(Real time, const std::vector<Real>& works);
  std::optional<Impact> next_impact(Real within) const;
  std::optional<Impact> impact_of(std::uint32_t contact, Real within) const;
  std::optional<Impact> impact_of_stop(std::uint32_t stop, Real within) const;
  int& approaches(const Impact& impact);
  Real closing(const DirectContact& contact, const TouchFrame& frame, std::size_t point, Real t) const;
  Motion flown_motion(std::uint32_t body, Real t) const;
  Velocity flown_velocity(std::uint32_t body, Real t) const;
  void strike(const Impact& impact);
  void list_struck(DirectContact& contact, bool first);
  void solve_impact(const DirectContact* alone);
  void solve_pushes_first();
  void find_forces_again();

  DirectStep* step_ = nullptr;
  Members members_;
  int substeps_ = 1;
  Real h_ = 0;               // s, of a sub-step
  Real solvable_ = 0;        // s, the longest interval for which impulses were found in this step
  Real last_ = 0;            // s, of the interval that impulses are of
  bool met_jam_ = false;     // in this step
  Real gained_ = 0;          // m/s, by which a body falls faster in a sub-step
  Real rounding_ = 0;        // m, of gaps, by how far away the bodies are
  Real touching_ = 0;        // m, gap up to which points touch: touching_gap, or rounding_ if that is more
  Real turns_round_by_ = 0;  // rad, of the errors of joints, by how far bodies have turned
  Real extent_ = 0;          // m, of the island: of the places of its bodies
  bool tall_ = false;        // the island is taller than wide
  std::vector<std::pair<double, std::uint32_t>> by_response_;  // 1/kg and index of each contact
  std::vector<DirectContact> contacts_;
  ConstraintSystem system_;
  EnergyBound bound_;                                   // where impulses were not found
  std::vector<std::uint32_t> touched_;                  // whom that bounds
  std::vector<std::uint32_t> joint_rows_;               // first of each joint in the system
  std::vector<Velocity> before_;                        // of the island's bodies
  std::vector<Velocity> kicked_;                        // the same after the first kick
  std::vector<Velocity> by_forces_;                     // what forces changed in the interval, of the island's bodies
  std::vector<int> approached_stops_;                   // as DirectContact::approached, two for each joint
  std::uint32_t waiting_stop_ = DirectContact::no_row;  // for its impact at the end of the interval
  std::vector<Real> pressing_joints_;                   // N s or N m s, of the rows of joints before the drift
  bool counts_changed_ = false;
};

}  // namespace impulse::inline IMPULSE_PRECISION
