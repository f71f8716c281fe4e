// Faulty integrators of free motion.

#include <vector>

#include "reference/faults/engine/faulty.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// A right integrator, part of which a fault overrides.
class MutatedIntegrator : public Integrator {
 public:
  explicit MutatedIntegrator(std::string_view right) : right_(MethodList<Integrator>::make(right)) {}
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
  return {{.name = name, .about = about, .source = source, .mutates = right},
          [right] { return std::make_unique<Wrong>(right); }};
}

/// x += v dt before v += a dt.
class Explicit : public MutatedIntegrator {
 public:
  explicit Explicit(std::string_view right)
      : MutatedIntegrator(right), explicit_(MethodList<Integrator>::make("explicit-euler")) {}
  void begin(BodySet& bodies, const ForceField& forces, Real h) override { explicit_->begin(bodies, forces, h); }
  void finish(BodySet& bodies, const ForceField& forces, Real h) override { explicit_->finish(bodies, forces, h); }

 private:
  std::unique_ptr<Integrator> explicit_;
};
const auto explicit_euler =
    wrong<Explicit>("explicit-for-symplectic", "positions move before velocities", "the article, part 2");

/// force * (1/m + g): without a force there is no gravity either.
class PrintedAcceleration : public MutatedIntegrator {
 public:
  using MutatedIntegrator::MutatedIntegrator;
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
const auto printed_acceleration = wrong<PrintedAcceleration>(
    "force-times-gravity", "force * (1/m + g) instead of force/m + g", "the article, part 4");

/// Gravity with the mass not cancelled: F = m g taken for an acceleration.
class HeavyFalls : public MutatedIntegrator {
 public:
  using MutatedIntegrator::MutatedIntegrator;
  void begin(BodySet& bodies, const ForceField& forces, Real h) override {
    MutatedIntegrator::begin(bodies, forces, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Real m = bodies.inverse_mass[i].m;
      if (m > 0) bodies.velocity[i].v += h * (1 / m - 1) * forces.gravity;
    }
  }
};
const auto heavy_falls = wrong<HeavyFalls>("gravity-times-mass", "heavier bodies fall faster", "the article, part 4");

/// The rotation's columns swapped: it rotates the shape the wrong way.
class SwappedColumns : public MutatedIntegrator {
 public:
  using MutatedIntegrator::MutatedIntegrator;
  void finish(BodySet& bodies, const ForceField& forces, Real h) override {
    MutatedIntegrator::finish(bodies, forces, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.pose[i].q = Rotation(bodies.angle[i]).inverse();
  }
};
const auto swapped_columns = wrong<SwappedColumns>(
    "columns-swapped", "the matrix of the rotation has its columns swapped", "the article, part 4");

/// Positions advance by dt, angles by 1/60 s.
class FixedTurn : public MutatedIntegrator {
 public:
  using MutatedIntegrator::MutatedIntegrator;
  void finish(BodySet& bodies, const ForceField& forces, Real h) override {
    const std::vector<Velocity> right = bodies.velocity;
    for (Velocity& velocity : bodies.velocity) velocity.w *= 1 / (60 * h);
    MutatedIntegrator::finish(bodies, forces, h);
    bodies.velocity = right;
  }
};
const auto fixed_turn = wrong<FixedTurn>("dt-fixed-for-angle", "angles move for 1/60 s however long the step is");

/// The second half of the kick with the forces of the first.
class StaleKick : public MutatedIntegrator {
 public:
  using MutatedIntegrator::MutatedIntegrator;
  void begin(BodySet& bodies, const ForceField& forces, Real h) override {
    forces.accelerations(bodies, h / 2, stale_);
    MutatedIntegrator::begin(bodies, forces, h);
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
