#include "reports/timing/side_by_side.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "reports/statistics.h"
#include "reports/timing/repetitions.h"
#include "reports/timing/worker.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

using SideJson = nlohmann::ordered_json;

constexpr const char* copy_prefix = "plumb-times-";

// A folder in use is locked by its process; one that a killed process left is not.
void remove_abandoned_copies() {
  std::error_code error;
  for (fs::directory_iterator next(fs::temp_directory_path(), error), end; !error && next != end;
       next.increment(error)) {
    if (!next->path().filename().string().starts_with(copy_prefix)) continue;
    const int folder = open(next->path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) continue;
    std::error_code ignored;
    if (flock(folder, LOCK_EX | LOCK_NB) == 0) fs::remove_all(next->path(), ignored);
    close(folder);
  }
}

// s of CPU time. A longer run is only timed up to here. A chunk is short against a time slice, so that most chunks are
// not interrupted, and long against the reading of a clock; a repetition is short against most other activity on the
// machine.
constexpr double longest_run = 0.05;
constexpr double chunk_time = 2.5e-4;
constexpr double repetition_time = 1e-3;
constexpr double round_time = 1e-2;
constexpr std::size_t fewest_repetitions = 2;
constexpr std::size_t most_repetitions = 9;

struct ChunkRange {
  std::size_t least, most;
};

std::vector<double> times_in(const SideJson& answer, const char* key, ChunkRange expected) {
  const std::vector<double> all = answer.at(key);
  const bool valid = std::all_of(all.begin(), all.end(), [](double one) { return std::isfinite(one) && one > 0; });
  if (all.size() < expected.least || all.size() > expected.most || !valid)
    throw std::runtime_error("answers with invalid times");
  return all;
}

SideJson ask(TimingWorker& worker, const SideJson& request) {
  SideJson answer = worker.ask(request);
  if (answer.contains("refused")) throw std::runtime_error(answer.at("refused").get<std::string>());
  return answer;
}

SideJson scene_request(const std::string& scene, const std::string& engine, double dt) {
  return {{"scene", scene}, {"engine", engine}, {"dt", dt}};
}

SideJson run_request(std::size_t runs, std::size_t steps, std::size_t chunk, double patience) {
  return {{"runs", runs}, {"steps", steps}, {"chunk", chunk}, {"patience", patience}};
}

// One program's side of a round.
class Side {
 public:
  Side(const fs::path& program, const SideJson& scene) : worker_(program) { ask(worker_, scene); }

  // Returns the CPU times of a run's chunks, s.
  std::vector<double> repeat(const SideJson& runs, ChunkRange chunks) {
    const SideJson answer = ask(worker_, runs);
    cpu_.push_back(times_in(answer, "cpu", chunks));
    wall_.push_back(times_in(answer, "wall", chunks));
    if (answer.at("count").is_number()) instructions_ = std::min(instructions_, answer.at("count").get<double>());
    return cpu_.back();
  }

  void add_to(StepCosts& costs, std::size_t steps) const {
    const auto n = static_cast<double>(steps);
    costs.cpu.push_back(undisturbed(cpu_) / n);
    costs.wall.push_back(undisturbed(wall_) / n);
    if (std::isfinite(instructions_)) costs.instructions.push_back(instructions_ / n);
  }

 private:
  // A run repeats the same work chunk by chunk, and disturbances only make a chunk longer. But the shortest CPU times
  // on a busy machine are sometimes too short, so the time of a chunk is its lower quartile over the repetitions.
  static double undisturbed(const std::vector<std::vector<double>>& repetitions) {
    double all = 0;
    for (std::size_t chunk = 0; chunk < repetitions[0].size(); ++chunk) {
      std::vector<double> times;
      for (const std::vector<double>& repetition : repetitions) times.push_back(repetition[chunk]);
      all += quartiles(std::move(times)).low;
    }
    return all;
  }

  TimingWorker worker_;
  std::vector<std::vector<double>> cpu_, wall_;  // s, by repetition and chunk
  double instructions_ = std::numeric_limits<double>::infinity();
};

}  // namespace

