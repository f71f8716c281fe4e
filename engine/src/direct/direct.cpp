#include <memory>
#include <vector>

#include "core/method_list.h"
#include "direct/direct_island.h"
#include "solver/island.h"
#include "solver/partition.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

class Direct : public Solver {
 public:
  void step(StepData& data) override;
  void state(const Settings& settings, StatedErrors& errors) const override {
    errors.h = settings.dt / static_cast<Real>(settings.substeps);
    errors.drift = 0;
    errors.order = 2;
    errors.order_in_contact = 2;
    errors.impact_lag = 0;
    errors.gap = tolerated_sink;
    errors.joint_gap = tolerated_joint_gap;
    errors.creep = 0;
    errors.joints = true;
    errors.joint_omega = softness_of_swept(errors.h).omega;
    errors.restitution_threshold = slow_impact(length(settings.gravity), errors.h);
  }
  bool contact_persistence() const override { return true; }
  Margin margin(const Settings& settings) const override {
    return {static_cast<Real>(0.02) + 2 * length(settings.gravity) * settings.dt * settings.dt, settings.dt};
  }

 private:
  Partition parts_;
  std::vector<Motion> motion_;
  std::vector<Pose> start_;
  std::vector<Velocity> acceleration_, flight_, later_, held_;
  DirectIsland island_;
};

void Direct::step(StepData& data) {
  BodySet& bodies = data.bodies;
  start_ = bodies.pose;
  motion_.assign(bodies.size(), {});
  held_.resize(bodies.size());
  later_ = bodies.velocity;
  const Real half = data.settings.dt / static_cast<Real>(2 * data.settings.substeps);
  data.forces.accelerations(bodies, 0, acceleration_, half);
  flight_ = acceleration_;
  parts_.split(data);
  DirectStep step{data, start_, motion_, acceleration_, flight_, later_, held_};
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_.contacts(i).empty() && parts_.joints(i).empty() && !parts_.varies(i)) {
      for (const std::uint32_t body : parts_.bodies(i)) {
        const Real t = data.settings.dt;
        if (bodies.moves(body)) motion_[body].advance(flown(bodies.velocity[body], acceleration_[body], t), t);
      }
      continue;
    }
    island_.step(step, {parts_.bodies(i), parts_.contacts(i), parts_.joints(i), parts_.pulls(i), parts_.varies(i)});
  }
  parts_.forget_points();
  place(bodies, start_, motion_);
}

const MethodList<Solver>::Entry direct_entry{
    {"direct", "all constraints of an island as one system, blows at their own times", "RATTLE"},
    [] { return std::make_unique<Direct>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
