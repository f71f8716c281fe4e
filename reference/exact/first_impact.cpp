#include "reference/exact/first_impact.h"

#include <cmath>

#include "reference/exact/closed_form.h"
#include "reference/exact/impact_law.h"
#include "scenarios/scene/mass.h"

namespace plumb {

std::variant<FirstImpact, std::string> FirstImpact::solve(const Case& given) {
  FirstImpact motion;
  motion.before_ = given.start;
  motion.gravity_ = given.gravity;
  for (const Corner& corner : given.corners) {
    if (clearance(corner, given.start, given.floor) < -flat) return "solves a body that starts off the floor";
  }
  const std::optional<Contact> contact =
      first_contact(given.start, given.gravity, given.corners, given.floor, given.horizon);
  if (!contact) return motion;

  const BodyState landed = thrown(given.start, given.gravity, contact->time);
  for (std::size_t i = 0; i < given.corners.size(); ++i) {
    if (i != contact->corner && clearance(given.corners[i], landed, given.floor) < flat) {
      return "solves an impact of one corner at a time";
    }
  }
  const Corner& corner = given.corners[contact->corner];
  const Vec arm = turned(corner.offset, landed.angle) - corner.radius * given.floor.normal;
  const std::optional<Vec> push = impulse({.mass = given.mass,
                                           .inertia = given.inertia,
                                           .normal = given.floor.normal,
                                           .arm = arm,
                                           .velocity = landed.velocity,
                                           .spin = landed.angular_velocity,
                                           .friction = given.friction,
                                           .restitution = given.restitution});
  if (!push) return "solves an impact whose slip keeps its direction: otherwise the classical laws disagree";

  motion.impact_ = contact->time;
  motion.after_ = landed;
  motion.after_.velocity = landed.velocity + (1 / given.mass) * *push;
  motion.after_.angular_velocity += cross(arm, *push) / given.inertia;
  const double left = given.horizon - contact->time;
  if (const auto second = first_contact(motion.after_, given.gravity, given.corners, given.floor, left)) {
    motion.until_ = contact->time + second->time;
  }
  return motion;
}

BodyState FirstImpact::at(double t) const {
  return t < impact_ ? thrown(before_, gravity_, t) : thrown(after_, gravity_, t - impact_);
}

namespace {

struct ImpactingBody {
  std::vector<BodyState> start;
  std::size_t body = 0;
  FirstImpact motion;

  void at(double t, std::span<BodyState> out) const {
    for (std::size_t i = 0; i < start.size(); ++i) out[i] = start[i];
    out[body] = motion.at(t);
  }
  double valid_until() const { return motion.valid_until(); }
};

Recognised<ImpactingBody> recognise_first_impact(const Scene& scene) {
  if (const std::string reason = beyond_textbook(scene); !reason.empty()) return reason;
  const std::optional<Pair> pair = one_on_ground(scene);
  if (!pair) return "solves one body over fixed ground";
  const Body& ground = scene.bodies[pair->ground];
  const Body& body = scene.bodies[pair->body];
  const Vec gravity = gravity_of(scene, body);
  const std::optional<Floor> floor = floor_of(ground, gravity);
  if (!floor || std::isfinite(floor->to)) return "solves ground that is one half-space";
  const Mass mass = mass_of(body);
  if (body.shapes.size() != 1 || mass.mass <= 0 || mass.inertia <= 0) return "solves a single shape free to turn";
  const Coefficients mixed = between(scene, ground, body);
  if (mixed.static_friction != mixed.dynamic_friction) return "knows one coefficient of friction";
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
