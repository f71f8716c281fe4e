// Our own engine, on the same terms as the others: public headers only, its own defaults.
//
// What each of its methods does differently it states (impulse::stated_errors); what the default one does besides, by
// engine/accurate.md, is in its caveats. This file only chooses the model and the precision; the rest is in
// impulse_world.cpp, which is compiled once for each precision.

#include <algorithm>
#include <iterator>

#include "reference/adapters/impulse_world.h"
#include "reference/reduced_model.h"

namespace plumb {
namespace {

const Engine& self() { return *Catalog<Engine>::find("impulse"); }

ImpulseEngine in_precision_of(const Settings& settings) {
  return settings.at("precision") == "float" ? single_precision::impulse_engine() : double_precision::impulse_engine();
}

// The redundant features of the scene, except those whose option is not at its default.
std::vector<Choice> choices_of(const Scene& scene, const Settings& given) {
  const Settings settings = complete(self(), given);
  if (settings.at("model") != "auto") return {};
  const Settings defaults = complete(self(), {});
  std::vector<Choice> choices = redundant_features(scene);
  std::erase_if(choices, [&](const Choice& one) { return settings.at(one.option) != defaults.at(one.option); });
  return choices;
}

Settings chosen_for(const Scene& scene, const Settings& given) {
  Settings settings = complete(self(), given);
  for (const Choice& choice : choices_of(scene, settings)) settings[choice.option] = choice.value;
  return settings;
}

std::vector<Option> all_options() {
  std::vector<Option> options{
      {.key = "model",
       .value = "given",
       .choices =
           {{"given", "what the other options say"},
            {"auto",
             "leaves out features that provably do not change the motion in this scene; options that are set stay"}},
       .about = "which features are modelled"}};
  std::ranges::move(reductions(), std::back_inserter(options));
  std::ranges::move(double_precision::impulse_engine().options(), std::back_inserter(options));
  options.push_back({.key = "precision",
                     .value = "double",
                     .choices = {{"float", "single precision, as games run it"}, {"double", "double precision"}},
                     .about = "arithmetic"});
  return options;
}

// Every solver with the option that makes it more accurate: sub-steps if it splits the step, else iterations. And every
// integrator with the solver that leaves its free motion alone, so that only its own error shows.
std::vector<WorkLadder> ladders_of(const Engine& engine) {
  const std::string exact = "exact";  // has no option that makes it more accurate
  const auto stepping_with = [&](const Settings& settings) {
    return double_precision::impulse_engine().stepping(complete(engine, settings), 1);
  };
  std::vector<WorkLadder> ladders;
  for (const Option& option : engine.options) {
    for (const auto& [choice, about] : option.choices) {
      if (choice == "accurate-scalar") continue;  // the test oracle of "accurate", not a method of its own
      const Settings method = choice == option.value ? Settings{} : Settings{{option.key, choice}};
      if (option.key == "solver") {
        if (choice == exact) {
          ladders.push_back({method, "", {}});
          continue;
        }
        const bool splits = stepping_with({{"solver", choice}, {"substeps", "2"}}).h < 1;
        ladders.push_back(
            {method, splits ? "substeps" : "iterations",
             splits ? std::vector<std::string>{"1", "2", "4", "8"} : std::vector<std::string>{"5", "10", "20"}});
      } else if (option.key == "integrator" && choice != option.value) {
        ladders.push_back({{{"solver", exact}, {"integrator", choice}}, "", {}});
      }
    }
  }
  return ladders;
}

Engine impulse() {
  Engine engine;
  engine.name = "impulse";
  engine.about = "our own engine";
  engine.source = "this repository, engine/";
  engine.caveats = {
      "large islands at rest and those with joints are swept, not solved: a body on one a thousand times lighter sinks "
      "in by millimetres",
      "in piles, the order in which bodies are listed decides between equal impulses",
      "contacts of jointed bodies that cannot move may overlap by up to 3 mm",
      "heaps of a hundred bodies and more overlap by millimetres, of 200 by centimetres, as they fall"};
  engine.options = all_options();
  engine.also = {{{"solver", "article"}}};
  engine.ladders = ladders_of(engine);
  engine.stepping = [](const Settings& given, double dt) {
    const Settings settings = complete(self(), given);
    return in_precision_of(settings).stepping(settings, dt);
  };
  engine.unsupported = [](const Scene& scene, const Settings& given) {
    const Settings settings = chosen_for(scene, given);
    return in_precision_of(settings).unsupported(reduced(scene, settings), settings);
  };
  engine.build = [](const Scene& scene, const Settings& given) {
    const Settings settings = chosen_for(scene, given);
    return in_precision_of(settings).build(reduced(scene, settings), settings);
  };
  engine.chooses = choices_of;
  engine.in_process = true;
  return engine;
}

const Catalog<Engine>::Entry entry{impulse};

}  // namespace
}  // namespace plumb
