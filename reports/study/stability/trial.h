#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/run/run.h"
#include "reports/study/stability/fate.h"

namespace plumb {

/// What a watch is shown of a run.
struct Moment {
  double time = 0;  // s
  std::span<const BodyState> states;
  bool last = false;
};

/// What went wrong: how, and with which body; nothing for the whole scene.
struct Symptom {
  Fate fate;
  std::optional<std::size_t> body;
};

/// Looks at every moment of one run for one kind of failure.
struct Watch {
  std::string metric;  // what counts as failing, with its numbers
  std::function<std::optional<Symptom>(const Moment&)> look;
};

/// One run that may fail.
struct Trial {
  std::shared_ptr<const Scene> scene;
  double dt = 0;
  double first_step = 1;       // its length in dt
  std::vector<Watch> watches;  // the first that sees something ends the run
};

/// Runs it.
Seen see(const Trial&, const EngineConfig&);

/// A scene of the catalogue. Throws std::logic_error where there is no such scenario.
Scene scene_of(const char* scenario, const Parameters& changes);

}  // namespace plumb
