#include "reference/exact/slide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"

namespace plumb {
namespace {

// From rest, Coulomb: no motion while |drive| <= mu_s load, else friction mu_d load against it.
double from_rest(double drive, double load, double static_friction, double dynamic_friction) {
  if (std::abs(drive) <= static_friction * load) return 0;
  return drive - std::copysign(dynamic_friction * load, drive);
}

// The first t in [0, limit] with v t + a t^2/2 = distance, in the form that does not cancel.
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
      second_(from_rest(drive, load, static_friction, dynamic_friction)),
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
    for (std::size_t i = 0; i < start.size(); ++i) out[i] = start[i];
    const Slide::State now = slide.at(t);
    out[box].position = start[box].position + now.distance * along;
    out[box].velocity = now.speed * along;
  }
  double valid_until() const { return until; }
};

Recognised<SlidingBox> recognise_slide(const Scene& scene) {
  if (const std::string reason = beyond_textbook(scene); !reason.empty()) return reason;
  const std::optional<OnFloor> found = one_on_floor(scene);
  if (!found) return "solves one box on a floor made of one half-space, or of boxes laid flush";
  const Body& body = scene.bodies[found->body];
  const Floor& floor = found->floor;
  const Vec gravity = gravity_of(scene, body);
  const Box* box = lone<Box>(body);
  if (box == nullptr) return "solves a single box";
  const BodyState start = start_of(body);
  const std::optional<Footprint> foot = footprint(*box, body.angle, floor);
  if (!foot) return "solves a box that lies flat";
  const double gap = dot(start.position, floor.normal) - floor.offset - foot->height / 2;
  if (std::abs(gap) > flat) return "solves a box that touches the floor";
  if (std::abs(dot(start.velocity, floor.normal)) > flat || start.angular_velocity != 0) {
    return "solves a box that moves along the floor without spin";
  }
  const double load = -dot(gravity, floor.normal);
  if (load <= 0) return "solves a box that gravity presses on";
  const Coefficients mixed = between(scene, scene.bodies[found->ground], body);
  const Slide slide(dot(start.velocity, floor.along()), dot(gravity, floor.along()), load, mixed.static_friction,
                    mixed.dynamic_friction);
  // Friction at the foot turns the box with F h/2; the load can answer with N b/2 at most.
  if (slide.friction() * foot->height > load * foot->width) return "solves a box that does not tip";
  const double here = dot(start.position, floor.along());
  const double until =
      std::min(slide.reaches(floor.to - foot->width / 2 - here), slide.reaches(floor.from + foot->width / 2 - here));
  return SlidingBox{start_of(scene), found->body, floor.along(), slide, until};
}

const Catalog<Engine>::Entry slide_entry{closed_form<SlidingBox>(
    {.name = "slide",
     .about = "A box on a plane: sticks up to tan a = mu, else g (sin a - mu cos a); stops after v/(mu g) on the level",
     .source = "Coulomb, Theorie des machines simples (1785); Beer & Johnston, Vector Mechanics, ch. 8 and 12"},
    recognise_slide)};

}  // namespace
}  // namespace plumb
