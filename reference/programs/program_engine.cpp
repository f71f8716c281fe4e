#include "reference/programs/program_engine.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reference/programs/line_process.h"
#include "reference/programs/protocol.h"

namespace plumb {
namespace {

using protocol::Answer;
using protocol::Identity;

std::vector<Option> with_limits(std::vector<Option> options) {
  const ProgramLimits usual;
  options.push_back({.key = "timeout",
                     .value = fmt::format("{}", usual.seconds),
                     .about = "s without an answer after which the program is ended",
                     .min = 0.01,
                     .max = 1e6});
  options.push_back({.key = "memory",
                     .value = fmt::format("{}", usual.mebibytes),
                     .about = "MiB of memory beyond which the program is ended",
                     .min = 1,
                     .max = 1e6});
  return options;
}

ProgramLimits limits_of(const Settings& settings) {
  return {.seconds = std::stod(settings.at("timeout")), .mebibytes = std::stod(settings.at("memory"))};
}

// The program's own options: the limits are Plumb's.
Settings without_limits(Settings settings) {
  settings.erase("timeout");
  settings.erase("memory");
  return settings;
}

// Asks and reads one answer by `read`, which may refuse it.
template <class Read>
auto ask(LineProcess& process, const std::string& line, const ProgramLimits& limits, const Read& read) {
  process.send(line, limits);
  const std::string_view answer = process.receive(limits);
  try {
    return read(answer);
  } catch (const std::invalid_argument& error) {
    throw process.failure(error.what());
  }
}

// The processes of a program that no simulation uses. A process belongs to the one that started it: after a fork the
// child starts its own.
class Program {
 public:
  explicit Program(std::string command) : command_(std::move(command)) {}

  std::unique_ptr<LineProcess> take() {
    const std::lock_guard lock(mutex_);
    forget_those_of_a_parent();
    if (idle_.empty()) return std::make_unique<LineProcess>(command_);
    auto process = std::move(idle_.back());
    idle_.pop_back();
    return process;
  }

  void give_back(std::unique_ptr<LineProcess> process) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(process));
  }

  // What it states, or fails to, which is asked for once.
  Stepping stepping(const Settings& settings, const ProgramLimits& limits, double dt) {
    const std::lock_guard lock(mutex_);
    const auto [place, is_new] = stated_.try_emplace({settings, dt});
    Stated& stated = place->second;
    if (is_new) {
      forget_those_of_a_parent();
      try {
        if (idle_.empty()) idle_.push_back(std::make_unique<LineProcess>(command_));
        stated.stepping = ask(*idle_.back(), protocol::ask_stepping(settings, dt), limits,
                              [&](std::string_view answer) { return protocol::read_stepping(answer, dt); });
      } catch (const std::exception& error) {
        stated.failure = error.what();
        idle_.clear();
      }
    }
    if (!stated.failure.empty()) throw std::runtime_error("asked how it steps, " + stated.failure);
    return stated.stepping;
  }

 private:
  struct Stated {
    Stepping stepping;
    std::string failure;
  };

  void forget_those_of_a_parent() {
    if (owner_ == getpid()) return;
    for (auto& process : idle_) [[maybe_unused]] const LineProcess* left = process.release();
    idle_.clear();
    owner_ = getpid();
  }

  std::string command_;
  std::mutex mutex_;
  pid_t owner_ = getpid();
  std::vector<std::unique_ptr<LineProcess>> idle_;
  std::map<std::pair<Settings, double>, Stated> stated_;
};

class ProgramSimulation : public Simulation {
 public:
  ProgramSimulation(Program& program, const Scene& scene, const Settings& settings, const ProgramLimits& limits)
      : program_(program), process_(program.take()), limits_(limits), bodies_(scene.bodies.size()) {
    now_ = ask(*process_, protocol::ask_build(scene, settings), limits_,
               [&](std::string_view answer) { return protocol::read_build(answer, bodies_); });
    if (!now_.refusal.empty()) {
      program_.give_back(std::move(process_));
      throw std::domain_error(now_.refusal);
    }
  }
  ~ProgramSimulation() override {
    if (process_ && asked_ == 0 && !failed_) program_.give_back(std::move(process_));
  }

  void announce(double dt, std::size_t steps) override {
    announced_ = dt;
    ahead_ = steps;
  }

  void step(double dt) override {
    if (asked_ == 0) ask_for_steps(dt);
    if (dt != asked_dt_) throw std::logic_error("a simulation was announced steps of another length");
    failed_ = true;
    const std::string_view answer = process_->receive(limits_);
    try {
      now_ = protocol::read_step(answer, bodies_, ++steps_);
    } catch (const std::invalid_argument& error) {
      throw process_->failure(error.what());
    }
    --asked_;
    stepped_ += now_.seconds;
    const double passed = std::chrono::duration<double>(Clock::now() - asked_at_).count();
    check_clock(passed);
    if (asked_ == 0) at_once_.took(asked_for_, passed);
    failed_ = false;
  }

  void read(std::span<BodyState> out) const override { std::copy(now_.states.begin(), now_.states.end(), out.begin()); }
  void read_contacts(std::vector<ContactState>& out) const override {
    out.insert(out.end(), now_.contacts.begin(), now_.contacts.end());
  }
  std::optional<double> seconds_stepped() const override { return stepped_; }

 private:
  using Clock = std::chrono::steady_clock;

  void ask_for_steps(double dt) {
    asked_ = dt == announced_ ? std::clamp<std::size_t>(ahead_, 1, at_once_.count()) : 1;
    asked_for_ = asked_;
    ahead_ -= std::min(ahead_, asked_);
    asked_dt_ = dt;
    asked_at_ = Clock::now();
    stepped_before_ = stepped_;
    process_->send(protocol::ask_steps(asked_, dt), limits_);
  }

