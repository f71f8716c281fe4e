#include "reference/exact/friction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reference/exact/closed_form.h"
#include "reference/exact/flight.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {

namespace {

// m/s^2, acceleration from rest by Coulomb's law: none while |drive| <= mu_s load, else dynamic friction opposes it.
double acceleration_from_rest(double drive, double load, double static_friction, double dynamic_friction) {
  if (std::abs(drive) <= static_friction * load) return 0;
  return drive - std::copysign(dynamic_friction * load, drive);
}

// The first t in [0, limit] with v t + a t^2/2 = distance, computed without cancellation; `never` if there is none.
double first_time(double v, double a, double distance, double limit) {
  const double root = v * v + 2 * a * distance;
  if (root < 0) return never;
  const double q = v + std::copysign(std::sqrt(root), v == 0 ? distance : v);
  double earliest = never;
  for (const double t : {q == 0 ? never : 2 * distance / q, a == 0 ? never : -q / a}) {
    if (t >= 0 && t <= limit) earliest = std::min(earliest, t);
  }
  return earliest;
}

}  // namespace

Slide::Slide(double speed, double drive, double load, double static_friction, double dynamic_friction)
    : speed_(speed),
      first_(0),
      second_(acceleration_from_rest(drive, load, static_friction, dynamic_friction)),
      stop_(0),
      friction_(second_ == 0 ? std::abs(drive) : dynamic_friction * load) {
  if (speed == 0) return;
  first_ = drive - std::copysign(dynamic_friction * load, speed);
  stop_ = first_ * speed < 0 ? -speed / first_ : never;
  friction_ = stop_ == never ? dynamic_friction * load : std::max(friction_, dynamic_friction * load);
}

Slide::State Slide::at(double t) const {
  const double s = std::min(t, stop_);
  const double rest = t - s;
  return {speed_ * s + first_ * s * s / 2 + second_ * rest * rest / 2,
          t < stop_ ? speed_ + first_ * s : second_ * rest};
}

double Slide::friction() const { return friction_; }

double Slide::reaches(double distance) const {
  const double before = first_time(speed_, first_, distance, stop_);
  if (before < never || stop_ == never) return before;
  return stop_ + first_time(0, second_, distance - at(stop_).distance, never);
}

namespace {

struct SlidingBox {
  std::vector<BodyState> start;
  std::size_t box = 0;
  Vec along;
  Slide slide;
  double until = 0;

  void at(double t, std::span<BodyState> out) const {
    write_states(start, out);
    const Slide::State now = slide.at(t);
    out[box].position = start[box].position + now.distance * along;
    out[box].velocity = now.speed * along;
  }
  double valid_until() const { return until; }
};

Recognised<SlidingBox> recognise_slide(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  const std::optional<BodyOnFloor> found = single_body_on_floor(scene);
  if (!found) return "handles only one box on a floor made of one half-space or of boxes laid flush";
  const Body& body = scene.bodies[found->body];
  const Floor& floor = found->floor;
  const Vec gravity = gravity_of(scene, body);
  const Box* box = only_shape<Box>(body);
  if (box == nullptr) return "handles only a single box";
  const BodyState start = start_of(body);
  const std::optional<Footprint> foot = footprint(*box, body.angle, floor);
  if (!foot) return "handles only a box that lies flat";
  const double gap = dot(start.position, floor.normal) - floor.offset - foot->height / 2;
  if (std::abs(gap) > geometry_tolerance) return "handles only a box that touches the floor";
  if (std::abs(dot(start.velocity, floor.normal)) > geometry_tolerance || start.angular_velocity != 0) {
    return "handles only a box that moves along the floor without spin";
  }
  const double load = -dot(gravity, floor.normal);
  if (load <= 0) return "handles only a box that gravity presses down";
  const Coefficients mixed = mixed_coefficients(scene, scene.bodies[found->ground], body);
  const Slide slide(dot(start.velocity, floor.along()), dot(gravity, floor.along()), load, mixed.static_friction,
                    mixed.dynamic_friction);
  // Friction at the base tips the box with a moment F h/2; the normal force can balance at most N b/2.
  if (slide.friction() * foot->height > load * foot->width) return "handles only a box that does not tip";
  const double here = dot(start.position, floor.along());
  const double until =
      std::min(slide.reaches(floor.to - foot->width / 2 - here), slide.reaches(floor.from + foot->width / 2 - here));
  return SlidingBox{start_of(scene), found->body, floor.along(), slide, until};
}

const Catalog<Engine>::Entry slide_entry{closed_form<SlidingBox>(
    {.name = "slide",
     .about = "A box on a plane: sticks up to tan a = mu, else accelerates by g (sin a - mu cos a); stops after v/(mu "
              "g) on level ground",
     .source = "Coulomb, Theorie des machines simples (1785); Beer & Johnston, Vector Mechanics, ch. 8 and 12"},
    recognise_slide)};

}  // namespace

