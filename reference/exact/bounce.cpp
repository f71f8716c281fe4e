#include "reference/exact/line.h"

#include <cmath>
#include <limits>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"

namespace plumb {

// The first landing, h + v t - g t^2/2 = 0, is at speed u = sqrt(v^2 + 2 g h) after (v + u)/g. Each landing turns u
// into e u, and the flight after it takes 2 e u/g: a geometric series with the sum 2 e u/(g (1 - e)).
Bounce::Bounce(double height, double speed, double gravity, double restitution)
    : start_{height, speed},
      gravity_(gravity),
      restitution_(restitution),
      landing_((speed + std::sqrt(speed * speed + 2 * gravity * height)) / gravity),
      landing_speed_(std::sqrt(speed * speed + 2 * gravity * height)) {}

Bounce::State Bounce::at(double t) const {
  const auto flight = [this](State from, double s) {
    return State{from.height + from.speed * s - gravity_ * s * s / 2, from.speed - gravity_ * s};
  };
  if (t < landing_) return flight(start_, t);
  double begin = landing_;
  for (double up = restitution_ * landing_speed_;; up *= restitution_) {
    const double end = begin + 2 * up / gravity_;
    if (end == begin) return {};  // the rest of the series is below round-off
    if (t < end) return flight({0, up}, t - begin);
    begin = end;
  }
}

double Bounce::apex(int n) const {
  const double up = std::pow(restitution_, n) * landing_speed_;
  return up * up / (2 * gravity_);
}

double Bounce::impact(int n) const {
  double time = landing_;
  double up = landing_speed_;
  for (int k = 1; k < n; ++k) {
    up *= restitution_;
    time += 2 * up / gravity_;
  }
  return time;
}

double Bounce::rest() const {
  if (restitution_ == 1) return std::numeric_limits<double>::infinity();
  return landing_ + 2 * restitution_ * landing_speed_ / (gravity_ * (1 - restitution_));
}

namespace {

// Along the floor the disc keeps its initial velocity.
struct BouncingDisc {
  std::vector<BodyState> start;
  std::size_t disc = 0;
  Vec up;
  double height = 0;
  Bounce bounce;

  void at(double t, std::span<BodyState> out) const {
    write_states(start, out);
    const Bounce::State now = bounce.at(t);
    const BodyState& from = start[disc];
    const Vec drift = from.velocity - dot(from.velocity, up) * up;
    out[disc].position = from.position + t * drift + (now.height - height) * up;
    out[disc].velocity = drift + now.speed * up;
    out[disc].angle = from.angle + t * from.angular_velocity;
  }
};

Recognised<BouncingDisc> recognise_bounce(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  const std::optional<BodyOnGround> pair = single_body_on_ground(scene);
  if (!pair) return "handles only one disc over fixed ground";
  const Body& body = scene.bodies[pair->body];
  const Vec gravity = gravity_of(scene, body);
  const std::optional<Floor> floor = floor_of(scene.bodies[pair->ground], gravity, body.position);
  if (!floor) return "handles only a floor made of one half-space or one box";
  const Circle* circle = only_shape<Circle>(body);
  if (circle == nullptr || circle->center != Vec{}) return "handles only a single disc";
  const double g = length(gravity);
  if (g == 0 || std::abs(cross(gravity, floor->normal)) > geometry_tolerance * g)
    return "handles only a level floor under gravity";
  const BodyState start = start_of(body);
  const Coefficients mixed = mixed_coefficients(scene, scene.bodies[pair->ground], body);
  const double along = dot(start.velocity, floor->along());
  if (mixed.dynamic_friction != 0 && (along != 0 || start.angular_velocity != 0)) {
    return "handles only a drop without spin or sideways speed, or without friction";
  }
  if (along != 0 && std::isfinite(floor->to)) return "handles sideways speed only over an endless floor";
  const double height = dot(start.position, floor->normal) - floor->offset - circle->radius;
  if (height < 0) return "handles only a disc that starts above the floor";
  return BouncingDisc{start_of(scene), pair->body, floor->normal, height,
                      Bounce(height, dot(start.velocity, floor->normal), g, mixed.restitution)};
}

const Catalog<Engine>::Entry bounce_entry{closed_form<BouncingDisc>(
    {.name = "bounce",
     .about = "A disc that bounces on a level floor: apex n = e^(2n) h; comes to rest after a finite time",
     .source = "Newton's law of restitution, Principia (1687), Scholium to the laws; geometric series of flights"},
    recognise_bounce)};

}  // namespace
}  // namespace plumb
