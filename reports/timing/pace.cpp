#include "reports/timing/pace.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <exception>
#include <istream>
#include <limits>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reports/run/selection.h"
#include "reports/statistics.h"
#include "reports/timing/counter.h"
#include "reports/timing/machine.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

double wall_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Of all threads: work counts wherever it is done, and what others on the machine do hardly shows.
double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Turn {
  std::size_t runs, steps, chunk;
  double patience;  // s
};

struct Times {
  std::vector<double> cpu, wall;  // s, by chunk
  std::optional<double> count;    // of instructions
};

// Of several runs, each chunk's.
std::vector<double> medians(std::span<const Times> runs, std::vector<double> Times::*what) {
  std::vector<double> all;
  for (std::size_t chunk = 0; chunk < (runs[0].*what).size(); ++chunk) {
    std::vector<double> times;
    for (const Times& run : runs) times.push_back((run.*what)[chunk]);
    all.push_back(quartiles(std::move(times)).median);
  }
  return all;
}

class PaceServer {
 public:
  const std::string& uncounted() const { return counter_.missing(); }

  Json answer(const Json& request) {
    if (!request.contains("scene")) return times_of(request);
    scene_ = nullptr;
    auto scene = std::make_unique<const Scene>(read_scene(request.at("scene").get<std::string>(), "scene").scene);
    config_ = parse_engine(request.at("engine").get<std::string>());
    dt_ = request.at("dt");
    const std::string refused = config_.engine->unsupported(*scene, config_.settings);
    if (!refused.empty()) return {{"refused", refused}};
    scene_ = std::move(scene);
    return Json::object();
  }

 private:
  Json times_of(const Json& request) const {
    if (scene_ == nullptr) throw std::invalid_argument("nothing to step");
    Turn turn{request.at("runs"), request.at("steps"), request.at("chunk"), request.at("patience")};
    if (turn.runs == 0 || turn.steps == 0 || turn.chunk == 0) throw std::invalid_argument("a turn of no steps");
    std::vector<Times> runs{run(turn)};
    turn.steps = std::min(turn.steps, runs[0].cpu.size() * turn.chunk);
    turn.patience = std::numeric_limits<double>::infinity();
    while (runs.size() < turn.runs) runs.push_back(run(turn));
    return {{"cpu", medians(runs, &Times::cpu)},
            {"wall", medians(runs, &Times::wall)},
            {"count", runs.back().count ? Json(*runs.back().count) : Json(nullptr)}};
  }

  Times run(const Turn& turn) const {
    const auto simulation = config_.engine->build(*scene_, config_.settings);
    Times times;
    double spent = 0;
    const std::optional<double> count = counter_.count();
    for (std::size_t step = 0; step < turn.steps && spent < turn.patience;) {
      const std::size_t end = std::min(turn.steps, step + turn.chunk);
      const double wall = wall_now();
      const double cpu = cpu_now();
      for (; step < end; ++step) simulation->step(dt_);
      times.cpu.push_back(cpu_now() - cpu);
      times.wall.push_back(wall_now() - wall);
      spent += times.cpu.back();
    }
    if (count) times.count = counter_.count().value_or(*count) - *count;
    return times;
  }

  InstructionCounter counter_;
  std::unique_ptr<const Scene> scene_;
  EngineConfig config_;
  double dt_ = 0;
};

}  // namespace

void pace(std::istream& in, std::ostream& out) {
  PaceServer server;
  out << Json{{"pace", pace_version}, {"facts", timing_facts()}, {"uncounted", server.uncounted()}}.dump() << std::endl;
  for (std::string line; std::getline(in, line);) {
    Json answer;
    try {
      answer = server.answer(Json::parse(line));
    } catch (const std::exception& error) {
      answer = {{"refused", error.what()}};
    }
    out << answer.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
  }
}

}  // namespace plumb
