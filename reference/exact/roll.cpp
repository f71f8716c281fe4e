#include "reference/exact/roll.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {

// Friction f per mass moves the centre by f and turns the body by f m r/I. The rim's slip u = v + w r then changes by
//   u' = drive + f (1 + s),   s = m r^2/I,
// so that rolling, u' = 0, takes f = -drive/(1 + s) (a third of the drive for a disc), and static friction must hold
// that.
Roll::Roll(const Case& given) : given_(given), first_(0), second_(0), grip_(0) {
  const double rolling = -given.drive / (1 + given.shape);
  const bool holds = std::abs(rolling) <= given.static_friction * given.load;
  second_ = holds ? rolling : -std::copysign(given.dynamic_friction * given.load, given.drive);
  const double slip = given.speed + given.spin * given.radius;
  if (slip == 0) return;
  first_ = -std::copysign(given.dynamic_friction * given.load, slip);
  const double change = given.drive + first_ * (1 + given.shape);
  grip_ = change * slip < 0 ? -slip / change : std::numeric_limits<double>::infinity();
}

Roll::State Roll::at(double t) const {
  const auto go = [this](const State& from, double friction, double s) {
    const double a = given_.drive + friction;
    const double turn = friction * given_.shape / given_.radius;
    return State{from.distance + from.speed * s + a * s * s / 2, from.speed + a * s,
                 from.angle + from.spin * s + turn * s * s / 2, from.spin + turn * s};
  };
  const State start{0, given_.speed, 0, given_.spin};
  if (t <= grip_) return go(start, first_, t);
  return go(go(start, first_, grip_), second_, t - grip_);
}

namespace {

struct RollingDisc {
  std::vector<BodyState> start;
  std::size_t disc = 0;
  Vec along;
  Roll roll;

  void at(double t, std::span<BodyState> out) const {
    for (std::size_t i = 0; i < start.size(); ++i) out[i] = start[i];
    const Roll::State now = roll.at(t);
    out[disc].position = start[disc].position + now.distance * along;
    out[disc].velocity = now.speed * along;
    out[disc].angle = start[disc].angle + now.angle;
    out[disc].angular_velocity = now.spin;
  }
};

Recognised<RollingDisc> recognise_roll(const Scene& scene) {
  if (const std::string reason = beyond_textbook(scene); !reason.empty()) return reason;
  const std::optional<Pair> pair = one_on_ground(scene);
  if (!pair) return "solves one disc on fixed ground";
  const Body& body = scene.bodies[pair->body];
  const Vec gravity = gravity_of(scene, body);
  const std::optional<Floor> floor = floor_of(scene.bodies[pair->ground], gravity);
  if (!floor || std::isfinite(floor->to)) return "solves ground that is one half-space";
  const Circle* circle = lone<Circle>(body);
  if (circle == nullptr || circle->center != Vec{}) return "solves a single disc";
  const BodyState start = start_of(body);
  if (std::abs(dot(start.position, floor->normal) - floor->offset - circle->radius) > flat) {
    return "solves a disc that touches the ground";
  }
  if (std::abs(dot(start.velocity, floor->normal)) > flat) return "solves a disc that moves along the ground";
  const double load = -dot(gravity, floor->normal);
  const Mass mass = mass_of(body);
  if (load <= 0 || mass.inertia <= 0) return "solves a disc that gravity presses on and that may turn";
  const Coefficients mixed = between(scene, scene.bodies[pair->ground], body);
  // Counter-clockwise, the rim below goes along as `along` lies to the right of the normal.
  return RollingDisc{start_of(scene), pair->body, floor->along(),
                     Roll({.speed = dot(start.velocity, floor->along()),
                           .spin = start.angular_velocity,
                           .radius = circle->radius,
                           .shape = mass.mass * circle->radius * circle->radius / mass.inertia,
                           .drive = dot(gravity, floor->along()),
                           .load = load,
                           .static_friction = mixed.static_friction,
                           .dynamic_friction = mixed.dynamic_friction})};
}

const Catalog<Engine>::Entry roll_entry{closed_form<RollingDisc>(
    {.name = "roll",
     .about = "A disc on a plane: slips until it rolls, rolls with (2/3) g sin a if mu >= tan(a)/3",
     .source = "Beer & Johnston, Vector Mechanics: Dynamics, ch. 16; Coriolis, Theorie du jeu de billard (1835)"},
    recognise_roll)};

}  // namespace
}  // namespace plumb
