#pragma once

#include <memory>
#include <string>

#include "reference/faults/fault.h"

/// Null engines: each lacks a whole law of mechanics, or only shows what another one did. No harness may call one right
/// where that law matters; `plumb prove --controls` measures by them which verdicts mean something. They are no engines
/// to choose from.
namespace plumb {

struct Control {
  std::string name;
  std::string about;      // one line: what it does instead of mechanics
  BuildSimulation build;  // given the complete settings of our engine
};

/// The engine that runs a control. It has our engine's settings, and states the same errors.
Engine engine_of(const Control&);

/// Our engine in a scene that was altered first.
Control in_altered_scene(std::string name, std::string about, void (*alter)(Scene&));

/// A class of its own, made from the scene and the settings of our engine.
template <class Made>
Control simulated_by(const std::string& name, const std::string& about) {
  return {.name = name, .about = about, .build = [](const Scene& scene, const Settings& settings) {
            return std::make_unique<Made>(scene, settings);
          }};
}

}  // namespace plumb
