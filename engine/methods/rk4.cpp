#include "bodies/integrator.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// The classical fourth-order Runge-Kutta method on poses and velocities of all bodies together. Stable on a spring up
/// to w h = 2 sqrt 2; not symplectic, energy fades slowly.
///
/// The stages are of free motion; contacts change the velocity only at the end of it: the poses move by the mean of the
/// stages' velocities plus what the contacts added. Where they do, the order is lost.
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
  /// Along a support. Its normal part n of gravity moves the pose by n h^2/2 less in a step than the contact gives
  /// back, n h^2: the body is lifted by n h^2/2 once, and from then on approaches with n h/2. That half a kick, which
  /// the contact has not given, is friction not given either: along the support the body is faster by mu n h/2, and
  /// that makes up for mu n h^2/2 of way that friction, acting on the pose for whole steps, takes too much in each.
  int order_in_contact() const override { return 2; }

 private:
  /// Adds the slopes at the present state by `weight`, then puts the bodies `next` seconds along them from the start.
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
