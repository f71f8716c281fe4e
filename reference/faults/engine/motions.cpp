// Motion that is disturbed between steps, or stepped with the wrong numbers.

#include <cmath>
#include <vector>

#include "reference/faults/engine/spoilt_solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

bool movable(const BodySet& bodies, std::size_t i) { return bodies.inverse_mass[i].m > 0; }

/// All speeds times 1 + rate t after t seconds, whatever the step.
Faulty<Solver> growing(const char* name, const char* about, Real rate) {
  return spoilt({.name = name, .about = about, .spoils = "accurate"}, nullptr, [rate](SpoiltStep& step) {
    for (std::size_t i = 0; i < step.bodies.size(); ++i) {
      if (!movable(step.bodies, i)) continue;
      const Real by = 1 + rate * step.settings.dt;
      step.bodies.velocity[i].v *= by;
      step.bodies.velocity[i].w *= by;
    }
  });
}

// Energy goes with the square of the speeds.
const auto leak = growing("energy-leak", "1 % of the kinetic energy is lost in a second", -static_cast<Real>(0.005));
const auto gain = growing("energy-gain", "0.1 % of the kinetic energy is won in a second", static_cast<Real>(0.0005));

const auto strong_gravity =
    spoilt({.name = "gravity-0.1-percent", .about = "gravity 0.1 % too strong", .spoils = "accurate"},
           [](SpoiltStep& step) { step.forces.gravity *= static_cast<Real>(1.001); });

const auto angle_in_float = spoilt(
    {.name = "angle-in-float", .about = "the angle kept in single precision, all else in double", .spoils = "accurate"},
    nullptr, [](SpoiltStep& step) {
      for (Real& angle : step.bodies.angle) {
        angle = static_cast<Real>(static_cast<float>(angle));
      }
    });

const auto wrapped_angle = spoilt({.name = "angle-wrapped",
                                   .about = "the angle starts again at -pi, so whole turns are forgotten",
                                   .spoils = "accurate"},
                                  nullptr, [](SpoiltStep& step) {
                                    for (Real& angle : step.bodies.angle) {
                                      if (angle > pi) angle -= 2 * pi;
                                      if (angle < -pi) angle += 2 * pi;
                                    }
                                  });

constexpr Real usual_step = 1 / Real{60};  // s

const auto fixed_dt =
    spoilt({.name = "dt-not-passed", .about = "forces act for 1/60 s however long the step is", .spoils = "article"},
           [](SpoiltStep& step) { step.forces.gravity *= usual_step / step.settings.dt; });

/// What happens in one step of many.
class NowAndThen : public SpoiltSolver {
 public:
  using SpoiltSolver::SpoiltSolver;

 protected:
  static constexpr int every = 32;  // steps
  bool now() const { return steps_ % every == every / 2; }
  void after(SpoiltStep&) override { ++steps_; }

 private:
  int steps_ = 0;
};

class GravityTwice : public NowAndThen {
 public:
  GravityTwice() : NowAndThen("accurate") {}

 private:
  void before(SpoiltStep& step) override {
    if (now()) step.forces.gravity *= 2;
  }
};
const Faulty<Solver> gravity_twice{
    {.name = "gravity-twice", .about = "gravity acts twice in one of 32 steps", .spoils = "accurate"},
    [] { return std::make_unique<GravityTwice>(); }};

/// The last body stands still for a step.
class SkippedBody : public NowAndThen {
 public:
  SkippedBody() : NowAndThen("accurate") {}

 private:
  void before(SpoiltStep& step) override {
    if (step.bodies.size() == 0) return;
    pose_ = step.bodies.pose.back();
    angle_ = step.bodies.angle.back();
  }
  void after(SpoiltStep& step) override {
    if (now() && step.bodies.size() > 0) {
      step.bodies.pose.back() = pose_;
      step.bodies.angle.back() = angle_;
    }
    NowAndThen::after(step);
  }
  Pose pose_;
  Real angle_ = 0;
};
const Faulty<Solver> skipped_body{
    {.name = "body-skipped", .about = "the last body is not moved in one of 32 steps", .spoils = "accurate"},
    [] { return std::make_unique<SkippedBody>(); }};

/// Sleep that counts steps where it should count seconds: what is slow for one step stays where it is.
class EarlySleep : public SpoiltSolver {
 public:
  EarlySleep() : SpoiltSolver("accurate") {}

 private:
  void before(SpoiltStep& step) override {
    pose_ = step.bodies.pose;
    angle_ = step.bodies.angle;
  }
  void after(SpoiltStep& step) override {
    for (std::size_t i = 0; i < step.bodies.size(); ++i) {
      Velocity& velocity = step.bodies.velocity[i];
      if (!movable(step.bodies, i) || length(velocity.v) > step.settings.sleep_linear_speed ||
          std::abs(velocity.w) > step.settings.sleep_angular_speed) {
        continue;
      }
      velocity = {};
      step.bodies.pose[i] = pose_[i];
      step.bodies.angle[i] = angle_[i];
    }
  }
  std::vector<Pose> pose_;
  std::vector<Real> angle_;
};
const Faulty<Solver> early_sleep{
    {.name = "sleep-too-early", .about = "what is slow for one step is put to rest", .spoils = "accurate"},
    [] { return std::make_unique<EarlySleep>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
