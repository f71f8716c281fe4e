#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::arch {
namespace {

constexpr double gravity = 10;    // m/s^2
constexpr double duration = 6;    // s; a free fall from the crown takes 1.4 s
constexpr double radius = 10;     // m, of the centreline
constexpr double friction = 0.8;  // the thrust needs 0.38, so nothing slides
constexpr int stones = 20;
constexpr double limit = 0.1074;  // t/R of 20 stones by their line of thrust; 0.1075 for many

std::string name(int k) { return "stone " + std::to_string(k); }

// Stone k of the semicircle, counted from the left springing to the right, between two radial cuts.
Body stone(int k, double thickness) {
  const auto at = [](double r, int cut) {
    const double angle = std::numbers::pi * (1 - static_cast<double>(cut) / stones);
    return Vec{r * std::cos(angle), cut % stones == 0 ? 0 : r * std::sin(angle)};
  };
  const double inner = radius - thickness / 2;
  const double outer = radius + thickness / 2;
  Polygon polygon{{at(inner, k - 1), at(outer, k - 1), at(outer, k), at(inner, k)}};
  Body body{.name = name(k), .shapes = {{.geometry = polygon, .surface = surface(friction, 0)}}};
  const Vec center = mass_of(body).center;
  for (Vec& vertex : polygon.vertices) vertex = {vertex.x - center.x, vertex.y - center.y};
  body.position = center;
  body.shapes[0].geometry = polygon;
  return body;
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "arch",
              .about = "A semicircular arch of dry stones with radial cuts.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(surface(friction, 0)));
  for (int k = 1; k <= stones; ++k) scene.bodies.push_back(stone(k, p.at("thickness") * radius));
  return scene;
}

// It stands iff some line of thrust stays within the stones: t/R >= 0.1075 (Milankovitch). One corner of
// each cut may be deeper by the slop, slop/t; such a turn at the horizontal distance x from the crown lowers it by at
// most x times that angle, and the mean of x over the semicircle is 2 R/pi. The crown rests on either half alone, so
// that only one half's cuts add up; each of them may also be off by the gap, and move the crown by as much. A crown
// that has come down by its own thickness counts as collapsed, whatever the gap. A collapse ends on the ground, far
// below half the height, whatever remains standing at the springings.
std::vector<Expectation> expectations(const Parameters& p) {
  const double thickness = p.at("thickness") * radius;
  const std::string crown = name(stones / 2);
  const auto round = [](const Stepping& s) { return round_off(s, duration, radius); };
  if (p.at("thickness") < limit) {
    return {{.body = crown,
             .quantity = Quantity::y,
             .relation = Relation::at_most,
             .expected = radius / 2,
             .allowed = round,
             .source = "collapses, as t/R < 0.1075: no line of thrust stays within"}};
  }
  const auto sag = [=](const Stepping& s) {
    const double cuts = stones / 2 + 1;
    const double turned = cuts * s.slop / thickness * (2 * radius / std::numbers::pi);
    return std::min(turned + cuts * s.contact_gap(), thickness) + round(s);
  };
  return {{.body = crown,
           .quantity = Quantity::y,
           .allowed = sag,
           .source = "stands, as t/R >= 0.1075; each cut may turn by the slop"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "arch",
     .question = "Does an arch stand if and only if its stones are thick enough to contain a line of thrust?",
     .parameters = {{.name = "thickness",
                     .value = 0.12,
                     .min = 0.05,
                     .max = 0.4,
                     .about = "of the stones, divided by the radius"}},
     .variants = {{"0.12", {}}, {"0.09", {{"thickness", 0.09}}}},
     .closed_form = "arch",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::arch
