#include "reference/exact/plank.h"

#include <cmath>
#include <limits>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {

// Friction f on the body is -f on the plank: m a = f, I w' = f r, M A = F - f. The rim below gains a + w' r =
// (1 + s) f/m, s = m r^2/I; rolling it keeps up with the plank:
//   (1 + s) f/m = A   =>   f = m A/(1 + s),   A = F/(M + m/(1 + s)),   for a disc F/(M + m/3) and a = A/3.
// Static friction holds that iff f <= mu m g; else f = mu m g.
Plank::Plank(const Case& given) : rolls_(false) {
  const double share = given.body / (1 + given.shape);  // kg of the body that the plank feels while it rolls
  const double rolling = given.pull / (given.plank + share) * share;
  const double most = given.body * given.gravity;  // N
  rolls_ = std::abs(rolling) <= given.static_friction * most;
  const double friction = rolls_ ? rolling : std::copysign(given.dynamic_friction * most, given.pull);
  plank_ = (given.pull - friction) / given.plank;
  body_ = friction / given.body;
  spin_ = body_ * given.shape / given.radius;
}

namespace {

struct PulledPlank {
  std::vector<BodyState> start;
  std::size_t plank = 0, disc = 0;
  Vec along;         // of the pull
  double sense = 1;  // of a spin whose rim below goes along the pull
  Plank motion;
  double until = 0;

  void at(double t, std::span<BodyState> out) const {
    for (std::size_t i = 0; i < start.size(); ++i) out[i] = start[i];
    out[plank] = thrown(start[plank], motion.plank() * along, t);
    out[disc] = thrown(start[disc], motion.body() * along, t);
    out[disc].angle += sense * motion.spin() * t * t / 2;
    out[disc].angular_velocity = sense * motion.spin() * t;
  }
  double valid_until() const { return until; }
};

bool at_rest(const Body& body) { return body.velocity == Vec{} && body.angular_velocity == 0; }

Recognised<PulledPlank> recognise_plank(const Scene& scene) {
  if (scene.bodies.size() != 3 || !scene.joints.empty()) return "solves a floor, a plank and a disc";
  std::optional<std::size_t> ground, plank, disc;
  for (std::size_t i = 0; i < 3; ++i) {
    const Body& body = scene.bodies[i];
    const bool moves = body.type == BodyType::dynamic;
    if (body.type == BodyType::fixed) ground = i;
    if (moves && lone<Box>(body) != nullptr) plank = i;
    if (moves && lone<Circle>(body) != nullptr) disc = i;
    if (body.linear_damping != 0 || body.angular_damping != 0) return "knows no damping";
    if (!at_rest(body)) return "solves what starts at rest";
    if (body.gravity_scale != 1) return "knows one gravity for all";
  }
  if (!ground || !plank || !disc) return "solves a floor, a plank and a disc";
  const Body& board = scene.bodies[*plank];
  const Body& ball = scene.bodies[*disc];
  const std::optional<Floor> floor = floor_of(scene.bodies[*ground], scene.gravity);
  if (!floor || std::isfinite(floor->to)) return "solves ground that is one half-space";
  const double load = -dot(scene.gravity, floor->normal);
  if (load <= 0 || std::abs(dot(scene.gravity, floor->along())) > flat * load) return "solves a level floor";
  if (between(scene, scene.bodies[*ground], board).dynamic_friction != 0) return "solves a floor without friction";

  const auto height = [&](const Body& body) { return dot(start_of(body).position, floor->normal) - floor->offset; };
  const std::optional<Footprint> foot = footprint(*lone<Box>(board), board.angle, *floor);
  const double radius = lone<Circle>(ball)->radius;
  if (!foot || std::abs(height(board) - foot->height / 2) > flat) return "solves a plank that lies on the floor";
  if (lone<Circle>(ball)->center != Vec{} || std::abs(height(ball) - foot->height - radius) > flat) {
    return "solves a disc that lies on the plank";
  }
  const Constant* pull = scene.forces.size() == 1 ? std::get_if<Constant>(&scene.forces.front()) : nullptr;
  const bool pulled = pull != nullptr && pull->body == *plank && pull->torque == 0 &&
                      std::abs(dot(pull->force, floor->normal)) <= flat * length(pull->force);
  if (!pulled) return "solves one constant force along the floor, on the plank";

  const double force = dot(pull->force, floor->along());
  const Vec along = force < 0 ? -floor->along() : floor->along();
  const Mass mass = mass_of(ball);
  if (mass.inertia <= 0) return "solves a disc free to turn";
  const Coefficients mixed = between(scene, board, ball);
  const Plank motion({.plank = mass_of(board).mass,
                      .body = mass.mass,
                      .radius = radius,
                      .shape = mass.mass * radius * radius / mass.inertia,
                      .pull = std::abs(force),
                      .gravity = load,
                      .static_friction = mixed.static_friction,
                      .dynamic_friction = mixed.dynamic_friction});
  // The disc falls behind, to the end that trails.
  const double behind = dot(start_of(ball).position - start_of(board).position, along) + foot->width / 2;
  if (behind < 0 || behind > foot->width) return "solves a disc that lies on the plank";
  const double until = std::sqrt(2 * behind / (motion.plank() - motion.body()));
  return PulledPlank{start_of(scene), *plank, *disc, along, force < 0 ? -1.0 : 1.0, motion, until};
}

const Catalog<Engine>::Entry plank_entry{closed_form<PulledPlank>(
    {.name = "plank",
     .about = "A disc on a plank that is pulled: rolls with a third of the plank's F/(M + m/3), or slips",
     .source = "Newton and Euler for both, friction between them; e.g. Beer & Johnston, Vector Mechanics: Dynamics, "
               "ch. 16"},
    recognise_plank)};

}  // namespace
}  // namespace plumb
