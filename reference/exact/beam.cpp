#include "reference/exact/beam.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {

// Moments about either support: R_left (a + b) = W b.
Beam::Beam(double weight, double left, double right)
    : left_(weight * right / (left + right)), right_(weight * left / (left + right)) {}

namespace {

struct LyingBeam {
  std::vector<BodyState> start;
  std::size_t beam = 0, left = 0, right = 0;
  Vec up, left_point, right_point;
  Beam reactions;

  void at(double, std::span<BodyState> out) const { std::copy(start.begin(), start.end(), out.begin()); }
  void contacts(double, double dt, std::vector<ContactState>& out) const {
    out.push_back({.a = left, .b = beam, .point = left_point, .normal = up, .normal_impulse = reactions.left() * dt});
    out.push_back(
        {.a = right, .b = beam, .point = right_point, .normal = up, .normal_impulse = reactions.right() * dt});
  }
};

Recognised<LyingBeam> recognise_beam(const Scene& scene) {
  if (const std::string reason = beyond_textbook(scene); !reason.empty()) return reason;
  std::optional<std::size_t> beam;
  std::vector<std::size_t> supports;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.type == BodyType::dynamic && lone<Box>(body) != nullptr) beam = i;
    const Circle* circle = lone<Circle>(body);
    if (body.type == BodyType::fixed && circle != nullptr && circle->center == Vec{}) supports.push_back(i);
  }
  if (scene.bodies.size() != 3 || !beam || supports.size() != 2) return "solves a box on two fixed discs";
  const Body& body = scene.bodies[*beam];
  if (body.velocity != Vec{} || body.angular_velocity != 0) return "solves what starts at rest";
  const Vec gravity = gravity_of(scene, body);
  if (length(gravity) == 0) return "solves a beam that gravity presses on";
  const Vec up = -(1 / length(gravity)) * gravity;
  const Floor level{.normal = up};
  const std::optional<Footprint> foot = footprint(*lone<Box>(body), body.angle, level);
  if (!foot) return "solves a beam that lies level";
  const Vec center = start_of(body).position;
  const auto place = [&](std::size_t i) { return dot(scene.bodies[i].position - center, level.along()); };
  const auto top = [&](std::size_t i) { return scene.bodies[i].position + lone<Circle>(scene.bodies[i])->radius * up; };
  if (place(supports[0]) > place(supports[1])) std::swap(supports[0], supports[1]);
  const double a = -place(supports[0]);
  const double b = place(supports[1]);
  for (const std::size_t i : supports) {
    if (std::abs(dot(center - top(i), up) - foot->height / 2) > flat) return "solves a beam that touches both supports";
  }
  if (a <= 0 || b <= 0 || std::max(a, b) > foot->width / 2) return "solves a beam with its centre between its supports";
  return LyingBeam{start_of(scene),
                   *beam,
                   supports[0],
                   supports[1],
                   up,
                   top(supports[0]),
                   top(supports[1]),
                   Beam(mass_of(body).mass * length(gravity), a, b)};
}

const Catalog<Engine>::Entry beam_entry{
    closed_form<LyingBeam>({.name = "beam",
                            .about = "A beam on two supports: they carry m g b/(a + b) and m g a/(a + b)",
                            .source = "Archimedes, On the Equilibrium of Planes, I, 6"},
                           recognise_beam)};

}  // namespace
}  // namespace plumb
