#include "reference/exact/topple.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {

// Foot at (2 l cos a, 0), head at (0, 2 l sin a), centre at l (cos a, sin a). The wall pushes outwards with R, the
// floor upwards with N and, while the foot slides, back with mu N. Per mass, with k^2 = I/m:
//   x'' = R - mu N,   y'' = N - g,   -k^2 a'' = N l (cos a - mu sin a) - R l sin a.
// With x'' = -l (sin a a'' + cos a a'^2) and y'' = l (cos a a'' - sin a a'^2), R and N can be eliminated:
//   a'' = -(g l (cos a - 2 mu sin a) + 2 mu l^2 sin^2 a a'^2) / (k^2 + l^2 (1 - mu sin 2a)).
// From rest it moves iff cos a > 2 mu sin a. Without friction it is a pendulum with angle a + pi/2, and R = x''
// vanishes where sin a is 2/3 of its initial value. The denominator stays positive for mu < 1.
Ladder::Ladder(const Setup& given)
    : given_(given), stands_(std::tan(given.angle) * 2 * given.friction >= 1), until_(never) {
  if (stands_) return;
  // The wall pushes less and less. A step after which it would have to pull is halved, down to nothing.
  double h = 1e-3 * std::sqrt(given.half / given.gravity);
  State now{given.angle, 0};
  until_ = 0;
  while (until_ + h != until_) {
    const State next = after(now, h);
    if (push(next).x <= 0) {
      h /= 2;
      continue;
    }
    now = next;
    until_ += h;
  }
}

double Ladder::angular_acceleration(const State& now) const {
  const double l = given_.half;
  const double s = std::sin(now.angle);
  const double c = std::cos(now.angle);
  const double mu = given_.friction;
  const double drive = given_.gravity * l * (c - 2 * mu * s) + 2 * mu * l * l * s * s * now.speed * now.speed;
  return -drive / (given_.gyration + l * l * (1 - 2 * mu * s * c));
}

// Fourth-order Runge-Kutta. With steps of sqrt(l/g)/1000 the angle is off by 1e-13.
Ladder::State Ladder::after(const State& now, double h) const {
  const auto moved = [&now](const State& rate, double by) {
    return State{now.angle + by * rate.angle, now.speed + by * rate.speed};
  };
  const auto rate = [this](const State& one) { return State{one.speed, angular_acceleration(one)}; };
  const State k1 = rate(now);
  const State k2 = rate(moved(k1, h / 2));
  const State k3 = rate(moved(k2, h / 2));
  const State k4 = rate(moved(k3, h));
  return {now.angle + h / 6 * (k1.angle + 2 * k2.angle + 2 * k3.angle + k4.angle),
          now.speed + h / 6 * (k1.speed + 2 * k2.speed + 2 * k3.speed + k4.speed)};
}

Ladder::State Ladder::at(double t) const {
  State now{given_.angle, 0};
  if (stands_ || t <= 0) return now;
  const double steps = std::ceil(t / (1e-3 * std::sqrt(given_.half / given_.gravity)));
  for (auto left = static_cast<std::size_t>(steps); left > 0; --left) now = after(now, t / steps);
  return now;
}

Vec Ladder::push(const State& now) const {
  const double l = given_.half;
  const double s = std::sin(now.angle);
  const double c = std::cos(now.angle);
  if (stands_) return {given_.gravity * c / (2 * s), given_.gravity};
  const double turn = angular_acceleration(now);
  const double centripetal = now.speed * now.speed;
  const double floor = given_.gravity + l * (c * turn - s * centripetal);
  return {-l * (s * turn + c * centripetal) + given_.friction * floor, floor};
}

namespace {

struct LeaningLadder {
  std::vector<BodyState> start;
  std::size_t ladder = 0, floor = 0, wall = 0;
  Vec corner, out, up;  // where floor and wall meet; unit vectors out of the wall and up from the floor
  double half = 0, mass = 0;
  Ladder motion;

