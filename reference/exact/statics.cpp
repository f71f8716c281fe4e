#include "reference/exact/statics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {

// Moments about the right support: R_left (a + b) = W b; about the left one likewise.
Beam::Beam(double weight, double left, double right)
    : left_(weight * right / (left + right)), right_(weight * left / (left + right)) {}

namespace {

struct LyingBeam {
  std::vector<BodyState> start;
  std::size_t beam = 0, left = 0, right = 0;
  Vec up, left_point, right_point;
  Beam reactions;

  void at(double, std::span<BodyState> out) const { write_states(start, out); }
  void contacts(double, double dt, std::vector<ContactState>& out) const {
    out.push_back({.a = left, .b = beam, .point = left_point, .normal = up, .normal_impulse = reactions.left() * dt});
    out.push_back(
        {.a = right, .b = beam, .point = right_point, .normal = up, .normal_impulse = reactions.right() * dt});
  }
};

Recognised<LyingBeam> recognise_beam(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  std::optional<std::size_t> beam;
  std::vector<std::size_t> supports;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.type == BodyType::dynamic && only_shape<Box>(body) != nullptr) beam = i;
    const Circle* circle = only_shape<Circle>(body);
    if (body.type == BodyType::fixed && circle != nullptr && circle->center == Vec{}) supports.push_back(i);
  }
  if (scene.bodies.size() != 3 || !beam || supports.size() != 2) return "handles only a box on two fixed discs";
  const Body& body = scene.bodies[*beam];
  if (body.velocity != Vec{} || body.angular_velocity != 0) return "handles only bodies that start at rest";
  const Vec gravity = gravity_of(scene, body);
  if (length(gravity) == 0) return "handles only a beam that gravity presses down";
  const Vec up = -(1 / length(gravity)) * gravity;
  const Floor level{.normal = up};
  const std::optional<Footprint> foot = footprint(*only_shape<Box>(body), body.angle, level);
  if (!foot) return "handles only a beam that lies level";
  const Vec center = start_of(body).position;
  const auto offset = [&](std::size_t i) { return dot(scene.bodies[i].position - center, level.along()); };
  const auto top = [&](std::size_t i) {
    return scene.bodies[i].position + only_shape<Circle>(scene.bodies[i])->radius * up;
  };
  if (offset(supports[0]) > offset(supports[1])) std::swap(supports[0], supports[1]);
  const double a = -offset(supports[0]);
  const double b = offset(supports[1]);
  for (const std::size_t i : supports) {
    if (std::abs(dot(center - top(i), up) - foot->height / 2) > geometry_tolerance)
      return "handles only a beam that touches both supports";
  }
  if (a <= 0 || b <= 0 || std::max(a, b) > foot->width / 2)
    return "handles only a beam with its centre between its supports";
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
                            .about = "A beam on two supports, which carry m g b/(a + b) and m g a/(a + b)",
                            .source = "Archimedes, On the Equilibrium of Planes, I, 6"},
                           recognise_beam)};

}  // namespace

RestingTower::RestingTower(std::vector<BodyState> start, std::vector<SupportSurface> surfaces, Vec up)
    : start_(std::move(start)), surfaces_(std::move(surfaces)), up_(up) {}

void RestingTower::at(double, std::span<BodyState> out) const { write_states(start_, out); }

void RestingTower::contacts(double, double dt, std::vector<ContactState>& out) const {
  for (const SupportSurface& surface : surfaces_) {
    const double share = surface.resultant / length(surface.right - surface.left);
    for (const auto& [point, part] : {std::pair{surface.left, 1 - share}, std::pair{surface.right, share}}) {
      out.push_back({.a = surface.below,
                     .b = surface.above,
                     .point = point,
                     .normal = up_,
                     .normal_impulse = part * surface.weight * dt});
    }
  }
}

namespace {

// One box of the tower, in the frame of the floor.
struct Storey {
  std::size_t body = 0;
  double middle = 0;  // m along the floor
  double bottom = 0;  // m above it
  double width = 0, height = 0;
  double weight = 0;  // N, negative if it rises
};

std::variant<std::vector<Storey>, std::string> storeys(const Scene& scene, std::size_t ground, const Floor& floor) {
  std::vector<Storey> tower;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (i == ground) continue;
    const Body& body = scene.bodies[i];
    const Box* box = only_shape<Box>(body);
    if (body.type != BodyType::dynamic || box == nullptr) return "handles only boxes on fixed ground";
    if (body.velocity != Vec{} || body.angular_velocity != 0) return "handles only bodies that start at rest";
    const std::optional<Footprint> foot = footprint(*box, body.angle, floor);
    if (!foot) return "handles only boxes that lie flat";
    const Vec center = start_of(body).position;
    tower.push_back({i, dot(center, floor.along()), dot(center, floor.normal) - floor.offset - foot->height / 2,
                     foot->width, foot->height, -mass_of(body).mass * dot(gravity_of(scene, body), floor.normal)});
  }
  std::sort(tower.begin(), tower.end(), [](const Storey& a, const Storey& b) { return a.bottom < b.bottom; });
  return tower;
}

Recognised<RestingTower> recognise_rest(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  const auto fixed = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                  [](const Body& body) { return body.type == BodyType::fixed; });
  if (fixed == scene.bodies.end()) return "handles only towers on fixed ground";
  const std::optional<Floor> floor = floor_of(*fixed, scene.gravity);
  if (!floor) return "handles only a floor made of one half-space or one box";
  if (std::abs(cross(scene.gravity, floor->normal)) > geometry_tolerance * length(scene.gravity))
    return "handles only a level floor";
  const auto ground = static_cast<std::size_t>(fixed - scene.bodies.begin());
  const auto found = storeys(scene, ground, *floor);
  if (const std::string* reason = std::get_if<std::string>(&found)) return *reason;
  const auto& tower = std::get<std::vector<Storey>>(found);

  // From the top down, sums up the weight above each surface. The tower stands if every weight acts within its surface.
  std::vector<SupportSurface> surfaces;
  double weight = 0;
  double moment = 0;
  for (std::size_t k = tower.size(); k-- > 0;) {
    const Storey& above = tower[k];
    weight += above.weight;
    moment += above.weight * above.middle;
    const double top = k == 0 ? 0 : tower[k - 1].bottom + tower[k - 1].height;
    if (std::abs(above.bottom - top) > geometry_tolerance)
      return "handles only a single tower, each box on the one below";
    const double low = k == 0 ? floor->from : tower[k - 1].middle - tower[k - 1].width / 2;
    const double high = k == 0 ? floor->to : tower[k - 1].middle + tower[k - 1].width / 2;
    const double left = std::max(low, above.middle - above.width / 2);
    const double right = std::min(high, above.middle + above.width / 2);
    const double acts = moment / weight;
    if (weight <= 0 || acts < left || acts > right) return "handles only towers that stand, and this one topples";
    const Vec base = (floor->offset + above.bottom) * floor->normal;
    surfaces.push_back({k == 0 ? ground : tower[k - 1].body, above.body, base + left * floor->along(),
                        base + right * floor->along(), weight, acts - left});
  }
  std::reverse(surfaces.begin(), surfaces.end());
  return RestingTower(start_of(scene), std::move(surfaces), floor->normal);
}

const Catalog<Engine>::Entry rest_entry{closed_form<RestingTower>(
    {.name = "rest",
     .about = "A tower in equilibrium: nothing moves, and each surface carries the weight above it",
     .source = "Statics of rigid bodies, e.g. Meriam & Kraige, Statics, ch. 3; lever rule (Archimedes)"},
    recognise_rest)};

}  // namespace

}  // namespace plumb
