#include "reference/exact/rest.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {

Rest::Rest(std::vector<BodyState> start, std::vector<Bearing> bearings, Vec up)
    : start_(std::move(start)), bearings_(std::move(bearings)), up_(up) {}

void Rest::at(double, std::span<BodyState> out) const { std::copy(start_.begin(), start_.end(), out.begin()); }

void Rest::contacts(double, double dt, std::vector<ContactState>& out) const {
  for (const Bearing& bearing : bearings_) {
    const double share = bearing.resultant / length(bearing.right - bearing.left);
    for (const auto& [point, part] : {std::pair{bearing.left, 1 - share}, std::pair{bearing.right, share}}) {
      out.push_back({.a = bearing.below,
                     .b = bearing.above,
                     .point = point,
                     .normal = up_,
                     .normal_impulse = part * bearing.weight * dt});
    }
  }
}

namespace {

// One storey of the tower in the floor's frame.
struct Storey {
  std::size_t body = 0;
  double middle = 0;  // m along the floor
  double bottom = 0;  // m above it
  double width = 0, height = 0;
  double weight = 0;  // N
};

std::variant<std::vector<Storey>, std::string> storeys(const Scene& scene, std::size_t ground, const Floor& floor) {
  std::vector<Storey> tower;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (i == ground) continue;
    const Body& body = scene.bodies[i];
    const Box* box = lone<Box>(body);
    if (body.type != BodyType::dynamic || box == nullptr) return "solves boxes on fixed ground";
    if (body.velocity != Vec{} || body.angular_velocity != 0) return "solves what starts at rest";
    const std::optional<Footprint> foot = footprint(*box, body.angle, floor);
    if (!foot) return "solves boxes that lie flat";
    const Vec center = start_of(body).position;
    tower.push_back({i, dot(center, floor.along()), dot(center, floor.normal) - floor.offset - foot->height / 2,
                     foot->width, foot->height, mass_of(body).mass * length(gravity_of(scene, body))});
  }
  std::sort(tower.begin(), tower.end(), [](const Storey& a, const Storey& b) { return a.bottom < b.bottom; });
  return tower;
}

Recognised<Rest> recognise_rest(const Scene& scene) {
  if (const std::string reason = beyond_textbook(scene); !reason.empty()) return reason;
  const auto fixed = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                  [](const Body& body) { return body.type == BodyType::fixed; });
  if (fixed == scene.bodies.end()) return "solves towers on fixed ground";
  const std::optional<Floor> floor = floor_of(*fixed, scene.gravity);
  if (!floor) return "solves a floor made of one half-space or one box";
  if (std::abs(cross(scene.gravity, floor->normal)) > flat * length(scene.gravity)) return "solves a level floor";
  const auto ground = static_cast<std::size_t>(fixed - scene.bodies.begin());
  const auto found = storeys(scene, ground, *floor);
  if (const std::string* reason = std::get_if<std::string>(&found)) return *reason;
  const auto& tower = std::get<std::vector<Storey>>(found);

  // From the top down: the weight above a surface and where it acts; it stands if that is within the surface.
  std::vector<Bearing> bearings;
  double weight = 0;
  double moment = 0;
  for (std::size_t k = tower.size(); k-- > 0;) {
    const Storey& above = tower[k];
    weight += above.weight;
    moment += above.weight * above.middle;
    const double top = k == 0 ? 0 : tower[k - 1].bottom + tower[k - 1].height;
    if (std::abs(above.bottom - top) > flat) return "solves one tower, each box upon the one below";
    const double low = k == 0 ? floor->from : tower[k - 1].middle - tower[k - 1].width / 2;
    const double high = k == 0 ? floor->to : tower[k - 1].middle + tower[k - 1].width / 2;
    const double left = std::max(low, above.middle - above.width / 2);
    const double right = std::min(high, above.middle + above.width / 2);
    const double acts = moment / weight;
    if (weight <= 0 || acts < left || acts > right) return "solves what stands: this topples";
    const Vec base = (floor->offset + above.bottom) * floor->normal;
    bearings.push_back({k == 0 ? ground : tower[k - 1].body, above.body, base + left * floor->along(),
                        base + right * floor->along(), weight, acts - left});
  }
  std::reverse(bearings.begin(), bearings.end());
  return Rest(start_of(scene), std::move(bearings), floor->normal);
}

const Catalog<Engine>::Entry rest_entry{closed_form<Rest>(
    {.name = "rest",
     .about = "A tower in equilibrium: nothing moves, each surface carries the weight above it",
     .source = "Statics of rigid bodies, e.g. Meriam & Kraige, Statics, ch. 3; lever rule (Archimedes)"},
    recognise_rest)};

}  // namespace
}  // namespace plumb
