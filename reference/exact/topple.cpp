#include "reference/exact/topple.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

constexpr double search_step = 1e-3;  // s, between two tests of whether the edge still holds

double frequency(const Topple::Setup& c) { return std::sqrt(c.gravity * c.arm / (c.gyration + c.arm * c.arm)); }

}  // namespace

Topple::Topple(const Setup& given)
    : given_(given), pendulum_(std::numbers::pi - std::max(given.lean, 0.0), frequency(given)), until_(never) {
  if (stands()) {
    until_ = std::tan(given.slope) <= given.friction ? never : 0;
    return;
  }
  double last = 0;
  if (!holds(last)) {
    until_ = 0;
    return;
  }
  double first = search_step;
  for (; holds(first); first += search_step) last = first;
  while (first - last > 1e-15 * first) {
    const double middle = (first + last) / 2;
    if (middle == first || middle == last) break;
    (holds(middle) ? last : first) = middle;
  }
  until_ = last;
}

Topple::State Topple::at(double t) const {
  if (stands()) return {};
  const Pendulum::State now = pendulum_.at(t);
  return {std::numbers::pi - now.angle - given_.lean, -now.speed};
}

// With s the lean, the centre is at arm (sin s, cos s) and s'' = w^2 sin s. The floor's force per mass is the
// acceleration of the centre minus gravity.
Vec Topple::push(double t) const {
  const State now = at(t);
  const double s = given_.lean + now.turn;
  const double w = frequency(given_);
  const double angular_acceleration = stands() ? 0 : w * w * std::sin(s);
  const double centripetal = now.spin * now.spin;
  const Vec force{given_.arm * (angular_acceleration * std::cos(s) - centripetal * std::sin(s)),
                  given_.gravity - given_.arm * (angular_acceleration * std::sin(s) + centripetal * std::cos(s))};
  return rotated(force, given_.slope);  // into the frame of the floor, which slopes down in the direction of the fall
}

bool Topple::holds(double t) const {
  const Vec force = push(t);
  return at(t).turn < given_.landing && force.y > 0 && std::abs(force.x) <= given_.friction * force.y;
}

namespace {

struct TopplingBox {
  std::vector<BodyState> start;
  std::size_t box = 0;
  Vec edge, arm;     // arm: from the edge to the centre at the start
  double sense = 1;  // of the fall: 1 counter-clockwise
  Topple topple;

  void at(double t, std::span<BodyState> out) const {
    write_states(start, out);
    const Topple::State now = topple.at(t);
    const Vec here = rotated(arm, sense * now.turn);
    out[box].position = edge + here;
    out[box].angle = start[box].angle + sense * now.turn;
    out[box].velocity = sense * now.spin * perpendicular(here);
    out[box].angular_velocity = sense * now.spin;
  }
  double valid_until() const { return topple.valid_until(); }
};

Recognised<TopplingBox> recognise_topple(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  const std::optional<BodyOnGround> pair = single_body_on_ground(scene);
  if (!pair) return "handles only one box on fixed ground";
  const Body& body = scene.bodies[pair->body];
  const Vec gravity = gravity_of(scene, body);
  const std::optional<Floor> floor = floor_of(scene.bodies[pair->ground], gravity, body.position);
  const Box* box = only_shape<Box>(body);
  if (!floor || box == nullptr) return "handles only one box on a floor made of one half-space or one box";
  const BodyState start = start_of(body);
  if (start.velocity != Vec{} || start.angular_velocity != 0) return "handles only bodies that start at rest";
  const std::optional<Footprint> foot = footprint(*box, body.angle, *floor);
  if (!foot) return "handles only a box that lies flat";
  if (std::abs(dot(start.position, floor->normal) - floor->offset - foot->height / 2) > geometry_tolerance) {
    return "handles only a box that touches the floor";
  }
  const double load = -dot(gravity, floor->normal);
  const Mass mass = mass_of(body);
  if (load <= 0 || mass.inertia <= 0) return "handles only a box that gravity presses down and that can rotate";
  const double drive = dot(gravity, floor->along());
  const Vec down = drive < 0 ? -floor->along() : floor->along();
  const double slope = std::atan2(std::abs(drive), load);
  const Vec arm = -foot->width / 2 * down + foot->height / 2 * floor->normal;
  const Topple topple({.arm = length(arm),
                       .lean = slope - std::atan2(foot->width, foot->height),
                       .gyration = mass.inertia / mass.mass,
                       .gravity = length(gravity),
                       .slope = slope,
                       .friction = mixed_coefficients(scene, scene.bodies[pair->ground], body).static_friction,
                       .landing = std::numbers::pi / 2});
  if (topple.valid_until() == 0) return "handles only a box that does not slide";
  return TopplingBox{start_of(scene), pair->body, start.position - arm, arm, drive < 0 ? 1.0 : -1.0, topple};
}

const Catalog<Engine>::Entry topple_entry{closed_form<TopplingBox>(
    {.name = "topple",
     .about = "A box on a rough slope: stands while tan a <= b/h, else topples about its lower edge",
     .source = "An inverted pendulum until its edge slips: Landau & Lifshitz, Mechanics, par. 11; forces by Newton"},
    recognise_topple)};

}  // namespace
}  // namespace plumb
