// Mistakes that our engine once made: impulses that act with the arms or along the normals of another moment.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "reference/faults/engine/mutated_solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// An impulse on b, and the opposite one on a, that turn them with these arms and move nothing.
void turn(BodySet& bodies, const Contact& contact, Vec2 arm_a, Vec2 arm_b, Vec2 impulse) {
  bodies.velocity[contact.body_a].w -= bodies.inverse_mass[contact.body_a].i * cross(arm_a, impulse);
  bodies.velocity[contact.body_b].w += bodies.inverse_mass[contact.body_b].i * cross(arm_b, impulse);
}

/// Contacts found again within the step know nothing of the gap at its start.
class OwnArms : public MutatedSolver {
 public:
  OwnArms() : MutatedSolver("accurate") {}

 private:
  void before(MutatedStep& step) override { start_ = step.contacts; }
  void after(MutatedStep& step) override {
    for (std::size_t c = 0; c < step.contacts.size(); ++c) {
      const Contact& contact = step.contacts[c];
      if (!contact.discs() || contact.restitution != 0) continue;
      const Vec2 half_gap = std::max(start_[c].found_separation[0], Real{0}) / 2 * contact.normal;
      turn(step.bodies, contact, half_gap, -half_gap,
           contact.points[0].total_tangent_impulse * perpendicular(contact.normal));
    }
  }

  std::vector<Contact> start_;
};
const Faulty<Solver> own_arms{
    {.name = "disc-own-arms",
     .about = "two discs that meet without bouncing are struck at the middle of the gap of the step's start: "
              "angular momentum is lost",
     .mutates = "accurate"},
    [] { return std::make_unique<OwnArms>(); }};

/// Knows the poses at the start of the step.
class WithStart : public MutatedSolver {
 public:
  using MutatedSolver::MutatedSolver;

 protected:
  void before(MutatedStep& step) override { start_ = step.bodies.pose; }
  const Pose& start(std::uint32_t body) const { return start_[body]; }

 private:
  std::vector<Pose> start_;
};

/// Of what two discs bear in a sub-step, the half given before they move acts along the normal of before. Turned with
/// the normal, it does work: F v^2 / 2R on a disc that slides over a dome.
class WholeTurns : public WithStart {
 public:
  WholeTurns() : WithStart("accurate") {}

 private:
  void after(MutatedStep& step) override {
    BodySet& bodies = step.bodies;
    for (const Contact& contact : step.contacts) {
      if (!contact.discs()) continue;
      const Vec2 then = normalized(start(contact.body_b).p - start(contact.body_a).p);
      const Vec2 now = normalized(bodies.pose[contact.body_b].p - bodies.pose[contact.body_a].p);
      const Vec2 change = (now - then) / static_cast<Real>(2 * step.settings.substeps);
      const ContactPoint& at = contact.points[0];
      const Vec2 more = at.total_normal_impulse * change + at.total_tangent_impulse * perpendicular(change);
      bodies.velocity[contact.body_a].v -= bodies.inverse_mass[contact.body_a].m * more;
      bodies.velocity[contact.body_b].v += bodies.inverse_mass[contact.body_b].m * more;
    }
  }
};
const Faulty<Solver> whole_turns{
    {.name = "disc-impulse-turns",
     .about = "all that two discs bear in a sub-step turns with their normal, which gains energy on a dome",
     .mutates = "accurate"},
    [] { return std::make_unique<WholeTurns>(); }};

/// The arms turn with the body until a corner strikes.
class HeldArms : public WithStart {
 public:
  HeldArms() : WithStart("accurate") {}

 private:
  void before(MutatedStep& step) override {
    WithStart::before(step);
    last_ = step.contacts;
  }
  void after(MutatedStep& step) override {
    for (std::size_t c = 0; c < step.contacts.size(); ++c) {
      const Contact& contact = step.contacts[c];
      if (contact.disc_a || contact.disc_b) continue;
      const Rotation turned_a = turned(step, contact.body_a);
      const Rotation turned_b = turned(step, contact.body_b);
      for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
        const ContactPoint& at = contact.points[p];
        if (bore(last_[c], at.feature)) continue;
        turn(step.bodies, contact, at.arm_a - turned_a * at.arm_a, at.arm_b - turned_b * at.arm_b,
             at.total_normal_impulse * contact.normal + at.total_tangent_impulse * perpendicular(contact.normal));
      }
    }
  }

  Rotation turned(const MutatedStep& step, std::uint32_t body) const {
    return step.bodies.pose[body].q * start(body).q.inverse();
  }
  static bool bore(const Contact& contact, std::uint32_t feature) {
    return std::any_of(contact.points.begin(), contact.points.begin() + contact.count,
                       [feature](const ContactPoint& one) { return one.feature == feature && one.normal_impulse > 0; });
  }

  std::vector<Contact> last_;
};
const Faulty<Solver> held_arms{
    {.name = "corner-arms-held",
     .about = "a corner strikes with the arm of the step's start: a rocking block keeps the wrong share of its spin",
     .mutates = "accurate"},
    [] { return std::make_unique<HeldArms>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
