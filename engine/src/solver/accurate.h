#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "solver/before_step.h"
#include "solver/colouring.h"
#include "solver/direct_island.h"
#include "solver/energy_bound.h"
#include "solver/impacts.h"
#include "solver/island.h"
#include "solver/partition.h"
#include "solver/pile.h"
#include "solver/press_and_relax.h"
#include "solver/resting_piles.h"
#include "solver/scalar_contacts.h"
#include "solver/solver.h"
#include "solver/turning.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The working storage of one worker.
struct AccurateWorkspace {
  Impacts impacts;
  JointWorkspace joints;
  EnergyBound bound;
  Pile pile{solver_kernels()};
  Pile::RowOf row_of;
  Colouring colouring;
  std::vector<std::uint32_t> acting;  // see Island::acting
  Turning turning;
  Unpushed unpushed;
  LineSearch search;
  LocalSweeps local;
  DirectIsland direct;
  BeforeStep before;
};

/// The default method, which makes flight and impacts exact up to rounding. A step of dt is divided into N sub-steps of
/// h, each kick, press, drift, kick, relax:
///
///   impacts  of contacts with restitution, at their own times (impacts.h)
///   kick     integrate velocities: v += h/2 a, and half of the contact impulses of the last sub-step
///   press    solve with bias, contacts as soft constraints: velocities that correct positions too
///   drift    integrate positions: x += h v
///   kick     the other halves, with the forces at the new positions
///   relax    solve rigid contacts with friction: removes the velocity of the correction
///
/// Kick-drift-kick (velocity Verlet) is exact for a parabola and second order for any smooth force; applying contact
/// impulses half before and half after the drift, too, keeps a resting body where it is.
class Accurate : public Solver {
 public:
  explicit Accurate(bool lanes) : lanes_(lanes) {}
  void step(StepData& data) override;
  void state(const Settings& settings, StatedErrors& errors) const override {
    errors.h = settings.dt / static_cast<Real>(settings.substeps);
    errors.drift = 0;
    errors.order = 2;
    errors.order_in_contact = 2;
    errors.impact_lag = 0;
    errors.gap = tolerated_sink;  // until the offset has corrected it
    errors.joint_gap = tolerated_joint_gap;
    errors.creep = 0;
    errors.joints = true;
    errors.joint_omega = softness_of_swept(errors.h).omega;
    errors.restitution_threshold = slow_impact(length(settings.gravity), errors.h);
  }
  bool contact_persistence() const override { return true; }
  RestingPiles* resting() override { return lanes_ ? &resting_ : nullptr; }
  /// Everything that may be hit within the step, including the effect of gravity.
  Margin margin(const Settings& settings) const override {
    return {static_cast<Real>(0.02) + 2 * length(settings.gravity) * settings.dt * settings.dt, settings.dt};
  }

 private:
  void prepare(StepData& data);
  Island island(StepData& data, std::size_t number, AccurateWorkspace& space);
  void make_rows(StepData& data, Island& island, std::size_t number);
  void step_island(StepData& data, std::size_t number, AccurateWorkspace& space);
  void step_pile(StepData& data, std::size_t number, Island& pile, AccurateWorkspace& space);
  void step_in_lanes(StepData& data, std::size_t number, Island& pile, AccurateWorkspace& space);
  void step_swept(StepData& data, std::size_t number, Island& island, AccurateWorkspace& space);
  void begin_again(StepData& data, std::size_t number, const Island& island, AccurateWorkspace& space);
  void go_through(StepData& data, Island& island, AccurateWorkspace& space);
  void fly(StepData& data, const Island& island);
  void fly_all(StepData& data);
  void substep(StepData& data, Island& island, AccurateWorkspace& space);
  void find_impacts(StepData& data, Island& island, AccurateWorkspace& space);
  bool hold_those_that_meet(StepData& data, Island& island, AccurateWorkspace& space);
  /// m/s^2, the largest acceleration of a body by forces.
  Real pressing(const Island& island) const;
  void kick(BodySet& bodies, Island& island);
  void drift(StepData& data, const Island& island);
  void note_loads(const Island& island);
  /// Marks only bodies that can be pushed: the others are shared among islands.
  void note_load(const ImpactRow& row) {
    if (pushable(row.mass_a)) loaded_[row.a] = 1;
    if (pushable(row.mass_b)) loaded_[row.b] = 1;
  }
  void note_load(const JointBlock& block) {
    if (pushable(block.inv_mass_a)) loaded_[block.a] = 1;
    if (pushable(block.inv_mass_b)) loaded_[block.b] = 1;
  }

  bool lanes_;  // large islands are solved by kernels
  Partition parts_;
  RestingPiles resting_;
  std::vector<std::unique_ptr<RestingPile>> begun_;  // in this step, of each island
  std::uint64_t contact_changes_ = 0;                // when rows were made
  std::vector<ImpactRow> rows_;                      // island by island; those of persistent contacts are kept
  std::vector<Motion> motion_;                       // of each body since the start of the step
  std::vector<Pose> start_;                          // of each body
  std::vector<Velocity> acceleration_;               // of each body, by the force field
  std::vector<Velocity> flight_;                     // the same, but 0 for a body that rests on a contact
  std::vector<Velocity> kicks_;                      // of each body, see ScalarContacts::halve
  std::vector<Velocity> held_;                       // of each body, half a sub-step later but for forces
  std::vector<Velocity> later_;                      // of each body, half a sub-step later
  std::vector<Velocity> changes_;                    // of each body, see LineSearch
  std::vector<std::uint8_t> loaded_;                 // a contact pushed the body in the last sub-step
  std::vector<AccurateWorkspace> spaces_;            // of each worker
};

}  // namespace impulse::inline IMPULSE_PRECISION
