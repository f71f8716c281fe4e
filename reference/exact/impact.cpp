#include "reference/exact/impact.h"

#include <algorithm>
#include <cmath>

#include "reference/exact/closed_form.h"
#include "scenarios/scene/mass.h"

namespace plumb {

// An impulse P at the arm r changes the point's velocity by
//   du_n = K_nn P_n + K_nt P_t,   K_nn = 1/m + (r x n)^2/I,   K_nt = (r x n)(r x t)/I,
//   du_t = K_nt P_n + K_tt P_t,   K_tt = 1/m + (r x t)^2/I.
// While the point slips in one direction, s = sign(u_t), P_t = -s mu P_n throughout. Both speeds are then linear in
// P_n, and every law of restitution ends at u_n' = -e u_n: P_n = -(1 + e) u_n/(K_nn - s mu K_nt). If K_nt = 0 the two
// directions are independent, and slip that stops stays stopped: P_t = -u_t/K_tt. Sources: Brach, Mechanical Impact
// Dynamics (1991); Stronge, Impact Mechanics (2000), ch. 3.
std::optional<Vec> impact_impulse(const PointImpact& impact) {
  const Vec n = impact.normal;
  const Vec t{n.y, -n.x};
  const Vec u = impact.velocity + impact.spin * perpendicular(impact.arm);
  const double un = dot(u, n);
  const double ut = dot(u, t);
  if (un >= 0) return std::nullopt;
  const double lever_n = cross(impact.arm, n);
  const double lever_t = cross(impact.arm, t);
  const double knn = 1 / impact.mass + lever_n * lever_n / impact.inertia;
  const double ktt = 1 / impact.mass + lever_t * lever_t / impact.inertia;
  const double knt = lever_n * lever_t / impact.inertia;
  const double bounce = -(1 + impact.restitution) * un;
  const double mu = impact.friction;
  if (mu == 0) return bounce / knn * n;
  constexpr double coupled = 1e-12;  // K_nt below this fraction of K_nn is round-off of the arm
  if (std::abs(knt) <= coupled * knn) {
    const double pn = bounce / knn;
    return pn * n + std::clamp(-ut / ktt, -mu * pn, mu * pn) * t;
  }
  const double s = ut > 0 ? 1 : -1;
  const double stiff = knn - s * mu * knt;
  if (ut == 0 || stiff <= 0) return std::nullopt;
  const double pn = bounce / stiff;
  if (s * (ut + (knt - s * mu * ktt) * pn) < 0) return std::nullopt;
  return pn * n - s * mu * pn * t;
}

std::variant<FirstImpact, std::string> FirstImpact::solve(const Setup& given) {
  FirstImpact motion;
  motion.before_ = given.start;
  motion.gravity_ = given.gravity;
  for (const Corner& corner : given.corners) {
    if (clearance(corner, given.start, given.floor) < -geometry_tolerance)
      return "handles only a body that starts above the floor";
  }
  const std::optional<FloorContact> contact =
      first_contact(given.start, given.gravity, given.corners, given.floor, given.horizon + longest_step);
  if (!contact) return motion;
  if (contact->time > given.horizon) {
    motion.until_ = contact->time;  // in the last step of a run, which may go on past the horizon
    return motion;
  }

  const BodyState landed = free_flight(given.start, given.gravity, contact->time);
  for (std::size_t i = 0; i < given.corners.size(); ++i) {
    if (i != contact->corner && clearance(given.corners[i], landed, given.floor) < geometry_tolerance) {
      return "handles only impacts of one corner at a time";
    }
  }
  const Corner& corner = given.corners[contact->corner];
  const Vec arm = rotated(corner.offset, landed.angle) - corner.radius * given.floor.normal;
  const std::optional<Vec> push = impact_impulse({.mass = given.mass,
                                                  .inertia = given.inertia,
                                                  .normal = given.floor.normal,
                                                  .arm = arm,
                                                  .velocity = landed.velocity,
                                                  .spin = landed.angular_velocity,
                                                  .friction = given.friction,
                                                  .restitution = given.restitution});
  if (!push)
    return "handles only an impact whose slip keeps its direction, since otherwise the classical laws disagree";

  motion.impact_ = contact->time;
  motion.after_ = landed;
  motion.after_.velocity = landed.velocity + (1 / given.mass) * *push;
  motion.after_.angular_velocity += cross(arm, *push) / given.inertia;
  const double left = given.horizon + longest_step - contact->time;
  if (const auto second = first_contact(motion.after_, given.gravity, given.corners, given.floor, left)) {
    motion.until_ = contact->time + second->time;
  }
  return motion;
}

BodyState FirstImpact::at(double t) const {
  return t < impact_ ? free_flight(before_, gravity_, t) : free_flight(after_, gravity_, t - impact_);
}

namespace {

struct ImpactingBody {
  std::vector<BodyState> start;
  std::size_t body = 0;
  FirstImpact motion;

  void at(double t, std::span<BodyState> out) const {
    write_states(start, out);
    out[body] = motion.at(t);
  }
  double valid_until() const { return motion.valid_until(); }
};

Recognised<ImpactingBody> recognise_first_impact(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  const std::optional<BodyOnGround> pair = single_body_on_ground(scene);
  if (!pair) return "handles only one body over fixed ground";
  const Body& ground = scene.bodies[pair->ground];
  const Body& body = scene.bodies[pair->body];
  const Vec gravity = gravity_of(scene, body);
  const std::optional<Floor> floor = floor_of(ground, gravity);
  if (!floor || std::isfinite(floor->to)) return "handles only ground that is one half-space";
  const Mass mass = mass_of(body);
  if (body.shapes.size() != 1 || mass.mass <= 0 || mass.inertia <= 0)
    return "handles only a single shape that can rotate";
  const Coefficients mixed = mixed_coefficients(scene, ground, body);
  if (mixed.static_friction != mixed.dynamic_friction) return "supports only one coefficient of friction";
  auto motion = FirstImpact::solve({.start = start_of(body),
                                    .mass = mass.mass,
                                    .inertia = mass.inertia,
                                    .gravity = gravity,
                                    .corners = corners_of(body),
                                    .floor = *floor,
                                    .friction = mixed.dynamic_friction,
                                    .restitution = mixed.restitution,
                                    .horizon = scene.duration});
  if (const std::string* reason = std::get_if<std::string>(&motion)) return *reason;
  return ImpactingBody{start_of(scene), pair->body, std::get<FirstImpact>(motion)};
}

const Catalog<Engine>::Entry first_impact_entry{closed_form<ImpactingBody>(
    {.name = "first-impact",
     .about = "A body that flies, hits a plane with one corner, and flies on to its second contact",
     .source = "Newton's restitution with Coulomb's friction where all classical laws agree; Brach, Mechanical Impact "
               "Dynamics (1991); Stronge, Impact Mechanics (2000)"},
    recognise_first_impact)};

}  // namespace

}  // namespace plumb
