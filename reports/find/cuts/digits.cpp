#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <variant>

#include "reports/find/shrink.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene_json.h"
#include "scenarios/scene/vec.h"

namespace plumb::cuts::digits {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  constexpr double least[] = {1, 10, 100};  // with that many digits
  double scale = 1;
  while (std::abs(value) * scale < least[digits - 1]) scale *= 10;
  return std::round(value * scale) / scale;
}

// Rounds all numbers to so many digits; whole numbers stay.
void round_all(Json& json, int digits) {
  if (json.is_number_float()) json = rounded(json.get<double>(), digits);
  if (!json.is_structured()) return;
  for (Json& one : json) round_all(one, digits);
}

// Unit vectors are left: rounded, they no longer are.
void round_body(Json& body, int digits) {
  for (const char* key : {"position", "angle", "velocity", "angularVelocity", "gravityScale", "linearDamping"}) {
    if (body.contains(key)) round_all(body[key], digits);
  }
  for (Json& shape : body["shapes"]) {
    const Json normal = shape.value("normal", Json());
    round_all(shape, digits);
    if (!normal.is_null()) shape["normal"] = normal;
  }
}

// A rigid joint between two anchors is as long as they are apart.
void fit_rods(Scene& scene) {
  for (Joint& joint : scene.joints) {
    auto* rod = std::get_if<Distance>(&joint);
    if (rod != nullptr && rod->stiffness == 0) rod->length = length(rod->anchor_b - rod->anchor_a);
  }
}

void add(const Json& json, std::vector<Scene>& into) {
  try {
    into.push_back(read_scene(json.dump(), "a simpler scene").scene);
    fit_rods(into.back());
  } catch (const std::invalid_argument&) {
    // Rounding can make a polygon concave, for example.
  }
}

std::vector<Scene> rounder(const Scene& scene, const Complaint&) {
  std::vector<Scene> all;
  const Json text = Json::parse(write_scene({.scene = scene, .truth = {}}));
  for (const int digits : {1, 2, 3}) {
    Json whole = text;
    for (Json& body : whole["bodies"]) round_body(body, digits);
    for (const char* key : {"gravity", "joints", "forces"}) {
      if (whole.contains(key)) round_all(whole[key], digits);
    }
    add(whole, all);
    for (std::size_t i = 0; i < text["bodies"].size() && text["bodies"].size() > 1; ++i) {
      Json one = text;
      round_body(one["bodies"][i], digits);
      add(one, all);
    }
  }
  return all;
}

const Catalog<Cut>::Entry entry{{.name = "fewer digits", .order = 7, .simpler = rounder}};

}  // namespace
}  // namespace plumb::cuts::digits
