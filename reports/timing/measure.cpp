#include "reports/timing/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "reports/statistics.h"
#include "reports/timing/pacer.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

using Json = Pacer::Json;

// s of CPU time. A run that takes longer is timed as far as it then came. A chunk is short against a time slice, so
// that most are not interrupted, and long against the reading of a clock; turns are short against what comes and goes
// on a machine.
constexpr double longest_run = 0.05;
constexpr double chunk_time = 2.5e-4;
constexpr double turn_time = 1e-3;
constexpr double sitting_time = 1e-2;
constexpr std::size_t fewest_turns = 2;
constexpr std::size_t most_turns = 9;

struct Range {
  std::size_t least, most;
};

std::vector<double> numbers(const Json& answer, const char* key, Range expected) {
  const std::vector<double> all = answer.at(key);
  const bool sane = std::all_of(all.begin(), all.end(), [](double one) { return std::isfinite(one) && one > 0; });
  if (all.size() < expected.least || all.size() > expected.most || !sane)
    throw std::runtime_error("answers with times that are none");
  return all;
}

Json turn_of(Pacer& pacer, const Json& request) {
  Json answer = pacer.ask(request);
  if (answer.contains("refused")) throw std::runtime_error(answer.at("refused").get<std::string>());
  return answer;
}

Json question(const std::string& scene, const std::string& engine, double dt) {
  return {{"scene", scene}, {"engine", engine}, {"dt", dt}};
}

Json request(std::size_t runs, std::size_t steps, std::size_t chunk, double patience) {
  return {{"runs", runs}, {"steps", steps}, {"chunk", chunk}, {"patience", patience}};
}

// One program's side of a sitting.
class Sitter {
 public:
  Sitter(const std::filesystem::path& program, const Json& question, const Pacer::Options& options = Pacer::Options{})
      : pacer_(program, options) {
    turn_of(pacer_, question);
  }

  // The CPU times of a run's chunks.
  std::vector<double> take_turn(const Json& turn, Range chunks) {
    const Json answer = turn_of(pacer_, turn);
    cpu_.push_back(numbers(answer, "cpu", chunks));
    wall_.push_back(numbers(answer, "wall", chunks));
    if (answer.at("count").is_number()) count_ = std::min(count_, answer.at("count").get<double>());
    return cpu_.back();
  }

  void add_to(Cost& cost, std::size_t steps) const {
    const auto n = static_cast<double>(steps);
    cost.cpu.push_back(undisturbed(cpu_) / n);
    cost.wall.push_back(undisturbed(wall_) / n);
    if (std::isfinite(count_)) cost.instructions.push_back(count_ / n);
  }

 private:
  // What disturbs a chunk makes it longer; but the least of a busy machine's CPU times are too short, now and then. A
  // run repeats itself chunk by chunk.
  static double undisturbed(const std::vector<std::vector<double>>& turns) {
    double all = 0;
    for (std::size_t chunk = 0; chunk < turns[0].size(); ++chunk) {
      std::vector<double> times;
      for (const std::vector<double>& turn : turns) times.push_back(turn[chunk]);
      all += quartiles(std::move(times)).low;
    }
    return all;
  }

  Pacer pacer_;
  std::vector<std::vector<double>> cpu_, wall_;  // s, by turn and chunk
  double count_ = std::numeric_limits<double>::infinity();
};

std::string name_of(const Case& asked) {
  return asked.variant.empty() ? asked.scenario->name : asked.scenario->name + ":" + asked.variant;
}

}  // namespace

SideBySide::SideBySide(std::filesystem::path before, std::filesystem::path now, const std::vector<Case>& cases,
                       std::string engine, double dt)
    : before_(std::move(before)), now_(std::move(now)), engine_(std::move(engine)), dt_(dt) {
  for (const Case& one : cases) {
    cases_.push_back({name_of(one), write_scene({*one.scene, {}}), steps_in(one.scene->duration, dt)});
  }
  const Pacer a(before_);
  const Pacer b(now_);
  facts_before_ = a.facts();
  facts_now_ = b.facts();
  uncounted_ = a.uncounted().empty() ? b.uncounted() : a.uncounted();
}

std::vector<std::size_t> SideBySide::all() const {
  std::vector<std::size_t> which(cases_.size());
  std::iota(which.begin(), which.end(), 0U);
  return which;
}

SideBySide::Turns SideBySide::plan(const Asked& asked) const {
  constexpr std::size_t few = 10;  // steps at a time
  Sitter sitter(before_, question(asked.scene, engine_, dt_));
  const std::vector<double> tried =
      sitter.take_turn(request(1, asked.steps, few, longest_run), {1, (asked.steps + few - 1) / few});
  const double took = std::max(std::accumulate(tried.begin(), tried.end(), 0.0), 1e-7);
  const std::size_t steps = std::min(asked.steps, tried.size() * few);
  const auto times = [](double time, double of) { return static_cast<std::size_t>(std::ceil(time / of)); };
  Turns all{.turns = 0, .runs = times(turn_time, took), .steps = steps, .chunk = steps};
  if (took > chunk_time) all.chunk = times(chunk_time * static_cast<double>(steps), took);
  all.turns = std::clamp(times(sitting_time, took * static_cast<double>(all.runs)), fewest_turns, most_turns);
  return all;
}

std::vector<TimedPair> SideBySide::measure(std::span<const std::size_t> which, int sittings,
                                           const std::function<void(const std::string&)>& progress) const {
  std::vector<TimedPair> pairs;
  std::vector<Turns> turns(which.size());
  for (const std::size_t i : which) pairs.push_back({.name = cases_[i].name, .of = cases_[i].steps});
  for (int sitting = 0; sitting < sittings; ++sitting) {
    const Programs programs{ProgramCopy(before_), ProgramCopy(now_), ProgramCopy(before_)};
    for (std::size_t i = 0; i < which.size(); ++i) {
      if (!pairs[i].no_result.empty()) continue;
      progress(pairs[i].name);
      const Asked& asked = cases_[which[i]];
      try {
        if (sitting == 0) turns[i] = plan(asked);
        sit(programs, asked, turns[i], static_cast<std::size_t>(sitting) + i, pairs[i]);
      } catch (const std::exception& error) {
        pairs[i] = {.name = asked.name, .no_result = error.what(), .of = asked.steps};
      }
    }
  }
  return pairs;
}

void SideBySide::sit(const Programs& programs, const Asked& asked, const Turns& turns, std::size_t first,
                     TimedPair& pair) const {
  const Json about = question(asked.scene, engine_, dt_);
  std::array<Sitter, 3> sitters{Sitter(programs.before.path(), about), Sitter(programs.now.path(), about),
                                Sitter(programs.again.path(), about)};
  const Json turn = request(turns.runs, turns.steps, turns.chunk, std::numeric_limits<double>::max());
  const std::size_t chunks = (turns.steps + turns.chunk - 1) / turns.chunk;
  for (std::size_t i = 0; i < turns.turns * sitters.size(); ++i) {
    sitters[(first + i / sitters.size() + i) % sitters.size()].take_turn(turn, {chunks, chunks});
  }
  pair.steps = turns.steps;
  sitters[0].add_to(pair.before, turns.steps);
  sitters[1].add_to(pair.now, turns.steps);
  sitters[2].add_to(pair.again, turns.steps);
}

}  // namespace plumb
