#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "bodies/body_set.h"
#include "bodies/force_field.h"
#include "bodies/integrator.h"
#include "broad_phase/broad_phase.h"
#include "contacts/contact_set.h"
#include "contacts/touch_log.h"
#include "core/workers.h"
#include "impulse/world.h"
#include "islands/sleep.h"
#include "joints/joint_set.h"
#include "solver/resting_piles.h"
#include "solver/solver.h"
#include "world/continuous_collision.h"
#include "world/sensors.h"

namespace impulse::inline IMPULSE_PRECISION {

struct World::State {
  enum class Change : std::uint8_t { insert, remove, destroy };

  Settings settings;
  std::unique_ptr<Solver> solver;
  std::unique_ptr<Integrator> integrator;
  std::unique_ptr<BroadPhase> broad_phase;
  std::unique_ptr<Workers> workers;
  BodySet bodies;
  ContactSet contacts;
  TouchLog touches;
  Sensors sensors;
  ContinuousCollision continuous;
  ForceField forces;
  JointSet joints;
  PartFilter filter;
  PreSolve pre_solve;
  Sleep sleep{bodies, contacts, joints, forces, filter};
  std::vector<BodyId> listed_bodies;         // storage of World::bodies()
  std::vector<ContactInfo> listed_contacts;  // storage of World::contacts()
  std::vector<Contact> contacts_of_piles;
  std::vector<Contact> all_contacts;  // of bodies that are awake, if piles at rest keep some of them
  std::vector<const Contact*> sorted_contacts;
  bool stepping = false;
  int callbacks_running = 0;
  std::vector<std::pair<Change, BodyId>> deferred;

  explicit State(const Settings& chosen) { adopt(chosen); }
  State(const State& other);
  /// A copy with a solver of its own, which goes on with the same bits. Throws std::logic_error in a callback.
  std::unique_ptr<State> copy() const;

  /// Changes the settings, or throws and changes nothing.
  void adopt(const Settings& chosen);

  /// The row of a living body. Throws std::out_of_range.
  std::size_t row(BodyId id) const;

  void wake_ends(JointId id);
  /// Like Sleep::wake and Sleep::disturb; they invalidate resting piles too.
  void wake(std::size_t i);
  void disturb(std::size_t i);
  /// Invalidates all resting piles, or that of a body, and takes over their contacts.
  void let_go();
  void let_go(std::size_t i);

  void step();
  void find_contacts(const Margin& margin);
  /// The contacts of bodies that are awake after a step.
  std::span<const Contact> awake_contacts();

  /// Throws std::logic_error while the filter or the pre-solve callback may be running.
  void refuse_in_step() const;

  /// Makes the change now, or when the running callback has returned.
  void change(Change what, BodyId id);
  void apply(Change what, BodyId id);

  /// Changes are deferred while one of these exists.
  class CallbackScope {
   public:
    explicit CallbackScope(State& state) : state_(state) { ++state_.callbacks_running; }
    CallbackScope(const CallbackScope&) = delete;
    CallbackScope& operator=(const CallbackScope&) = delete;
    ~CallbackScope();

   private:
    State& state_;
  };
};

}  // namespace impulse::inline IMPULSE_PRECISION
