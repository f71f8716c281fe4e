#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "core/method_list.h"
#include "methods/article_formulas.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// The article's method (R. Gaul, "How to Create a Custom 2D Physics Engine", parts 1, 3 and 4, with its demo engine):
/// impulses point by point, not accumulated, then linear projection of the overlap.
///
/// With vn = (vB - vA).n at a point and k = 1/mA + 1/mB + (rA x n)^2/IA + (rB x n)^2/IB, where the print lacks the
/// minus sign and the (1 + e),
///
///     j = -(1 + e) vn / k,
///
/// divided by the number of the manifold's points, as in the demo engine: each point alone would stop a flat landing.
/// All points compute their impulses from the same velocities. (In the demo engine the second point sees what the first
/// did, so that a flat landing turns a box and its friction drives it sideways.)
///
/// Iterated over two points, the formula converges to vn = 0 whatever e, since every impulse sees only what the others
/// left. So the approach before any impulse, vn0, determines the rebound speed, and until a point has reached it
///
///     j = (e |vn0| - vn) / k:  a single point gets the printed impulse exactly, and at once.
///
/// Friction has no (1 + e): jt = -vt / kt, divided likewise. Amontons-Coulomb: it sticks while |jt| <= mu_static j,
/// otherwise it slides with mu_dynamic j against the motion. In the plane the print's tangent, vr - (vr.n) n
/// normalised, is perpendicular(n) up to its sign; with that, nothing is divided by a tangential speed of zero.
class Article : public Solver, private ArticleFormulas {
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

  void state(const Settings& settings, StatedErrors& errors) const override { state_errors(settings, errors); }

 private:
  /// What a point needs in addition to its contact.
  struct Point {
    Real normal_mass = 0;   // kg
    Real tangent_mass = 0;  // kg
    Real rebound = 0;       // m/s, the rebound speed for the approach before any impulse; 0 once reached
  };

  static Real normal_velocity(const Touching& pair, const Contact& contact, std::size_t p) {
    return dot(relative_velocity(pair, contact.points[p]), contact.normal);
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
        point.normal_mass = normal_mass(pair, at, contact.normal);
        point.tangent_mass = tangent_mass(pair, at, contact.normal);
        point.rebound = rebound(contact, normal_velocity(pair, contact, p), resting_speed_);
      }
    }
  }

  void solve(StepData& data) {
    for (std::size_t c = 0; c < data.contacts.size(); ++c) {
      Contact& contact = data.contacts[c];
      Touching pair(data.bodies, contact);
      const auto j = push_apart(pair, contact, points_[c]);
      apply_friction(pair, contact, points_[c], j);
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
      // Bodies set in motion by others, as in a row of touching balls, rebound by how they approach now.
      const Real target = std::max(points[p].rebound, rebound(contact, vn, resting_speed_));
      if (vn >= target || count == 1) points[p].rebound = 0;
      if (vn < target) j[p] = normal_impulse(target, vn, points[p].normal_mass, contact.count);
    }
    for (std::size_t p = 0; p < count; ++p) {
      push(pair, contact.points[p], j[p] * contact.normal);
      contact.points[p].total_normal_impulse += j[p];
      contact.points[p].normal_impulse = contact.points[p].total_normal_impulse;
    }
    return j;
  }

  static void apply_friction(Touching& pair, Contact& contact, const std::array<Point, 2>& points,
                             const std::array<Real, 2>& j) {
    const Vec2 tangent = perpendicular(contact.normal);
    std::array<Real, 2> jt{};
    const auto count = static_cast<std::size_t>(contact.count);
    for (std::size_t p = 0; p < count; ++p) {
      const Real vt = tangent_velocity(relative_velocity(pair, contact.points[p]), contact);
      jt[p] = friction(contact, stopping_impulse(contact, vt, points[p].tangent_mass), j[p]);
    }
    for (std::size_t p = 0; p < count; ++p) {
      push(pair, contact.points[p], jt[p] * tangent);
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
      part(data.bodies, contact, percent * (overlap - slop));
    }
  }

  std::vector<std::array<Point, 2>> points_;
  Real resting_speed_ = 0;
};

const MethodList<Solver>::Entry article_entry{
    {"article", "impulses without accumulation, then linear position correction",
     "R. Gaul, How to Create a Custom 2D Physics Engine, parts 1, 3 and 4, with its demo engine"},
    [] { return std::make_unique<Article>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