ProgramCopy::ProgramCopy(const fs::path& program) {
  remove_abandoned_copies();
  std::string name;
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(fmt::format("{} cannot be copied to {}: {}", program.string(), name, why));
  };
  // Until it is locked, another process may remove the folder as abandoned.
  while (!fs::exists(folder_)) {
    if (lock_ >= 0) close(lock_);
    name = (fs::temp_directory_path() / (std::string(copy_prefix) + "XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr) refuse(std::strerror(errno));
    folder_ = name;
    lock_ = open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    flock(lock_, LOCK_EX);
  }
  path_ = folder_ / "plumb";
  std::error_code error;
  if (fs::copy_file(program, path_, error)) return;
  remove();
  refuse(error.message());
}

ProgramCopy::~ProgramCopy() { remove(); }

void ProgramCopy::remove() const {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  close(lock_);
}

SideBySide::SideBySide(fs::path before, fs::path now, std::vector<TimedScene> scenes, std::string engine, double dt)
    : before_(std::move(before)),
      now_(std::move(now)),
      scenes_(std::move(scenes)),
      engine_(std::move(engine)),
      dt_(dt) {
  const TimingWorker a(before_);
  const TimingWorker b(now_);
  facts_before_ = a.facts();
  facts_now_ = b.facts();
  uncounted_ = a.uncounted().empty() ? b.uncounted() : a.uncounted();
}

std::vector<TimedPair> SideBySide::measure(std::span<const std::size_t> which, int rounds,
                                           const std::function<void(const std::string&)>& progress) const {
  std::vector<TimedPair> pairs;
  std::vector<Schedule> schedules(which.size());
  for (const std::size_t i : which) pairs.push_back({.name = scenes_[i].name, .of = scenes_[i].steps});
  for (int round = 0; round < rounds; ++round) {
    const Programs programs{ProgramCopy(before_), ProgramCopy(now_), ProgramCopy(before_)};
    for (std::size_t i = 0; i < which.size(); ++i) {
      if (!pairs[i].no_result.empty()) continue;
      progress(pairs[i].name);
      const TimedScene& scene = scenes_[which[i]];
      try {
        if (round == 0) schedules[i] = schedule(scene);
        time_round(programs, scene, schedules[i], static_cast<std::size_t>(round) + i, pairs[i]);
      } catch (const std::exception& error) {
        pairs[i] = {.name = scene.name, .no_result = error.what(), .of = scene.steps};
      }
    }
  }
  return pairs;
}

SideBySide::Schedule SideBySide::schedule(const TimedScene& scene) const {
  constexpr std::size_t few = 10;  // steps in a chunk
  Side side(before_, scene_request(scene.scene, engine_, dt_));
  const std::vector<double> chunks =
      side.repeat(run_request(1, scene.steps, few, longest_run), {1, (scene.steps + few - 1) / few});
  const double took = std::max(std::accumulate(chunks.begin(), chunks.end(), 0.0), 1e-7);
  const std::size_t steps = std::min(scene.steps, chunks.size() * few);
  const auto ceiling = [](double quotient) { return static_cast<std::size_t>(std::ceil(quotient)); };
  Schedule all{.repetitions = 0, .runs = ceiling(repetition_time / took), .steps = steps, .chunk = steps};
  if (took > chunk_time) all.chunk = ceiling(chunk_time * static_cast<double>(steps) / took);
  all.repetitions =
      std::clamp(ceiling(round_time / (took * static_cast<double>(all.runs))), fewest_repetitions, most_repetitions);
  return all;
}

void SideBySide::time_round(const Programs& programs, const TimedScene& scene, const Schedule& schedule,
                            std::size_t first, TimedPair& pair) const {
  const SideJson request = scene_request(scene.scene, engine_, dt_);
  std::array<Side, 3> sides{Side(programs.before.path(), request), Side(programs.now.path(), request),
                            Side(programs.again.path(), request)};
  const SideJson runs = run_request(schedule.runs, schedule.steps, schedule.chunk, std::numeric_limits<double>::max());
  const std::size_t chunks = (schedule.steps + schedule.chunk - 1) / schedule.chunk;
  for (std::size_t i = 0; i < schedule.repetitions; ++i) {
    play_round(first + i, sides.size(), [&](std::size_t side) { sides[side].repeat(runs, {chunks, chunks}); });
  }
  pair.steps = schedule.steps;
  sides[0].add_to(pair.before, schedule.steps);
  sides[1].add_to(pair.now, schedule.steps);
  sides[2].add_to(pair.again, schedule.steps);
}

}  // namespace plumb
