#include "window_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <stdexcept>
#include <utility>

#include "reports/run/run.h"
#include "reports/timing/repetitions.h"

namespace plumb::benchmarks {
namespace {

constexpr int slices = 10;  // of a window

// One engine that takes part.
class EngineRunner {
 public:
  EngineRunner(const SceneSetup& setup, const EngineConfig& config, double patience)
      : setup_(setup), config_(config), patience_(patience) {
    times_.no_result = config.engine->unsupported(setup.scene, config.settings);
  }

  void begin_round(int steps_before) {
    attempt([&] {
      simulation_ = config_.engine->build(setup_.scene, config_.settings);
      spent_ = 0;
      for (int i = 0; i < steps_before; ++i) spend(time_steps(*simulation_, dt, 1, CpuClock::none).wall);
      round_ = {};
    });
  }

  void run_slice(int steps) {
    attempt([&] {
      const Elapsed slice = time_steps(*simulation_, dt, static_cast<std::size_t>(steps), CpuClock::thread);
      round_.cpu += slice.cpu;
      round_.wall += slice.wall;
      spend(slice.wall);
    });
  }

  void end_round() {
    attempt([&] {
      check();
      times_.rounds.push_back(round_);
    });
    simulation_ = nullptr;
  }

  EngineTimes times() && {
    if (!times_.no_result.empty()) times_.rounds.clear();
    return std::move(times_);
  }

 private:
  // Does nothing once there is no result. What the work throws is the reason for having none.
  template <class Work>
  void attempt(const Work& work) {
    if (!times_.no_result.empty()) return;
    try {
      work();
    } catch (const std::exception& error) {
      times_.no_result = error.what();
    }
  }

  void spend(double seconds) {
    spent_ += seconds;
    if (spent_ > patience_) throw std::runtime_error(fmt::format("takes more than {:g} s a round", patience_));
  }

  // Most engines give the same bits in every round, which need only be checked once.
  void check() {
    Readout readout(setup_.scene);
    const std::span<const BodyState> states = readout.states(*simulation_);
    const bool same =
        checked_.size() == states.size() && std::memcmp(checked_.data(), states.data(), states.size_bytes()) == 0;
    if (same) return;
    checked_.assign(states.begin(), states.end());
    const SceneCheck found = check_scene(setup_, states);
    times_.no_result = found.broken;
    times_.overlap.mean = std::max(times_.overlap.mean, found.overlap.mean);
    times_.overlap.most = std::max(times_.overlap.most, found.overlap.most);
  }

  const SceneSetup& setup_;
  const EngineConfig& config_;
  EngineTimes times_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<BodyState> checked_;
  Elapsed round_;
  double patience_;   // s
  double spent_ = 0;  // s of wall time, on the steps of this round
};

}  // namespace

std::vector<EngineTimes> time_window(const SceneSetup& setup, StepWindow window, std::span<const EngineConfig> configs,
                                     int rounds, double patience) {
  std::vector<EngineRunner> runners;
  runners.reserve(configs.size());
  for (const EngineConfig& config : configs) runners.emplace_back(setup, config, patience);

  for (int round = 0; round < rounds; ++round) {
    for (EngineRunner& runner : runners) runner.begin_round(window.from);
    for (int slice = 0; slice < slices; ++slice) {
      const int steps = window.steps() * (slice + 1) / slices - window.steps() * slice / slices;
      play_round(static_cast<std::size_t>(round + slice), runners.size(),
                 [&](std::size_t i) { runners[i].run_slice(steps); });
    }
    for (EngineRunner& runner : runners) runner.end_round();
  }

  std::vector<EngineTimes> all;
  for (EngineRunner& runner : runners) all.push_back(std::move(runner).times());
  return all;
}

}  // namespace plumb::benchmarks