// Friction f per mass accelerates the centre by f and the rotation by f m r/I. The slip at the lowest point, u = v + w
// r, then changes by
//   u' = drive + f (1 + s),   s = m r^2/I,
// so rolling, u' = 0, needs f = -drive/(1 + s) (a third of the drive for a disc), which static friction must supply.
Roll::Roll(const Setup& given) : given_(given), first_(0), second_(0), grip_(0) {
  const double rolling = -given.drive / (1 + given.shape);
  const bool holds = std::abs(rolling) <= given.static_friction * given.load;
  second_ = holds ? rolling : -std::copysign(given.dynamic_friction * given.load, given.drive);
  const double slip = given.speed + given.spin * given.radius;
  if (slip == 0) return;
  first_ = -std::copysign(given.dynamic_friction * given.load, slip);
  const double change = given.drive + first_ * (1 + given.shape);
  grip_ = change * slip < 0 ? -slip / change : never;
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
    write_states(start, out);
    const Roll::State now = roll.at(t);
    out[disc].position = start[disc].position + now.distance * along;
    out[disc].velocity = now.speed * along;
    out[disc].angle = start[disc].angle + now.angle;
    out[disc].angular_velocity = now.spin;
  }
};

Recognised<RollingDisc> recognise_roll(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  const std::optional<BodyOnGround> pair = single_body_on_ground(scene);
  if (!pair) return "handles only one disc on fixed ground";
  const Body& body = scene.bodies[pair->body];
  const Vec gravity = gravity_of(scene, body);
  const std::optional<Floor> floor = floor_of(scene.bodies[pair->ground], gravity);
  if (!floor || std::isfinite(floor->to)) return "handles only ground that is one half-space";
  const Circle* circle = only_shape<Circle>(body);
  if (circle == nullptr || circle->center != Vec{}) return "handles only a single disc";
  const BodyState start = start_of(body);
  if (std::abs(dot(start.position, floor->normal) - floor->offset - circle->radius) > geometry_tolerance) {
    return "handles only a disc that touches the ground";
  }
  if (std::abs(dot(start.velocity, floor->normal)) > geometry_tolerance)
    return "handles only a disc that moves along the ground";
  const double load = -dot(gravity, floor->normal);
  const Mass mass = mass_of(body);
  if (load <= 0 || mass.inertia <= 0) return "handles only a disc that gravity presses down and that can rotate";
  const Coefficients mixed = mixed_coefficients(scene, scene.bodies[pair->ground], body);
  // `along` is to the right of the normal, so a counter-clockwise spin moves the lowest point along it.
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
     .about = "A disc on a plane: slips until it rolls; rolls with (2/3) g sin a if mu >= tan(a)/3",
     .source = "Beer & Johnston, Vector Mechanics: Dynamics, ch. 16; Coriolis, Theorie du jeu de billard (1835)"},
    recognise_roll)};

}  // namespace

// Friction f on the body is -f on the plank: m a = f, I w' = f r, M A = F - f. The lowest point of the body accelerates
// by a + w' r = (1 + s) f/m, s = m r^2/I. While rolling it keeps up with the plank:
//   (1 + s) f/m = A   =>   f = m A/(1 + s),   A = F/(M + m/(1 + s)),   for a disc F/(M + m/3) and a = A/3.
// Static friction can supply that iff f <= mu m g; else f = mu m g.
Plank::Plank(const Setup& given) : rolls_(false) {
  const double share = given.body / (1 + given.shape);  // kg, effective mass of the rolling body on the plank
  const double rolling = given.pull / (given.plank + share) * share;
  const double load = given.body * given.gravity;  // N
  rolls_ = std::abs(rolling) <= given.static_friction * load;
  const double friction = rolls_ ? rolling : std::copysign(given.dynamic_friction * load, given.pull);
  plank_ = (given.pull - friction) / given.plank;
  body_ = friction / given.body;
  spin_ = body_ * given.shape / given.radius;
}

namespace {

struct PulledPlank {
  std::vector<BodyState> start;
  std::size_t plank = 0, disc = 0;
  Vec along;         // of the pull
  double sense = 1;  // sign of a spin that moves the lowest point along the pull
  Plank motion;
  double until = 0;

