#include "race.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <ctime>
#include <exception>
#include <memory>
#include <stdexcept>

#include "reports/run/readout.h"

namespace plumb::benchmarks {
namespace {

constexpr int turns = 10;  // of each engine in a window

double wall_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Runner {
 public:
  Runner(const Start& start, const EngineConfig& config, double patience)
      : start_(start), config_(config), patience_(patience) {
    finish_.no_result = config.engine->unsupported(start.scene, config.settings);
  }

  /// Does it, unless there is no result already; whatever it throws is why there is none.
  template <class Work>
  void attempt(const Work& work) {
    if (!finish_.no_result.empty()) return;
    try {
      work();
    } catch (const std::exception& error) {
      finish_.no_result = error.what();
    }
  }

  void begin(int steps_before) {
    attempt([&] {
      simulation_ = config_.engine->build(start_.scene, config_.settings);
      spent_ = 0;
      for (int i = 0; i < steps_before; ++i) {
        const double wall = wall_now();
        simulation_->step(dt);
        spend(wall_now() - wall);
      }
      lap_ = {};
    });
  }

  void take_turn(int steps) {
    attempt([&] {
      const double wall = wall_now();
      const double cpu = cpu_now();
      for (int i = 0; i < steps; ++i) simulation_->step(dt);
      lap_.cpu += cpu_now() - cpu;
      const double passed = wall_now() - wall;
      lap_.wall += passed;
      spend(passed);
    });
  }

  void end() {
    attempt([&] {
      judge();
      finish_.laps.push_back(lap_);
    });
    simulation_ = nullptr;
  }

  Finish finish() && {
    if (!finish_.no_result.empty()) finish_.laps.clear();
    return std::move(finish_);
  }

 private:
  void spend(double seconds) {
    spent_ += seconds;
    if (spent_ > patience_) throw std::runtime_error(fmt::format("takes more than {:g} s a round", patience_));
  }

  // Most engines repeat themselves to the bit; then so does the verdict.
  void judge() {
    Readout readout(start_.scene);
    const std::span<const BodyState> states = readout.states(*simulation_);
    const bool again =
        judged_.size() == states.size() && std::memcmp(judged_.data(), states.data(), states.size_bytes()) == 0;
    if (again) return;
    judged_.assign(states.begin(), states.end());
    const Condition found = condition(start_, states);
    finish_.no_result = found.broken;
    finish_.overlap.mean = std::max(finish_.overlap.mean, found.overlap.mean);
    finish_.overlap.most = std::max(finish_.overlap.most, found.overlap.most);
  }

  const Start& start_;
  const EngineConfig& config_;
  Finish finish_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<BodyState> judged_;
  Lap lap_;
  double patience_;   // s
  double spent_ = 0;  // s of wall time, on this round's steps
};

}  // namespace

std::vector<Finish> race(const Start& start, Window window, std::span<const EngineConfig> configs, int rounds,
                         double patience) {
  std::vector<Runner> runners;
  runners.reserve(configs.size());
  for (const EngineConfig& config : configs) runners.emplace_back(start, config, patience);

  for (int round = 0; round < rounds; ++round) {
    for (Runner& runner : runners) runner.begin(window.from);
    for (int turn = 0; turn < turns; ++turn) {
      const int steps = window.steps() * (turn + 1) / turns - window.steps() * turn / turns;
      const auto first = static_cast<std::size_t>(round + turn);
      for (std::size_t i = 0; i < runners.size(); ++i) runners[(first + i) % runners.size()].take_turn(steps);
    }
    for (Runner& runner : runners) runner.end();
  }

  std::vector<Finish> finishes;
  for (Runner& runner : runners) finishes.push_back(std::move(runner).finish());
  return finishes;
}

}  // namespace plumb::benchmarks
