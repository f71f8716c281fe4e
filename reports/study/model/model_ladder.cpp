#include "reports/study/model/model_ladder.h"

namespace plumb {

const std::vector<Feature>& model_features() {
  static const std::vector<Feature> features{
      {"contacts", {{"any contact", {{"contacts", "off"}}}}},
      {"method",
       {{"impacts at their own times, loads without sinking", {{"solver", "soft-step"}}},
        {"those, and contacts in sub-steps", {{"solver", "sequential-impulse"}, {"integrator", "velocity-verlet"}}},
        {"those, and position correction",
         {{"solver", "split-impulse"}, {"integrator", "velocity-verlet"}, {"position-iterations", "0"}}},
        {"sub-steps and warm starting", {{"solver", "article"}, {"integrator", "velocity-verlet"}}},
        {"those, and second order in flight", {{"solver", "article"}, {"integrator", "symplectic-euler"}}}}},
      {"sub-steps", {{"half of them", {{"substeps", "2"}}}, {"any", {{"substeps", "1"}}}}},
      {"iterations", {{"most", {{"iterations", "4"}}}, {"all but one", {{"iterations", "1"}}}}},
      {"restitution", {{"any rebound", {{"restitution", "off"}}}}},
      {"friction", {{"more grip while sticking", {{"friction", "dynamic"}}}, {"any friction", {{"friction", "off"}}}}},
      {"rotation", {{"any turning", {{"rotation", "off"}}}}},
      {"continuous collision", {{"it", {{"continuous", "off"}}}}},
      {"broad phase",
       {{"any: all pairs", {{"broad-phase", "brute"}}},
        {"a choice: a grid", {{"broad-phase", "grid"}}},
        {"a choice: a tree", {{"broad-phase", "tree"}}}}},
      {"wakefulness", {{"solving what rests", {{"sleeping", "on"}}}}},
      {"double precision", {{"it", {{"precision", "float"}}}}},
  };
  return features;
}

EngineConfig model_at(const EngineConfig& full, const Levels& levels) {
  const std::vector<Feature>& features = model_features();
  EngineConfig model = full;
  for (std::size_t f = 0; f < features.size(); ++f) {
    if (levels[f] == 0) continue;
    for (const auto& [key, value] : features[f].rungs[levels[f] - 1].change) model.settings[key] = value;
  }
  model.settings = complete(*full.engine, model.settings);
  return model;
}

std::vector<Drop> single_drops(const EngineConfig& full) {
  const std::vector<Feature>& features = model_features();
  std::vector<Drop> drops;
  for (std::size_t f = 0; f < features.size(); ++f) {
    for (std::size_t rung = 1; rung <= features[f].rungs.size(); ++rung) {
      Levels levels(features.size(), 0);
      levels[f] = rung;
      if (model_at(full, levels).settings == full.settings) continue;
      std::string setting;
      for (const auto& [key, value] : features[f].rungs[rung - 1].change)
        setting += (setting.empty() ? "" : ",") + key + "=" + value;
      drops.push_back({f, rung, setting});
    }
  }
  return drops;
}

}  // namespace plumb