  void at(double t, std::span<BodyState> out) const {
    write_states(start, out);
    out[plank] = free_flight(start[plank], motion.plank() * along, t);
    out[disc] = free_flight(start[disc], motion.body() * along, t);
    out[disc].angle += sense * motion.spin() * t * t / 2;
    out[disc].angular_velocity = sense * motion.spin() * t;
  }
  double valid_until() const { return until; }
};

bool at_rest(const Body& body) { return body.velocity == Vec{} && body.angular_velocity == 0; }

Recognised<PulledPlank> recognise_plank(const Scene& scene) {
  if (scene.bodies.size() != 3 || !scene.joints.empty()) return "handles only a floor, a plank and a disc";
  std::optional<std::size_t> ground, plank, disc;
  for (std::size_t i = 0; i < 3; ++i) {
    const Body& body = scene.bodies[i];
    const bool moves = body.type == BodyType::dynamic;
    if (body.type == BodyType::fixed) ground = i;
    if (moves && only_shape<Box>(body) != nullptr) plank = i;
    if (moves && only_shape<Circle>(body) != nullptr) disc = i;
    if (body.linear_damping != 0 || body.angular_damping != 0) return "does not support damping";
    if (!at_rest(body)) return "handles only bodies that start at rest";
    if (body.gravity_scale != 1) return "supports only one gravity for all bodies";
  }
  if (!ground || !plank || !disc) return "handles only a floor, a plank and a disc";
  const Body& board = scene.bodies[*plank];
  const Body& ball = scene.bodies[*disc];
  const std::optional<Floor> floor = floor_of(scene.bodies[*ground], scene.gravity);
  if (!floor || std::isfinite(floor->to)) return "handles only ground that is one half-space";
  const double load = -dot(scene.gravity, floor->normal);
  if (load <= 0 || std::abs(dot(scene.gravity, floor->along())) > geometry_tolerance * load)
    return "handles only a level floor";
  if (mixed_coefficients(scene, scene.bodies[*ground], board).dynamic_friction != 0)
    return "handles only a floor without friction";

  const auto height = [&](const Body& body) { return dot(start_of(body).position, floor->normal) - floor->offset; };
  const std::optional<Footprint> foot = footprint(*only_shape<Box>(board), board.angle, *floor);
  const double radius = only_shape<Circle>(ball)->radius;
  if (!foot || std::abs(height(board) - foot->height / 2) > geometry_tolerance)
    return "handles only a plank that lies on the floor";
  if (only_shape<Circle>(ball)->center != Vec{} ||
      std::abs(height(ball) - foot->height - radius) > geometry_tolerance) {
    return "handles only a disc that lies on the plank";
  }
  const Constant* pull = scene.forces.size() == 1 ? std::get_if<Constant>(&scene.forces.front()) : nullptr;
  const bool pulled = pull != nullptr && pull->body == *plank && pull->torque == 0 &&
                      std::abs(dot(pull->force, floor->normal)) <= geometry_tolerance * length(pull->force);
  if (!pulled) return "handles only one constant force along the floor, on the plank";

  const double force = dot(pull->force, floor->along());
  const Vec along = force < 0 ? -floor->along() : floor->along();
  const Mass mass = mass_of(ball);
  if (mass.inertia <= 0) return "handles only a disc that can rotate";
  const Coefficients mixed = mixed_coefficients(scene, board, ball);
  const Plank motion({.plank = mass_of(board).mass,
                      .body = mass.mass,
                      .radius = radius,
                      .shape = mass.mass * radius * radius / mass.inertia,
                      .pull = std::abs(force),
                      .gravity = load,
                      .static_friction = mixed.static_friction,
                      .dynamic_friction = mixed.dynamic_friction});
  // The disc falls behind, towards the trailing end.
  const double behind = dot(start_of(ball).position - start_of(board).position, along) + foot->width / 2;
  if (behind < 0 || behind > foot->width) return "handles only a disc that lies on the plank";
  const double until = std::sqrt(2 * behind / (motion.plank() - motion.body()));
  return PulledPlank{start_of(scene), *plank, *disc, along, force < 0 ? -1.0 : 1.0, motion, until};
}

const Catalog<Engine>::Entry plank_entry{closed_form<PulledPlank>(
    {.name = "plank",
     .about = "A disc on a plank that is pulled: rolls with a third of the plank's acceleration F/(M + m/3), or slips",
     .source = "Newton's and Euler's laws for both, with friction between them; e.g. Beer & Johnston, Vector "
               "Mechanics: Dynamics, "
               "ch. 16"},
    recognise_plank)};

}  // namespace

}  // namespace plumb
