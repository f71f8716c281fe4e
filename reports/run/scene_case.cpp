#include "reports/run/scene_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "reports/judge/conserved.h"
#include "reports/judge/observe.h"
#include "reports/judge/truth.h"
#include "reports/system/files.h"

namespace plumb {
namespace {

std::vector<Expectation> expectations_of(const std::vector<StatedTruth>& truths) {
  std::vector<Expectation> all;
  all.reserve(truths.size());
  for (const StatedTruth& truth : truths) {
    all.push_back({.body = truth.body,
                   .quantity = truth.quantity,
                   .time = truth.time,
                   .expected = truth.value,
                   .within = truth.tolerance,
                   .source = truth.source});
  }
  return all;
}

std::optional<double> expected_by(const Case& asked, const Expectation& expectation) {
  if (expectation.expected || asked.closed_form == nullptr) return expectation.expected;
  const Scene& scene = *asked.scene;
  const auto states = Truth(*asked.closed_form, scene).at(expectation.time.value_or(scene.duration));
  if (!states) return std::nullopt;
  const std::size_t body = expectation.body.empty() ? 0 : index_of(scene, expectation.body);
  return quantity_of(expectation.quantity, body, Conserved(scene), *states);
}

}  // namespace

bool means_file(std::string_view word) {
  std::error_code ignored;
  return word.ends_with(".json") ||
         (word.find('/') != word.npos && std::filesystem::exists(std::filesystem::path(word), ignored));
}

const Engine* witness_of(const Scene& scene) {
  const Engine* longest = nullptr;
  double until = 0;
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (!engine->exact || !engine->unsupported(scene, complete(*engine, {})).empty()) continue;
    const double holds = std::min(Truth(*engine, scene).until(), scene.duration);
    if (longest != nullptr && holds <= until) continue;
    longest = engine;
    until = holds;
  }
  return longest;
}

Case case_of_file(const std::string& path) {
  SceneFile file = read_scene(read_text(path, largest_scene_file), path);
  const auto scene = std::make_shared<const Scene>(std::move(file.scene));
  const Engine* witness = witness_of(*scene);
  const auto scenario = std::make_shared<const Scenario>(
      Scenario{.name = scene->name,
               .question = scene->about,
               .variants = {{.label = path}},
               .closed_form = witness == nullptr ? "" : witness->name,
               .scene = [scene](const Parameters&) { return *scene; },
               .expectations = [all = expectations_of(file.truth)](const Parameters&) { return all; }});
  return {.scenario = scenario.get(), .variant = path, .scene = scene, .closed_form = witness, .from_file = scenario};
}

Stepping reference_stepping() {
  constexpr double dt = 1.0 / 60;
  return {.dt = dt, .h = dt, .drift = 0.5, .impact_lag = 1, .gap = 0.01, .epsilon = 0x1p-24};
}

StatedTruths truths_of(const Case& asked) {
  StatedTruths stated;
  for (const Expectation& expectation : asked.scenario->expectations(asked.parameters)) {
    const std::string what = (expectation.body.empty() ? "" : expectation.body + " ") + name_of(expectation.quantity);
    const std::string source = expectation.source + "; allowed to symplectic Euler, 1/60 s, gap 0.01 m, float";
    if (expectation.quantity == Quantity::apex) {
      stated.left_out.push_back(
          fmt::format("{} {}: a scene file asks at a time, not at an apex", what, expectation.index));
      continue;
    }
    const bool of_a_moment = expectation.quantity < Quantity::speed_spread && expectation.over == 0;
    if (!of_a_moment || expectation.relation != Relation::equal) {
      stated.left_out.push_back(what +
                                ": a scene file asks for a body's or the scene's value at a time, not for bounds");
      continue;
    }
    const auto value = expected_by(asked, expectation);
    const double tolerance = expectation.within ? *expectation.within : expectation.allowed(reference_stepping());
    if (!value || !std::isfinite(*value)) {
      stated.left_out.push_back(what + ": the closed form does not reach that far");
    } else if (!std::isfinite(tolerance)) {
      stated.left_out.push_back(what + ": no tolerance holds for a first-order method at 1/60 s");
    } else {
      stated.truth.push_back({expectation.body, expectation.quantity, expectation.time, *value, tolerance, source});
    }
  }
  return stated;
}

}  // namespace plumb
