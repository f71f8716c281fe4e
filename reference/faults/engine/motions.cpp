// Faults in masses and motions: wrong mass data, motion disturbed between steps, or steps with wrong parameters.

#include <cmath>
#include <vector>

#include "reference/faults/engine/mutated_solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Multiplies every inertia by a factor.
void scale_inertia(BodySet& bodies, Real of_disc, Real of_others) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyDetail& body = bodies.detail[i];
    const bool disc = body.parts.size() == 1 && body.parts.front().shape.type() == ShapeType::circle;
    bodies.inverse_mass[i].i /= disc ? of_disc : of_others;
  }
}

/// The same during the solver's step only.
StatelessMutation::Change larger_inertia(Real of_disc, Real of_others) {
  return [=](MutatedStep& step) { scale_inertia(step.bodies, of_disc, of_others); };
}

Faulty<Solver> with_inertia(const char* name, const char* about, const char* source, Real of_disc, Real of_others) {
  return mutated({.name = name, .about = about, .source = source, .mutates = "accurate"},
                 larger_inertia(of_disc, of_others), larger_inertia(1 / of_disc, 1 / of_others));
}

const Faulty<Solver> any_inertia{"scaled-inertia", [](double factor) {
                                   const Real by = static_cast<Real>(factor);
                                   return std::make_unique<StatelessMutation>("accurate", larger_inertia(by, by),
                                                                              larger_inertia(1 / by, 1 / by));
                                 }};

const auto two_percent = with_inertia("inertia-2-percent", "moments of inertia 2 % too large", "",
                                      static_cast<Real>(1.02), static_cast<Real>(1.02));
const auto five_percent = with_inertia("inertia-5-percent", "moments of inertia 5 % too large", "",
                                       static_cast<Real>(1.05), static_cast<Real>(1.05));
const auto hoop =
    with_inertia("inertia-of-hoop", "m r^2 for a disc, where it is m r^2/2", "the article's demo engine", 2, 1);

constexpr Real centre_off = static_cast<Real>(0.01);  // m

const auto centre = mutated(
    {.name = "centre-of-mass", .about = "the centre of mass 1 cm off, along the body's x", .mutates = "accurate"},
    [](MutatedStep& step) {
      for (Contact& contact : step.contacts) {
        const Vec2 a = step.bodies.pose[contact.body_a].q * Vec2{centre_off, 0};
        const Vec2 b = step.bodies.pose[contact.body_b].q * Vec2{centre_off, 0};
        for (ContactPoint& point : contact.points) {
          point.arm_a -= a;
          point.arm_b -= b;
        }
      }
    });

bool movable(const BodySet& bodies, std::size_t i) { return bodies.inverse_mass[i].m > 0; }

/// Multiplies all speeds by 1 + rate t after t seconds, whatever the step.
Faulty<Solver> growing(const char* name, const char* about, Real rate) {
  return mutated({.name = name, .about = about, .mutates = "accurate"}, nullptr, [rate](MutatedStep& step) {
    for (std::size_t i = 0; i < step.bodies.size(); ++i) {
      if (!movable(step.bodies, i)) continue;
      const Real by = 1 + rate * step.settings.dt;
      step.bodies.velocity[i].v *= by;
      step.bodies.velocity[i].w *= by;
    }
  });
}

// Energy is proportional to the square of the speeds.
const auto leak = growing("energy-leak", "1 % of the kinetic energy is lost in a second", -static_cast<Real>(0.005));
const auto gain = growing("energy-gain", "0.1 % of the kinetic energy is won in a second", static_cast<Real>(0.0005));

const auto strong_gravity =
    mutated({.name = "gravity-0.1-percent", .about = "gravity 0.1 % too strong", .mutates = "accurate"},
            [](MutatedStep& step) { step.forces.gravity *= static_cast<Real>(1.001); });

const auto angle_in_float = mutated({.name = "angle-in-float",
                                     .about = "the angle kept in single precision, all else in double",
                                     .mutates = "accurate"},
                                    nullptr, [](MutatedStep& step) {
                                      for (Real& angle : step.bodies.angle) {
                                        angle = static_cast<Real>(static_cast<float>(angle));
                                      }
                                    });

const auto wrapped_angle = mutated({.name = "angle-wrapped",
                                    .about = "the angle starts again at -pi, so whole turns are forgotten",
                                    .mutates = "accurate"},
                                   nullptr, [](MutatedStep& step) {
                                     for (Real& angle : step.bodies.angle) {
                                       if (angle > pi) angle -= 2 * pi;
                                       if (angle < -pi) angle += 2 * pi;
                                     }
                                   });

constexpr Real usual_step = 1 / Real{60};  // s

const auto fixed_dt =
    mutated({.name = "dt-not-passed", .about = "forces act for 1/60 s however long the step is", .mutates = "article"},
            [](MutatedStep& step) { step.forces.gravity *= usual_step / step.settings.dt; });

/// A fault that occurs in one of 32 steps.
class NowAndThen : public MutatedSolver {
 public:
  using MutatedSolver::MutatedSolver;

 protected:
  static constexpr int every = 32;  // steps
  bool now() const { return steps_ % every == every / 2; }
  void after(MutatedStep&) override { ++steps_; }

 private:
  int steps_ = 0;
};

class GravityTwice : public NowAndThen {
 public:
  GravityTwice() : NowAndThen("accurate") {}

 private:
  void before(MutatedStep& step) override {
    if (now()) step.forces.gravity *= 2;
  }
};
const Faulty<Solver> gravity_twice{
    {.name = "gravity-twice", .about = "gravity acts twice in one of 32 steps", .mutates = "accurate"},
    [] { return std::make_unique<GravityTwice>(); }};

/// The last body does not move for a step.
class SkippedBody : public NowAndThen {
 public:
  SkippedBody() : NowAndThen("accurate") {}

 private:
  void before(MutatedStep& step) override {
    if (step.bodies.size() == 0) return;
    pose_ = step.bodies.pose.back();
    angle_ = step.bodies.angle.back();
  }
  void after(MutatedStep& step) override {
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
    {.name = "body-skipped", .about = "the last body is not moved in one of 32 steps", .mutates = "accurate"},
    [] { return std::make_unique<SkippedBody>(); }};

/// Sleep that counts steps instead of seconds: a body that is slow for one step stays where it is.
class EarlySleep : public MutatedSolver {
 public:
  EarlySleep() : MutatedSolver("accurate") {}

 private:
  void before(MutatedStep& step) override {
    pose_ = step.bodies.pose;
    angle_ = step.bodies.angle;
  }
  void after(MutatedStep& step) override {
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
    {.name = "sleep-too-early", .about = "what is slow for one step is put to rest", .mutates = "accurate"},
    [] { return std::make_unique<EarlySleep>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
