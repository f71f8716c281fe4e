#include "bodies/integrator.h"
#include "core/method_list.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Kick, drift, kick: v += a(x) h/2, x += v h, v += a(x') h/2. Second order, symplectic, stable on a spring up to
/// w h = 2, and exact where the acceleration is constant: x + h (v + a h/2) is the parabola itself.
///
/// A body that a contact or joint held in the last step does not fly: where it goes is what its support lets it, so it
/// takes the whole kick before the contacts are solved. (Half a kick after them would leave it pressed into its support
/// at the end of each step, with a velocity of g h/2.)
///
/// Damping stays of second order and stable: implicit in the first half, explicit in the second, together
/// v (1 - h d/2)/(1 + h d/2), the trapezoidal rule; a whole kick implicit over h/2 is the same.
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

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
