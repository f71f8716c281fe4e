// Integrators for solvers that leave the choice; the default, symplectic Euler, is in bodies/.

#include <memory>
#include <vector>

#include "bodies/integrator.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// x += v dt with the old v, then v += a dt. Included because it fails: on a spring it multiplies the energy by
/// 1 + (w dt)^2 in every step, whatever the step.
class ExplicitEuler : public Integrator {
 public:
  void begin(BodySet& bodies, const ForceField& forces, Real) override {
    forces.accelerations(bodies, 0, acceleration_);
  }

  void finish(BodySet& bodies, const ForceField&, Real h) override {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      bodies.advance(i, h);
      bodies.velocity[i].v += h * acceleration_[i].v;
      bodies.velocity[i].w += h * acceleration_[i].w;
    }
  }

  // x = g (t^2 - t h)/2: every step moves with its initial velocity.
  Real drift() const override { return -static_cast<Real>(.5); }
  int order() const override { return 1; }

 private:
  std::vector<Velocity> acceleration_;
};

const MethodList<Integrator>::Entry explicit_euler_entry{
    {"explicit-euler", "first order, gains energy at any step", "article, part 2; Hairer, Lubich, Wanner 2006, I.1"},
    [] { return std::make_unique<ExplicitEuler>(); }};

/// Kick, drift, kick: v += a(x) h/2, x += v h, v += a(x') h/2. Second order, symplectic, stable on a spring up to
/// w h = 2, and exact where the acceleration is constant: x + h (v + a h/2) is the parabola itself.
///
/// A body that a contact or joint held in the last step does not fly: its support determines its motion, so it gets the
/// whole kick before the contacts are solved. (Half a kick after them would leave it moving into its support at the end
/// of each step, at g h/2.)
///
/// Damping is of second order and stable: implicit in the first half, explicit in the second, together
/// v (1 - h d/2)/(1 + h d/2), the trapezoidal rule; a whole kick, implicit over h/2, is the same.
class VelocityVerlet : public Integrator {
 public:
  void begin(BodySet& bodies, const ForceField& forces, Real h) override {
    forces.accelerations(bodies, h / 2, acceleration_);
    for (std::size_t i = 0; i < bodies.size(); ++i) kick(bodies, i, bodies.held[i] != 0 ? h : h / 2);
  }

  void finish(BodySet& bodies, const ForceField& forces, Real h) override {
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.advance(i, h);
    forces.accelerations(bodies, 0, acceleration_);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies.held[i] == 0) kick(bodies, i, h / 2);
    }
  }

  bool needs_held() const override { return true; }
  Real drift() const override { return 0; }
  int order() const override { return 2; }

 private:
  void kick(BodySet& bodies, std::size_t i, Real h) const {
    bodies.velocity[i].v += h * acceleration_[i].v;
    bodies.velocity[i].w += h * acceleration_[i].w;
  }

  std::vector<Velocity> acceleration_;
};

const MethodList<Integrator>::Entry velocity_verlet_entry{
    {"velocity-verlet", "second order, symplectic, exact for ballistic flight",
     "Swope et al. 1982; Hairer, Lubich, Wanner 2003, Geometric numerical integration by the Stormer-Verlet method"},
    [] { return std::make_unique<VelocityVerlet>(); }};

/// The classical fourth-order Runge-Kutta method on poses and velocities of all bodies together. Stable on a spring up
/// to w h = 2 sqrt 2; not symplectic, energy fades slowly.
///
/// The stages are free motion; contacts change the velocity only after them: the poses move by the mean of the stages'
/// velocities plus the change by the contacts. With contacts the order is lower.
class RungeKutta4 : public Integrator {
 public:
  void begin(BodySet& bodies, const ForceField& forces, Real h) override {
    pose_ = bodies.pose;
    angle_ = bodies.angle;
    velocity_ = bodies.velocity;
    mean_velocity_.assign(bodies.size(), {});
    mean_acceleration_.assign(bodies.size(), {});

    // y_k+1 = y + c_k h f(y_k), and the step is the mean of f by the weights.
    constexpr Real sixth = 1 / Real{6};
    constexpr Real third = 1 / Real{3};
    stage(bodies, forces, sixth, h / 2);
    stage(bodies, forces, third, h / 2);
    stage(bodies, forces, third, h);
    stage(bodies, forces, sixth, 0);

    bodies.pose = pose_;
    bodies.angle = angle_;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      free_velocity_of(bodies, i, mean_acceleration_[i], h);
      velocity_[i] = bodies.velocity[i];
    }
  }

  void finish(BodySet& bodies, const ForceField&, Real h) override {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Velocity& mean = mean_velocity_[i];
      const Velocity& solved = bodies.velocity[i];
      const Velocity& free = velocity_[i];
      bodies.advance(i, {mean.v + (solved.v - free.v), mean.w + (solved.w - free.w)}, h);
    }
  }

  Real drift() const override { return 0; }
  int order() const override { return 4; }
  /// Along a support. The normal part n of gravity moves the pose by n h^2/2 in a step, but the contact moves it back
  /// by n h^2: the body is lifted by n h^2/2 once, and from then on approaches at n h/2. The contact lacks that half of
  /// a kick, and so does friction: along the support the body is faster by mu n h/2, which compensates for the mu n
  /// h^2/2 of displacement that friction, acting on the pose for whole steps, removes too much in each.
  int order_in_contact() const override { return 2; }

 private:
  /// Adds the slopes at the current state times `weight`, then moves the bodies along them by `next` seconds from the
  /// start.
  void stage(BodySet& bodies, const ForceField& forces, Real weight, Real next) {
    forces.accelerations(bodies, 0, acceleration_);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Velocity slope = bodies.velocity[i];
      mean_velocity_[i].v += weight * slope.v;
      mean_velocity_[i].w += weight * slope.w;
      mean_acceleration_[i].v += weight * acceleration_[i].v;
      mean_acceleration_[i].w += weight * acceleration_[i].w;
      bodies.pose[i] = pose_[i];
      bodies.angle[i] = angle_[i];
      bodies.advance(i, slope, next);
      free_velocity_of(bodies, i, acceleration_[i], next);
    }
  }

  void free_velocity_of(BodySet& bodies, std::size_t i, const Velocity& acceleration, Real h) const {
    bodies.velocity[i].v = velocity_[i].v + h * acceleration.v;
    bodies.velocity[i].w = velocity_[i].w + h * acceleration.w;
  }

  std::vector<Pose> pose_;          // at the start
  std::vector<Real> angle_;         // at the start
  std::vector<Velocity> velocity_;  // at the start; after begin, at the end of free motion
  std::vector<Velocity> acceleration_;
  std::vector<Velocity> mean_velocity_;
  std::vector<Velocity> mean_acceleration_;
};

const MethodList<Integrator>::Entry rk4_entry{
    {"rk4", "fourth order in smooth motion, stable up to w dt = 2.83", "Kutta 1901; named in the article, part 2"},
    [] { return std::make_unique<RungeKutta4>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
