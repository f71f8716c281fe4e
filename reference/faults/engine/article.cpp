// Misprints in the formulas of the article's solver.

#include "reference/faults/engine/faulty.h"
#include "reference/faults/engine/misprinted_article.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

template <class Formulas>
Faulty<Solver> misprint(const char* name, const char* about, const char* source = "") {
  return {{.name = name, .about = about, .source = source, .mutates = "article"},
          [] { return std::make_unique<MisprintedArticle<Formulas>>(); }};
}

struct FrictionSign : PrintedFormulas {
  static Real stopping_impulse(const Contact& contact, Real vt, Real mass) {
    return -ArticleFormulas::stopping_impulse(contact, vt, mass);
  }
};
const auto friction_sign =
    misprint<FrictionSign>("friction-sign", "friction pushes with the motion", "the article, part 3");

struct BouncyFriction : PrintedFormulas {
  static Real stopping_impulse(const Contact& contact, Real vt, Real mass) {
    return (1 + contact.restitution) * ArticleFormulas::stopping_impulse(contact, vt, mass);
  }
};
const auto bouncy_friction =
    misprint<BouncyFriction>("friction-bounces", "(1 + e) in the friction impulse", "the article, part 3");

struct NoClamp : PrintedFormulas {
  static Real friction(const Contact&, Real jt, Real) { return jt; }
};
const auto no_clamp =
    misprint<NoClamp>("friction-no-clamp", "friction without the limit of Coulomb", "the article, part 3");

struct StaticWhileSliding : PrintedFormulas {
  static Real friction(const Contact& contact, Real jt, Real j) {
    return clamp(jt, -contact.static_friction * j, contact.static_friction * j);
  }
};
const auto static_sliding = misprint<StaticWhileSliding>("friction-static-sliding",
                                                         "the static coefficient while sliding", "the article, part 3");

struct NormalForTangent : PrintedFormulas {
  static Real tangent_velocity(Vec2 relative, const Contact& contact) { return dot(relative, contact.normal); }
};
const auto normal_for_tangent = misprint<NormalForTangent>(
    "friction-along-normal", "friction of the speed along the normal", "the article, part 3");

struct NoSign : PrintedFormulas {
  static Real normal_impulse(Real target, Real vn, Real mass, int points) {
    return (target + vn) * mass / static_cast<Real>(points);
  }
};
const auto no_sign =
    misprint<NoSign>("impulse-sign", "the minus sign of j = -(1 + e) vn / k lost", "the article, part 1");

struct NoRestitution : PrintedFormulas {
  static Real rebound(const Contact&, Real, Real) { return 0; }
};
const auto no_restitution =
    misprint<NoRestitution>("impulse-one-plus-e", "the (1 + e) of the impulse lost", "the article, part 1");

struct TorqueOfSpin : PrintedFormulas {
  static void push(Touching& pair, const ContactPoint& at, Vec2 impulse) {
    // r x w is a vector in the plane; code can only use its length.
    pair.a.w -= pair.inverse_a.i * length(cross(at.arm_a, pair.a.w));
    pair.b.w += pair.inverse_b.i * length(cross(at.arm_b, pair.b.w));
    pair.a.v -= pair.inverse_a.m * impulse;
    pair.b.v += pair.inverse_b.m * impulse;
  }
};
const auto torque_of_spin =
    misprint<TorqueOfSpin>("torque-of-spin", "torque as r x omega instead of r x F", "the article, part 4");

struct TorqueTurned : PrintedFormulas {
  static void push(Touching& pair, const ContactPoint& at, Vec2 impulse) {
    pair.a.v -= pair.inverse_a.m * impulse;
    pair.a.w -= pair.inverse_a.i * cross(impulse, at.arm_a);
    pair.b.v += pair.inverse_b.m * impulse;
    pair.b.w += pair.inverse_b.i * cross(impulse, at.arm_b);
  }
};
const auto torque_turned =
    misprint<TorqueTurned>("torque-sign", "torque as F x r instead of r x F", "the article, part 4");

struct PointMass : PrintedFormulas {
  static Real normal_mass(const Touching& pair, const ContactPoint&, Vec2) {
    const Real k = pair.inverse_a.m + pair.inverse_b.m;
    return k > 0 ? 1 / k : 0;
  }
};
const auto point_mass =
    misprint<PointMass>("mass-without-arms", "no (r x n)^2/I in the mass along the normal", "the article, part 1");

struct SharedMass : PrintedFormulas {
  static Real tangent_mass(const Touching& pair, const ContactPoint& at, Vec2 normal) {
    return normal_mass(pair, at, normal);
  }
};
const auto shared_mass =
    misprint<SharedMass>("mass-of-normal", "friction with the mass along the normal", "the article, part 3");

struct NoSpin : PrintedFormulas {
  static Vec2 relative_velocity(const Touching& pair, const ContactPoint&) { return pair.b.v - pair.a.v; }
};
const auto no_spin = misprint<NoSpin>("velocity-without-spin", "the speed of the centres for that of the points");

struct Unshared : PrintedFormulas {
  static Real normal_impulse(Real target, Real vn, Real mass, int) { return (target - vn) * mass; }
};
const auto unshared =
    misprint<Unshared>("impulse-unshared", "the impulse not divided by the number of the manifold's points");

struct DullBelowOne : PrintedFormulas {
  static Real rebound(const Contact& contact, Real vn, Real) { return -vn > 1 ? contact.restitution * -vn : 0; }
};
const auto dull_below_one = misprint<DullBelowOne>(
    "restitution-threshold", "nothing bounces below 1 m/s, where the method states the speed of one step of gravity");

struct EnergeticCorrection : PrintedFormulas {
  static void part(BodySet& bodies, const Contact& contact, Real depth, Real dt) {
    ArticleFormulas::part(bodies, contact, depth);
    const Real ma = bodies.inverse_mass[contact.body_a].m;
    const Real mb = bodies.inverse_mass[contact.body_b].m;
    const Vec2 kick = depth / (dt * (ma + mb)) * contact.normal;
    bodies.velocity[contact.body_a].v -= ma * kick;
    bodies.velocity[contact.body_b].v += mb * kick;
  }
};
const auto energetic_correction = misprint<EnergeticCorrection>(
    "correction-adds-energy", "position correction left in the velocities", "the article, part 1");

struct HeavyFarther : PrintedFormulas {
  static void part(BodySet& bodies, const Contact& contact, Real depth, Real) {
    const Real ma = bodies.inverse_mass[contact.body_a].m;
    const Real mb = bodies.inverse_mass[contact.body_b].m;
    const Vec2 correction = depth / (ma + mb) * contact.normal;
    bodies.pose[contact.body_a].p -= mb * correction;
    bodies.pose[contact.body_b].p += ma * correction;
  }
};
const auto heavy_farther = misprint<HeavyFarther>(
    "correction-moves-heavier", "position correction moves the heavier body farther", "the article, part 1");

struct NoCorrection : PrintedFormulas {
  static void part(BodySet&, const Contact&, Real, Real) {}
};
const auto no_correction =
    misprint<NoCorrection>("correction-missing", "no position correction", "the article, part 1");

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
