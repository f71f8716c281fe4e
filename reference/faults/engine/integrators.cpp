// Integrators of free motion with a mistake.

#include <vector>

#include "reference/faults/engine/faulty.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// A right one, with what is wrong in its place.
class SpoiltIntegrator : public Integrator {
 public:
  explicit SpoiltIntegrator(std::string_view right) : right_(MethodList<Integrator>::make(right)) {}
  void begin(BodySet& bodies, const ForceField& forces, Real h) override { right_->begin(bodies, forces, h); }
  void finish(BodySet& bodies, const ForceField& forces, Real h) override { right_->finish(bodies, forces, h); }
  Real drift() const final { return right_->drift(); }
  int order() const final { return right_->order(); }
  int order_in_contact() const final { return right_->order_in_contact(); }
  bool needs_held() const final { return right_->needs_held(); }

 private:
  std::unique_ptr<Integrator> right_;
};

template <class Wrong>
Faulty<Integrator> wrong(const char* name, const char* about, const char* source = "",
                         const char* right = "symplectic-euler") {
  return {{.name = name, .about = about, .source = source, .spoils = right},
          [right] { return std::make_unique<Wrong>(right); }};
}

/// x += v dt before v += a dt.
class Explicit : public SpoiltIntegrator {
 public:
  explicit Explicit(std::string_view right)
      : SpoiltIntegrator(right), explicit_(MethodList<Integrator>::make("explicit-euler")) {}
  void begin(BodySet& bodies, const ForceField& forces, Real h) override { explicit_->begin(bodies, forces, h); }
  void finish(BodySet& bodies, const ForceField& forces, Real h) override { explicit_->finish(bodies, forces, h); }

 private:
  std::unique_ptr<Integrator> explicit_;
};
const auto explicit_euler = wrong<Explicit>("explicit-for-symplectic", "positions move before velocities", "rows 1, 2");

/// force * (1/m + g): without a force there is no gravity either.
class PrintedAcceleration : public SpoiltIntegrator {
 public:
  using SpoiltIntegrator::SpoiltIntegrator;
  void begin(BodySet& bodies, const ForceField& forces, Real h) override {
    ForceField without = forces;
    without.gravity = {};
    without.accelerations(bodies, h, acceleration_);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Real m = bodies.inverse_mass[i].m;
      if (m == 0) continue;
      const Vec2 force = acceleration_[i].v / m;
      const Vec2 printed{force.x * (m + forces.gravity.x), force.y * (m + forces.gravity.y)};
      bodies.velocity[i].v += h * printed;
      bodies.velocity[i].w += h * acceleration_[i].w;
    }
  }

 private:
  std::vector<Velocity> acceleration_;
};
const auto printed_acceleration =
    wrong<PrintedAcceleration>("force-times-gravity", "force * (1/m + g) instead of force/m + g", "row 25");

/// g without its mass cancelled: F = m g taken for an acceleration.
class HeavyFalls : public SpoiltIntegrator {
 public:
  using SpoiltIntegrator::SpoiltIntegrator;
  void begin(BodySet& bodies, const ForceField& forces, Real h) override {
    SpoiltIntegrator::begin(bodies, forces, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Real m = bodies.inverse_mass[i].m;
      if (m > 0) bodies.velocity[i].v += h * (1 / m - 1) * forces.gravity;
    }
  }
};
const auto heavy_falls = wrong<HeavyFalls>("gravity-times-mass", "heavier bodies fall faster", "row 25");

/// The rotation's columns swapped: it turns the shape the wrong way.
class SwappedColumns : public SpoiltIntegrator {
 public:
  using SpoiltIntegrator::SpoiltIntegrator;
  void finish(BodySet& bodies, const ForceField& forces, Real h) override {
    SpoiltIntegrator::finish(bodies, forces, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.pose[i].q = Rotation(bodies.angle[i]).inverse();
  }
};
const auto swapped_columns =
    wrong<SwappedColumns>("columns-swapped", "the matrix of the rotation has its columns swapped", "row 26");

/// Velocities by dt, angles by 1/60 s.
class FixedTurn : public SpoiltIntegrator {
 public:
  using SpoiltIntegrator::SpoiltIntegrator;
  void finish(BodySet& bodies, const ForceField& forces, Real h) override {
    const std::vector<Velocity> right = bodies.velocity;
    for (Velocity& velocity : bodies.velocity) velocity.w *= 1 / (60 * h);
    SpoiltIntegrator::finish(bodies, forces, h);
    bodies.velocity = right;
  }
};
const auto fixed_turn = wrong<FixedTurn>("dt-fixed-for-angle", "angles move for 1/60 s however long the step is");

/// The second half of the kick with the forces of the first.
class StaleKick : public SpoiltIntegrator {
 public:
  using SpoiltIntegrator::SpoiltIntegrator;
  void begin(BodySet& bodies, const ForceField& forces, Real h) override {
    forces.accelerations(bodies, h / 2, stale_);
    SpoiltIntegrator::begin(bodies, forces, h);
  }
  void finish(BodySet& bodies, const ForceField&, Real h) override {
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.advance(i, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies.held[i] != 0) continue;
      bodies.velocity[i].v += h / 2 * stale_[i].v;
      bodies.velocity[i].w += h / 2 * stale_[i].w;
    }
  }

 private:
  std::vector<Velocity> stale_;
};
const auto stale_kick = wrong<StaleKick>(
    "verlet-stale-kick", "the second half of the kick with the forces of the first", "", "velocity-verlet");

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
