#include "bodies/integrator.h"

#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// The default: v += a dt, then x += v dt with the new v. The position error is of first order, but the method
/// conserves a quantity close to the energy: on a spring of frequency w (rad/s) it is (v^2 + w^2 x^2 - w^2 dt v x)/2,
/// which bounds the motion while w dt < 2.
class SymplecticEuler : public Integrator {
 public:
  void begin(BodySet& bodies, const ForceField& forces, Real h) override {
    forces.accelerations(bodies, h, acceleration_);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      bodies.velocity[i].v += h * acceleration_[i].v;
      bodies.velocity[i].w += h * acceleration_[i].w;
    }
  }

  void finish(BodySet& bodies, const ForceField&, Real h) override {
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.advance(i, h);
  }

  // x = g (t^2 + t h)/2: every step moves with its final velocity.
  Real drift() const override { return static_cast<Real>(.5); }
  int order() const override { return 1; }

 private:
  std::vector<Velocity> acceleration_;
};

const MethodList<Integrator>::Entry symplectic_euler_entry{
    {"symplectic-euler", "first order, energy bounded up to w dt = 2",
     "article, part 2; Hairer, Lubich, Wanner 2006, I.1"},
    [] { return std::make_unique<SymplecticEuler>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
