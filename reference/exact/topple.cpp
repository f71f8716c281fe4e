#include "reference/exact/topple.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

constexpr double grain = 1e-3;  // s; what holds at one and fails at the next fails between them

double frequency(const Topple::Case& c) { return std::sqrt(c.gravity * c.arm / (c.gyration + c.arm * c.arm)); }

}  // namespace

Topple::Topple(const Case& given)
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
  double first = grain;
  for (; holds(first); first += grain) last = first;
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

// With s the lean, the centre is at arm (sin s, cos s); s'' = w^2 sin s. The floor gives its acceleration less gravity.
Vec Topple::push(double t) const {
  const State now = at(t);
  const double s = given_.lean + now.turn;
  const double w = frequency(given_);
  const double turning = stands() ? 0 : w * w * std::sin(s);
  const double fling = now.spin * now.spin;
  const Vec force{given_.arm * (turning * std::cos(s) - fling * std::sin(s)),
                  given_.gravity - given_.arm * (turning * std::sin(s) + fling * std::cos(s))};
  return turned(force, given_.slope);  // into the floor's frame, which the fall goes down
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
    for (std::size_t i = 0; i < start.size(); ++i) out[i] = start[i];
    const Topple::State now = topple.at(t);
    const Vec here = turned(arm, sense * now.turn);
    out[box].position = edge + here;
    out[box].angle = start[box].angle + sense * now.turn;
    out[box].velocity = sense * now.spin * left_of(here);
    out[box].angular_velocity = sense * now.spin;
  }
  double valid_until() const { return topple.valid_until(); }
};

Recognised<TopplingBox> recognise_topple(const Scene& scene) {
  if (const std::string reason = beyond_textbook(scene); !reason.empty()) return reason;
  const std::optional<Pair> pair = one_on_ground(scene);
  if (!pair) return "solves one box on fixed ground";
  const Body& body = scene.bodies[pair->body];
  const Vec gravity = gravity_of(scene, body);
  const std::optional<Floor> floor = floor_of(scene.bodies[pair->ground], gravity);
  const Box* box = lone<Box>(body);
  if (!floor || box == nullptr) return "solves one box on a floor made of one half-space or one box";
  const BodyState start = start_of(body);
  if (start.velocity != Vec{} || start.angular_velocity != 0) return "solves what starts at rest";
  const std::optional<Footprint> foot = footprint(*box, body.angle, *floor);
  if (!foot) return "solves a box that lies flat";
  if (std::abs(dot(start.position, floor->normal) - floor->offset - foot->height / 2) > flat) {
    return "solves a box that touches the floor";
  }
  const double load = -dot(gravity, floor->normal);
  const Mass mass = mass_of(body);
  if (load <= 0 || mass.inertia <= 0) return "solves a box that gravity presses on and that may turn";
  const double drive = dot(gravity, floor->along());
  const Vec down = drive < 0 ? -floor->along() : floor->along();
  const double slope = std::atan2(std::abs(drive), load);
  const Vec arm = -foot->width / 2 * down + foot->height / 2 * floor->normal;
  const Topple topple({.arm = length(arm),
                       .lean = slope - std::atan2(foot->width, foot->height),
                       .gyration = mass.inertia / mass.mass,
                       .gravity = length(gravity),
                       .slope = slope,
                       .friction = between(scene, scene.bodies[pair->ground], body).static_friction,
                       .landing = std::numbers::pi / 2});
  if (topple.valid_until() == 0) return "solves a box that does not slide";
  return TopplingBox{start_of(scene), pair->body, start.position - arm, arm, drive < 0 ? 1.0 : -1.0, topple};
}

const Catalog<Engine>::Entry topple_entry{closed_form<TopplingBox>(
    {.name = "topple",
     .about = "A box on a rough slope: stands while tan a <= b/h, else turns about its lower edge",
     .source = "An upside-down pendulum until its edge slips: Landau & Lifshitz, Mechanics, par. 11; forces by Newton"},
    recognise_topple)};

}  // namespace
}  // namespace plumb
