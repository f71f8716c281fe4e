#include "bodies/integrator.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// x += v dt with the old v, then v += a dt. Here to be seen failing: on a spring it multiplies the energy by
/// 1 + (w dt)^2 every step, whatever the step.
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

  // x = g (t^2 - t h)/2: every step moves with the velocity it began with.
  Real drift() const override { return -static_cast<Real>(.5); }
  int order() const override { return 1; }

 private:
  std::vector<Velocity> acceleration_;
};

const MethodList<Integrator>::Entry explicit_euler_entry{
    {"explicit-euler", "first order, gains energy at any step", "article, part 2; Hairer, Lubich, Wanner 2006, I.1"},
    [] { return std::make_unique<ExplicitEuler>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
