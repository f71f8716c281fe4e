#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "method_list.h"
#include "solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real slop =
    static_cast<Real>(.005);  // m, overlap left alone, so that a resting contact is there in every step
constexpr Real joint_percent = static_cast<Real>(0.2);  // of a joint's error, taken away in a step (Baumgarte 1972)
constexpr Real percent =
    static_cast<Real>(.4);  // of the overlap beyond it, removed a step; all at once makes stacks jitter

/// What a point needs besides its contact.
struct Point {
  Real normal_mass = 0;   // kg, 1 / (1/mA + 1/mB + (rA x n)^2/IA + (rB x n)^2/IB)
  Real tangent_mass = 0;  // kg, the same along the tangent
  Real rebound = 0;       // m/s, the speed of parting that the approach before any impulse asks for; 0 once reached
};

/// Two bodies that touch, for as long as their contact is worked on.
struct Touching {
  Velocity a, b;
  InverseMass inverse_a, inverse_b;

  Touching(const BodySet& bodies, const Contact& contact)
      : a(bodies.velocity[contact.body_a]),
        b(bodies.velocity[contact.body_b]),
        inverse_a(bodies.inverse_mass[contact.body_a]),
        inverse_b(bodies.inverse_mass[contact.body_b]) {}

  Vec2 relative_velocity(const ContactPoint& at) const {
    return b.v + cross(b.w, at.arm_b) - a.v - cross(a.w, at.arm_a);
  }

  /// The mass that an impulse along `direction` feels.
  Real mass(const ContactPoint& at, Vec2 direction) const {
    const Real ra = cross(at.arm_a, direction);
    const Real rb = cross(at.arm_b, direction);
    const Real k = inverse_a.m + inverse_b.m + inverse_a.i * ra * ra + inverse_b.i * rb * rb;
    return k > 0 ? 1 / k : 0;
  }

  void push(const ContactPoint& at, Vec2 impulse) {
    a.v -= inverse_a.m * impulse;
    a.w -= inverse_a.i * cross(at.arm_a, impulse);
    b.v += inverse_b.m * impulse;
    b.w += inverse_b.i * cross(at.arm_b, impulse);
  }
};

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
  // The demo engine's rule: gravity alone presses resting bodies together at |g| dt in every step. That is no impact,
  // so e = 0 up to this speed; and a tenth beyond it, for what the iterations of the last step left.
  static Real resting_speed(const Settings& settings) {
    return static_cast<Real>(1.1) * length(settings.gravity) * settings.dt;
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
        point.normal_mass = pair.mass(at, contact.normal);
        point.tangent_mass = pair.mass(at, perpendicular(contact.normal));
        point.rebound = rebound(contact, dot(pair.relative_velocity(at), contact.normal));
      }
    }
  }

  Real rebound(const Contact& contact, Real vn) const { return -vn > resting_speed_ ? contact.restitution * -vn : 0; }

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
      const Real vn = dot(pair.relative_velocity(contact.points[p]), contact.normal);
      // What others set in motion, as in a row of touching balls, answers to how it approaches now.
      const Real target = std::max(points[p].rebound, rebound(contact, vn));
      if (vn >= target || count == 1) points[p].rebound = 0;
      if (vn < target) j[p] = (target - vn) * points[p].normal_mass / static_cast<Real>(count);
    }
    for (std::size_t p = 0; p < count; ++p) {
      pair.push(contact.points[p], j[p] * contact.normal);
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
      const Real vt = dot(pair.relative_velocity(contact.points[p]), tangent);
      jt[p] = -vt * points[p].tangent_mass / static_cast<Real>(count);
      if (std::abs(jt[p]) > contact.static_friction * j[p])
        jt[p] = std::copysign(contact.dynamic_friction * j[p], jt[p]);
    }
    for (std::size_t p = 0; p < count; ++p) {
      pair.push(contact.points[p], jt[p] * tangent);
      contact.points[p].total_tangent_impulse += jt[p];
      contact.points[p].tangent_impulse = contact.points[p].total_tangent_impulse;
    }
  }

  /// Part 1: moves overlapping bodies apart along the normal, the lighter one farther.
  static void correct_positions(StepData& data) {
    for (const Contact& contact : data.contacts) {
      Real overlap = 0;
      for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
        overlap = std::max(overlap, -contact.points[p].separation);
      }
      const Real ma = data.bodies.inverse_mass[contact.body_a].m;
      const Real mb = data.bodies.inverse_mass[contact.body_b].m;
      if (overlap <= slop || ma + mb == 0) continue;
      const Vec2 correction = percent * (overlap - slop) / (ma + mb) * contact.normal;
      data.bodies.pose[contact.body_a].p -= ma * correction;
      data.bodies.pose[contact.body_b].p += mb * correction;
    }
  }

  std::vector<std::array<Point, 2>> points_;
  Real resting_speed_ = 0;
};

const MethodList<Solver>::Entry entry{
    {"article", "impulses without accumulation, then linear position correction",
     "R. Gaul, How to create a custom 2D physics engine (the seed), with its demo engine"},
    [] { return std::make_unique<Article>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