  Vec from_corner(double angle, double along, double above) const {
    return corner + along * std::cos(angle) * out + above * std::sin(angle) * up;
  }
  // The normal impulses per mass, x of the wall and y of the floor: the change of momentum without gravity's part, plus
  // in x what friction took away.
  Vec impulse(double from, double to) const {
    const Vec by = velocity(motion.at(to)) - velocity(motion.at(from));
    const double lifted = dot(by, up) + motion.given().gravity * (to - from);
    return {dot(by, out) + friction_impulse(lifted, to - from), lifted};
  }
  double friction_impulse(double lifted, double dt) const {
    return motion.stands() ? dt * motion.push(motion.at(0)).x : motion.given().friction * lifted;
  }
  Vec velocity(const Ladder::State& now) const {
    return half * now.speed * (std::cos(now.angle) * up - std::sin(now.angle) * out);
  }
  void at(double t, std::span<BodyState> out_states) const {
    write_states(start, out_states);
    const Ladder::State now = motion.at(t);
    const double sense = cross(out, up);  // the angle grows towards the wall
    BodyState& state = out_states[ladder];
    state.angle -= sense * (now.angle - motion.at(0).angle);
    state.angular_velocity = -sense * now.speed;
    state.position = from_corner(now.angle, half, half);
    state.velocity = velocity(now);
  }
  void contacts(double t, double dt, std::vector<ContactState>& contacts) const {
    const Ladder::State now = motion.at(t);
    const Vec push = mass * impulse(t - dt, t);
    contacts.push_back({.a = floor,
                        .b = ladder,
                        .point = from_corner(now.angle, 2 * half, 0),
                        .normal = up,
                        .normal_impulse = push.y,
                        .tangent_impulse = -mass * friction_impulse(push.y / mass, dt) * cross(up, out)});
    contacts.push_back({.a = wall,
                        .b = ladder,
                        .point = from_corner(now.angle, 0, 2 * half),
                        .normal = out,
                        .normal_impulse = push.x});
  }
  double valid_until() const { return motion.valid_until(); }
};

struct LadderEnd {
  std::size_t body = 0;
  Floor surface;
  Vec point;
};

// The one vertex that touches a fixed surface; nullopt unless there is exactly one.
std::optional<Vec> touching(const Polygon& polygon, const Body& body, const Floor& surface) {
  std::optional<Vec> only;
  for (const Vec& vertex : polygon.vertices) {
    const Vec point = body.position + rotated(vertex, body.angle);
    const double off = dot(point, surface.normal) - surface.offset;
    if (off > geometry_tolerance) continue;
    if (off < -geometry_tolerance || only) return std::nullopt;
    only = point;
  }
  return only;
}

Recognised<LeaningLadder> recognise_ladder(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  std::optional<std::size_t> ladder;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].type == BodyType::dynamic) ladder = i;
  }
  if (scene.bodies.size() != 3 || !ladder) return "handles only one body between a floor and a wall";
  const Body& body = scene.bodies[*ladder];
  const Polygon* polygon = only_shape<Polygon>(body);
  if (polygon == nullptr) return "handles only a ladder made of one polygon";
  if (body.velocity != Vec{} || body.angular_velocity != 0) return "handles only bodies that start at rest";
  const Vec gravity = gravity_of(scene, body);
  const Mass mass = mass_of(body);
  if (length(gravity) == 0 || mass.inertia <= 0) return "handles only a ladder under gravity that can rotate";
  const Vec up = -(1 / length(gravity)) * gravity;

  std::optional<LadderEnd> floor, wall;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == *ladder) continue;
    const std::optional<Floor> surface = floor_of(scene.bodies[i], gravity);
    if (!surface || std::isfinite(surface->to)) return "handles only a floor and a wall that are half-spaces";
    const std::optional<Vec> point = touching(*polygon, body, *surface);
    if (!point) return "handles only a ladder that touches the floor and the wall with one end each";
    const double rise = dot(surface->normal, up);
    if (std::abs(rise - 1) < geometry_tolerance) floor = LadderEnd{i, *surface, *point};
    if (std::abs(rise) < geometry_tolerance) wall = LadderEnd{i, *surface, *point};
  }
  if (!floor || !wall) return "handles only a level floor and an upright wall";
  const Vec center = start_of(body).position;
  if (length(0.5 * (floor->point + wall->point) - center) > geometry_tolerance)
    return "handles only a ladder with its centre midway";
  const Vec out = wall->surface.normal;
  const Vec lie = floor->point - wall->point;
  const double angle = std::atan2(-dot(lie, up), dot(lie, out));
  if (mixed_coefficients(scene, scene.bodies[wall->body], body).static_friction != 0)
    return "handles only a frictionless wall";
  const Coefficients mixed = mixed_coefficients(scene, scene.bodies[floor->body], body);
  if (mixed.static_friction != mixed.dynamic_friction) return "supports only one coefficient of friction";
  const double half = length(lie) / 2;
  const Ladder motion({.half = half,
                       .gyration = mass.inertia / mass.mass,
                       .angle = angle,
                       .gravity = length(gravity),
                       .friction = mixed.static_friction});
  if (!motion.stands() && mixed.static_friction >= 1) return "handles only a sliding foot with friction below 1";
  const Vec corner = floor->surface.offset * up + wall->surface.offset * out;
  return LeaningLadder{start_of(scene), *ladder, floor->body, wall->body, corner, out, up, half, mass.mass, motion};
}

const Catalog<Engine>::Entry ladder_entry{closed_form<LeaningLadder>(
    {.name = "ladder",
     .about = "A ladder on a frictionless wall: stands iff tan a >= 1/(2 mu), else slides and leaves the wall",
     .source = "Statics and energy: e.g. Goldstein, Classical Mechanics, ch. 1 and 2; without friction it leaves at "
               "sin a = (2/3) sin a0"},
    recognise_ladder)};

}  // namespace
}  // namespace plumb
