#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "methods/article_formulas.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The method of the seed (R. Gaul, "How to create a custom 2D physics engine", parts 1, 3 and 4, and the demo engine
/// that comes with it): impulses point by point, not accumulated, then linear projection of the overlap.
///
/// With vn = (vB - vA).n at a point and k = 1/mA + 1/mB + (rA x n)^2/IA + (rB x n)^2/IB, where the print has lost the
/// minus sign and the (1 + e),
///
///     j = -(1 + e) vn / k,
///
/// divided by the number of the manifold's points, as in the demo engine: each would stop a flat landing alone. The
/// points share out the velocities that all of them find (the demo engine lets the second see what the first did, and
/// so a flat landing turns a box and its friction drives it sideways).
///
/// Iterated over two points the formula ends at vn = 0, whatever e, since every impulse sees only what the others left.
/// So the approach before any impulse, vn0, settles the speed of parting, and until a point has reached it
///
///     j = (e |vn0| - vn) / k:  a single point gets the printed impulse exactly, and at once.
///
/// Friction has no (1 + e): jt = -vt / kt, divided likewise. Amontons-Coulomb: it sticks while |jt| <= mu_static j,
/// else it slides with mu_dynamic j against the motion. In the plane the print's tangent, vr - (vr.n) n at unit length,
/// is perpendicular(n) up to its sign; taking that, nothing is divided by a tangential speed of zero.
template <class Formulas>
class Article : public Solver {
 public:
  void step(StepData& data) override {
    const Real dt = data.settings.dt;
    data.integrator.begin(data.bodies, data.forces, dt);
    prepare(data);
    for (ActiveJoint& joint : data.joints) forget_impulses(joint.block);
    for (int i = 0; i < data.settings.iterations; ++i) {
      for (ActiveJoint& joint : data.joints) solve_joint(joint.block, dt, joint_percent, data.bodies);
      solve(data);
    }
    data.integrator.finish(data.bodies, data.forces, dt);
    correct_positions(data);
  }

  void state(const Settings& settings, StatedErrors& errors) const override {
    errors.gap = slop;
    errors.joints = true;
    // Friction is held against each push of its own and not against their sum, so what gravity adds along a slope in a
    // step, |g| sin(slope) dt, is never taken out whole. Half of |g| dt is that on 30 degrees.
    errors.creep = length(settings.gravity) * settings.dt / 2;
    errors.restitution_threshold = resting_speed(settings);
  }

 private:
  static constexpr Real slop =
      static_cast<Real>(.005);  // m, overlap left alone, so that a resting contact is there in every step
  static constexpr Real joint_percent =
      static_cast<Real>(0.2);  // of a joint's error, taken away in a step (Baumgarte 1972)
  static constexpr Real percent =
      static_cast<Real>(.4);  // of the overlap beyond it, removed a step; all at once makes stacks jitter

  /// What a point needs besides its contact.
  struct Point {
    Real normal_mass = 0;   // kg
    Real tangent_mass = 0;  // kg
    Real rebound = 0;       // m/s, the speed of parting that the approach before any impulse asks for; 0 once reached
  };

  // The demo engine's rule: gravity alone presses resting bodies together at |g| dt in every step. That is no impact,
  // so e = 0 up to this speed; and a tenth beyond it, for what the iterations of the last step left.
  static Real resting_speed(const Settings& settings) {
    return static_cast<Real>(1.1) * length(settings.gravity) * settings.dt;
  }

  static Real normal_velocity(const Touching& pair, const Contact& contact, std::size_t p) {
    return dot(Formulas::relative_velocity(pair, contact.points[p]), contact.normal);
  }

  void prepare(const StepData& data) {
    resting_speed_ = resting_speed(data.settings);
    points_.resize(data.contacts.size());
    for (std::size_t c = 0; c < data.contacts.size(); ++c) {
      const Contact& contact = data.contacts[c];
      const Touching pair(data.bodies, contact);
      for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
        const ContactPoint& at = contact.points[p];
        Point& point = points_[c][p];
        point.normal_mass = Formulas::normal_mass(pair, at, contact.normal);
        point.tangent_mass = Formulas::tangent_mass(pair, at, contact.normal);
        point.rebound = Formulas::rebound(contact, normal_velocity(pair, contact, p), resting_speed_);
      }
    }
  }

  void solve(StepData& data) {
    for (std::size_t c = 0; c < data.contacts.size(); ++c) {
      Contact& contact = data.contacts[c];
      Touching pair(data.bodies, contact);
      const auto j = push_apart(pair, contact, points_[c]);
      rub(pair, contact, points_[c], j);
      data.bodies.velocity[contact.body_a] = pair.a;
      data.bodies.velocity[contact.body_b] = pair.b;
    }
  }

  /// The normal impulses of this iteration.
  std::array<Real, 2> push_apart(Touching& pair, Contact& contact, std::array<Point, 2>& points) const {
    std::array<Real, 2> j{};
    const auto count = static_cast<std::size_t>(contact.count);
    for (std::size_t p = 0; p < count; ++p) {
      const Real vn = normal_velocity(pair, contact, p);
      // What others set in motion, as in a row of touching balls, answers to how it approaches now.
      const Real target = std::max(points[p].rebound, Formulas::rebound(contact, vn, resting_speed_));
      if (vn >= target || count == 1) points[p].rebound = 0;
      if (vn < target) j[p] = Formulas::normal_impulse(target, vn, points[p].normal_mass, contact.count);
    }
    for (std::size_t p = 0; p < count; ++p) {
      Formulas::push(pair, contact.points[p], j[p] * contact.normal);
      contact.points[p].total_normal_impulse += j[p];
      contact.points[p].normal_impulse = contact.points[p].total_normal_impulse;
    }
    return j;
  }

  static void rub(Touching& pair, Contact& contact, const std::array<Point, 2>& points, const std::array<Real, 2>& j) {
    const Vec2 tangent = perpendicular(contact.normal);
    std::array<Real, 2> jt{};
    const auto count = static_cast<std::size_t>(contact.count);
    for (std::size_t p = 0; p < count; ++p) {
      const Real vt = Formulas::tangent_velocity(Formulas::relative_velocity(pair, contact.points[p]), contact);
      jt[p] = Formulas::friction(contact, Formulas::stopping_impulse(contact, vt, points[p].tangent_mass), j[p]);
    }
    for (std::size_t p = 0; p < count; ++p) {
      Formulas::push(pair, contact.points[p], jt[p] * tangent);
      contact.points[p].total_tangent_impulse += jt[p];
      contact.points[p].tangent_impulse = contact.points[p].total_tangent_impulse;
    }
  }

  static void correct_positions(StepData& data) {
    for (const Contact& contact : data.contacts) {
      Real overlap = 0;
      for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
        overlap = std::max(overlap, -contact.points[p].separation);
      }
      const Real ma = data.bodies.inverse_mass[contact.body_a].m;
      const Real mb = data.bodies.inverse_mass[contact.body_b].m;
      if (overlap <= slop || ma + mb == 0) continue;
      Formulas::part(data.bodies, contact, percent * (overlap - slop), data.settings.dt);
    }
  }

  std::vector<std::array<Point, 2>> points_;
  Real resting_speed_ = 0;
};

}  // namespace impulse::inline IMPULSE_PRECISION