  // A program is believed how long it took, up to the time that went by.
  void check_clock(double passed) const {
    if (stepped_ - stepped_before_ <= passed) return;
    throw process_->failure(fmt::format("it says that its steps took {:.3g} s, but only {:.3g} s went by",
                                        stepped_ - stepped_before_, passed));
  }

  Program& program_;
  std::unique_ptr<LineProcess> process_;
  ProgramLimits limits_;
  std::size_t bodies_;
  std::size_t steps_ = 0;  // since the build
  Answer now_;
  double announced_ = 0;   // s, the length of steps to come
  std::size_t ahead_ = 0;  // of them, not yet asked for
  protocol::StepsAhead at_once_;
  std::size_t asked_for_ = 0;
  std::size_t asked_ = 0;  // of them, not yet answered
  double asked_dt_ = 0;
  Clock::time_point asked_at_;
  double stepped_ = 0, stepped_before_ = 0;  // s, by the program's clock: all, and before the last ask
  bool failed_ = false;
};

std::string only_build_knows(const Scene&, const Settings&) { return ""; }

std::string this_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

// All programs named so far. They live as long as we do: engines refer to them.
class Programs {
 public:
  const Engine& of(const std::string& command, const std::string& word) {
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_) {
      if (entry.command == command) return entry.engine;
    }
    Entry& entry = entries_.emplace_back(command);
    try {
      entry.engine = made(entry.program, word);
    } catch (...) {
      entries_.pop_back();
      throw;
    }
    return entry.engine;
  }

  const Engine& isolated(const Engine& engine) {
    const std::string command = fmt::format("{} engine serve {}", quoted_for_shell(this_program()), engine.name);
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : isolated_) {
      if (entry.command == command) return entry.engine;
    }
    Entry& entry = isolated_.emplace_back(command);
    entry.engine = engine;
    static constexpr ProgramLimits limits{.seconds = 60};
    entry.engine.stepping = [&program = entry.program, &engine](const Settings& settings, double dt) {
      return program.stepping(complete(engine, settings), limits, dt);
    };
    entry.engine.unsupported = only_build_knows;
    entry.engine.build = [&program = entry.program, &engine](const Scene& scene, const Settings& settings) {
      return std::make_unique<ProgramSimulation>(program, scene, complete(engine, settings), limits);
    };
    entry.engine.chooses = nullptr;
    entry.engine.in_process = true;
    return entry.engine;
  }

  const Engine* find(std::string_view name) {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(entries_, name, [](const Entry& entry) { return entry.engine.name; });
    return found == entries_.end() ? nullptr : &found->engine;
  }

 private:
  struct Entry {
    explicit Entry(std::string line) : command(std::move(line)), program(command) {}
    std::string command;
    Program program;
    Engine engine;
  };

  bool is_taken(const std::string& name) const {
    return Catalog<Engine>::find(name) != nullptr ||
           std::ranges::any_of(entries_, [&](const Entry& entry) { return entry.engine.name == name; });
  }

  std::string free_name(const Identity& identity) const {
    if (!is_taken(identity.name)) return identity.name;
    const std::string versioned = identity.name + '@' + identity.version;
    std::string name = versioned;
    for (int i = 2; is_taken(name); ++i) name = fmt::format("{}#{}", versioned, i);
    return name;
  }

  Engine made(Program& program, const std::string& word) const {
    Identity identity;
    try {
      auto process = program.take();
      identity = ask(*process, protocol::ask_hello(), {},
                     [](std::string_view answer) { return protocol::read_hello(answer); });
      program.give_back(std::move(process));
    } catch (const std::exception& error) {
      throw std::invalid_argument(fmt::format(
          "{}: asked who it is, {}. See the protocol in reference/programs/README.md, or try plumb engine check", word,
          error.what()));
    }
    const std::vector<Option> options = with_limits(identity.options);
    const Engine to_complete{.name = identity.name, .options = options};
    const auto completed = [to_complete](const Settings& settings) { return complete(to_complete, settings); };
    return {
        .name = free_name(identity),
        .about = identity.about.empty() ? "a program of its own" : identity.about,
        .source = fmt::format("{} {}{}{}", identity.name, identity.version, identity.source.empty() ? "" : ", ",
                              identity.source),
        .word = word,
        .language = identity.language,
        .execution = identity.execution,
        .caveats = identity.caveats,
        .options = options,
        .ladders = identity.ladders,
        .stepping =
            [&program, completed](const Settings& settings, double dt) {
              const Settings all = completed(settings);
              return program.stepping(without_limits(all), limits_of(all), dt);
            },
        .unsupported = only_build_knows,
        .build = [&program, completed](const Scene& scene, const Settings& settings) -> std::unique_ptr<Simulation> {
          const Settings all = completed(settings);
          return std::make_unique<ProgramSimulation>(program, scene, without_limits(all), limits_of(all));
        },
        .in_process = true};
  }

  std::mutex mutex_;
  std::deque<Entry> entries_, isolated_;
};

Programs& programs() {
  static Programs all;
  return all;
}

}  // namespace

const Engine& engine_of_program(const std::string& command, const std::string& word) {
  return programs().of(command, word.empty() ? std::string(program_prefix) + command : word);
}

const Engine& isolated(const Engine& engine) { return programs().isolated(engine); }

const Engine* known_program(std::string_view name) { return programs().find(name); }

}  // namespace plumb
