// Mass data that are a little off.

#include "reference/faults/engine/spoilt_solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Every body with an inertia of that many times the right one; put right before anybody else looks.
Faulty<Solver> with_inertia(const char* name, const char* about, const char* source, Real of_disc, Real of_others) {
  const auto scale = [=](BodySet& bodies, bool back) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const BodyDetail& body = bodies.detail[i];
      const bool disc = body.parts.size() == 1 && body.parts.front().shape.type() == ShapeType::circle;
      const Real by = disc ? of_disc : of_others;
      bodies.inverse_mass[i].i = bodies.inverse_mass[i].i * (back ? by : 1 / by);
    }
  };
  return spoilt(
      {.name = name, .about = about, .source = source, .spoils = "accurate"},
      [=](SpoiltStep& step) { scale(step.bodies, false); }, [=](SpoiltStep& step) { scale(step.bodies, true); });
}

const auto two_percent = with_inertia("inertia-2-percent", "moments of inertia 2 % too large", "",
                                      static_cast<Real>(1.02), static_cast<Real>(1.02));
const auto five_percent = with_inertia("inertia-5-percent", "moments of inertia 5 % too large", "",
                                       static_cast<Real>(1.05), static_cast<Real>(1.05));
const auto hoop = with_inertia("inertia-of-hoop", "m r^2 for a disc, where it is m r^2/2", "row 10", 2, 1);

constexpr Real centre_off = static_cast<Real>(0.01);  // m

const auto centre =
    spoilt({.name = "centre-of-mass", .about = "the centre of mass 1 cm off, along the body's x", .spoils = "accurate"},
           [](SpoiltStep& step) {
             for (Contact& contact : step.contacts) {
               const Vec2 a = step.bodies.pose[contact.body_a].q * Vec2{centre_off, 0};
               const Vec2 b = step.bodies.pose[contact.body_b].q * Vec2{centre_off, 0};
               for (ContactPoint& point : contact.points) {
                 point.arm_a -= a;
                 point.arm_b -= b;
               }
             }
           });

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
