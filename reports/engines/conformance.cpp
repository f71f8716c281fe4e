#include "reports/engines/conformance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "reference/programs/line_process.h"
#include "reference/programs/protocol.h"
#include "reports/judge/rounding.h"
#include "reports/system/clock.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

using protocol::Answer;
using protocol::Identity;
using Result = ConformancePoint::Result;

constexpr double g = 10;         // m/s^2
constexpr double dt = 1.0 / 60;  // s
constexpr int steps = 60;
constexpr int placing = 8;  // operations that put a body where it belongs

Body disc(std::string name, Vec position) {
  return {.name = std::move(name), .position = position, .shapes = {{Circle{}, {1, 0, 0, 0}}}};
}

Body ground() { return {.name = "ground", .type = BodyType::fixed, .shapes = {{HalfSpace{}, {1, 0, 0, 0}}}}; }

Scene scene_of(std::vector<Body> bodies) {
  return {.name = "conformance", .gravity = {0, -g}, .duration = 1, .bodies = std::move(bodies)};
}

// A disc that falls beside one that spins, and floats.
Scene falling() {
  Body floating = disc("floating", {5, 20});
  floating.gravity_scale = 0;
  floating.velocity = {1, -2};
  floating.angular_velocity = 3;
  return scene_of({disc("falling", {0, 10}), floating});
}

// Ten discs, free or each on the ground.
Scene ten_discs(bool on_ground) {
  std::vector<Body> bodies;
  bodies.reserve(11);
  for (int i = 0; i < 10; ++i) bodies.push_back(disc("disc " + std::to_string(i), {2.0 * i, on_ground ? 0.5 : 10}));
  if (on_ground) bodies.push_back(ground());
  return scene_of(std::move(bodies));
}

// One scene for each thing that an engine may lack.
std::vector<std::pair<std::string, Scene>> features() {
  std::vector<std::pair<std::string, Scene>> all;
  const auto shape = [&](const char* name, Geometry geometry) {
    Body body = disc("body", {0, 3});
    body.shapes[0].geometry = std::move(geometry);
    all.emplace_back(name, scene_of({ground(), body}));
  };
  shape("boxes", Box{});
  shape("polygons", Polygon{{{0, 0}, {1, 0}, {0, 1}}});
  shape("capsules", Capsule{{-0.5, 0}, {0.5, 0}, 0.25});
  const auto body = [&](const char* name, const std::function<void(Body&)>& change) {
    Body changed = disc("body", {0, 3});
    change(changed);
    all.emplace_back(name, scene_of({ground(), changed}));
  };
  body("several shapes a body", [](Body& it) { it.shapes.push_back({Circle{0.5, {1, 0}}, {2, 0, 0, 0}}); });
  body("kinematic bodies", [](Body& it) { it.type = BodyType::kinematic; });
  body("paths of kinematic bodies", [](Body& it) {
    it.type = BodyType::kinematic;
    it.path = Path{.amplitude = {0, 1}};
  });
  body("fixed rotation", [](Body& it) { it.fixed_rotation = true; });
  body("gravity scale", [](Body& it) { it.gravity_scale = 0.5; });
  body("damping", [](Body& it) { it.linear_damping = it.angular_damping = 1; });
  body("layers", [](Body& it) { it.layers = 2; });
  body("static friction above dynamic friction", [](Body& it) { it.shapes[0].surface = {1, 0.6, 0.5, 0}; });
  const auto joint = [&](const char* name, const Joint& joined) {
    Scene scene = scene_of({disc("a", {0, 5}), disc("b", {2, 5})});
    scene.joints.push_back(joined);
    all.emplace_back(name, scene);
  };
  joint("revolute joints", Revolute{.a = 0, .b = 1, .anchor = {1, 5}});
  joint("limits of revolute joints", Revolute{.a = 0, .b = 1, .anchor = {1, 5}, .limits = Limits{-1, 1}});
  joint("motors of revolute joints", Revolute{.a = 0, .b = 1, .anchor = {1, 5}, .motor = Motor{1, 1}});
  joint("distance joints", Distance{.a = 0, .b = 1, .anchor_a = {0, 5}, .anchor_b = {2, 5}, .length = 2});
  joint("prismatic joints", Prismatic{.a = 0, .b = 1, .anchor = {1, 5}});
  joint("limits of prismatic joints", Prismatic{.a = 0, .b = 1, .anchor = {1, 5}, .limits = Limits{-1, 1}});
  joint("motors of prismatic joints", Prismatic{.a = 0, .b = 1, .anchor = {1, 5}, .motor = Motor{1, 1}});
  joint("weld joints", Weld{.a = 0, .b = 1, .anchor = {1, 5}});
  const auto force = [&](const char* name, const Force& one) {
    Scene scene = scene_of({disc("a", {0, 5}), disc("b", {2, 5})});
    scene.forces.push_back(one);
    all.emplace_back(name, scene);
  };
  force("constant forces", Constant{0, {1, 0}, 1});
  force("springs", Spring{.a = 0, .b = 1, .stiffness = 10, .length = 1});
  force("attractions", Attraction{.from = 0, .strength = 1});
  for (const auto mixing : {FrictionMixing::pythagorean, FrictionMixing::average, FrictionMixing::min,
                            FrictionMixing::max, FrictionMixing::multiply}) {
    Scene scene = scene_of({ground(), disc("body", {0, 3})});
    scene.mixing.friction = mixing;
    all.emplace_back(fmt::format("rule {} of friction", static_cast<int>(mixing)), scene);
  }
  return all;
}

bool same_bits(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(BodyState)) == 0;
}

// What a step of a program costs beyond the time that it says its engine took, in seconds.
struct StepCost {
  double beyond = 0;  // in all: reading the engine, writing, waking each other, reading
  double plumbs = 0;  // of it, the processor's time that Plumb took
};

constexpr double patience = 1;  // s without a faster round
constexpr double longest = 5;   // s
constexpr double faster = 0.98;

// Of the world that the program has built and not yet stepped. It steps for seconds, until it has stopped to become
// faster: a program in JavaScript or WebAssembly is slow until it is compiled.
StepCost cost_of_step(LineProcess& process, const ProgramLimits& limits, std::size_t bodies) {
  constexpr double unknown = std::numeric_limits<double>::max();
  StepCost least{unknown, unknown};
  double compared = unknown;
  protocol::StepsAhead ahead;
  std::size_t number = 0;
  const Stopwatch all;
  for (Stopwatch since; since.seconds() < patience && all.seconds() < longest;) {
    const std::size_t count = ahead.count();
    const double before = cpu_seconds(CpuClock::thread);
    const Stopwatch round;
    double own = 0;
    process.send(protocol::ask_steps(count, dt), limits);
    for (std::size_t i = 0; i < count; ++i) {
      own += protocol::read_step(process.receive(limits), bodies, ++number).seconds;
    }
    const double passed = round.seconds();
    const double made = static_cast<double>(count);
    least.beyond = std::min(least.beyond, (passed - own) / made);
    least.plumbs = std::min(least.plumbs, (cpu_seconds(CpuClock::thread) - before) / made);
    ahead.took(count, passed);
    if (least.beyond > faster * compared) continue;
    compared = least.beyond;
    since = Stopwatch();
  }
  return least;
}

class Conformance {
 public:
  Conformance(std::string command, const std::function<void(const ConformancePoint&)>& found)
      : command_(std::move(command)), found_(found) {}

  bool run() {
    if (!point("hello", "answer it with one line: plumb-engine, name and version", [&] { return hello(); }))
      return false;
    point("stepping", "state how you step with these options", [&] { return stepping(); });
    if (!point("build", "give the states that bodies start in", [&] { return build(); })) return false;
    point("free fall", "step by dt seconds; state the drift of your integrator", [&] { return free_fall(); });
    point("spin", "turn bodies by their angular velocity about their centre of mass", [&] { return spin(); });
    point("one step at a time", "let no step depend on how many are asked for", [&] { return one_by_one(); });
    point("built again", "let no world depend on an earlier one", [&] { return built_again(); });
    point("a process of its own", "use no time, no address and no randomness", [&] { return another_process(); });
    point("an unknown ask", "answer {\"error\": \"why\"} and go on", [&] { return unknown_ask(); });
    point("the end", "leave when asked to, and when standard input ends", [&] { return end(); });
    point("cost", "answer a step in less time", [&] { return cost(); });
    for (const auto& [name, scene] : features()) {
      point(name, "run it, or answer {\"notSupported\": \"why\"}", [&, &one = scene] { return feature(one); });
    }
    return !broken_;
  }

 private:
  // Runs `check`, which returns what was seen, or nothing if the point does not apply, and throws if it is broken.
  template <class Check>
  bool point(const std::string& name, const char* cure, const Check& check) {
    try {
      const std::string seen = check();
      const bool skipped = seen.starts_with(not_supported);
      found_({name, skipped ? Result::skipped : Result::kept, seen});
      return true;
    } catch (const std::exception& error) {
      found_({name, Result::broken, fmt::format("{}. Mend: {}", error.what(), cure)});
      broken_ = true;
      process_.reset();  // whatever it did, the next point starts anew
      return false;
    }
  }

  template <class Read>
  auto ask(const std::string& line, const Read& read) {
    if (!process_) process_ = std::make_unique<LineProcess>(command_);
    process_->send(line, limits_);
    const std::string_view answer = process_->receive(limits_);
    try {
      return read(answer);
    } catch (const std::invalid_argument& error) {
      throw process_->failure(error.what());
    }
  }

  std::string hello() {
    const Identity identity = ask(protocol::ask_hello(), protocol::read_hello);
    for (const Option& option : identity.options) settings_[option.key] = option.value;
    return fmt::format("{} {}, {} options", identity.name, identity.version, identity.options.size());
  }

  std::string stepping() {
    stated_ = ask(protocol::ask_stepping(settings_, dt),
                  [](std::string_view answer) { return protocol::read_stepping(answer, dt); });
    return fmt::format("order {}, {:.3g} sub-steps, skin {} m, slop {} m", stated_.order, dt / stated_.h, stated_.skin,
                       stated_.slop);
  }

  Answer built(const Scene& scene) {
    return ask(protocol::ask_build(scene, settings_),
               [&](std::string_view text) { return protocol::read_build(text, scene.bodies.size()); });
  }

  std::vector<BodyState> stepped(const Scene& scene, std::size_t at_once) {
    const Answer start = built(scene);
    if (!start.refusal.empty()) throw std::runtime_error("not supported: " + start.refusal);
    std::vector<BodyState> states;
    for (std::size_t done = 0; done < steps; done += at_once) {
      process_->send(protocol::ask_steps(at_once, dt), limits_);
      for (std::size_t i = 1; i <= at_once; ++i) {
        states = protocol::read_step(process_->receive(limits_), scene.bodies.size(), done + i).states;
      }
    }
    return states;
  }

  std::string build() {
    const Scene scene = falling();
    const Answer answer = built(scene);
    if (!answer.refusal.empty()) throw std::runtime_error("free discs are not supported: " + answer.refusal);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Body& body = scene.bodies[i];
      const BodyState& state = answer.states[i];
      const double moved = length(state.position - body.position);
      const double sped =
          std::hypot(length(state.velocity - body.velocity), state.angular_velocity - body.angular_velocity);
      if (moved <= rounding(placing, 20) && sped <= rounding(placing, 3 + differenced(stated_, 20, dt))) continue;
      throw std::runtime_error(fmt::format("body \"{}\" starts {:.3g} m and {:.3g} m/s or rad/s away from the scene's",
                                           body.name, moved, sped));
    }
    return "bodies start where the scene says";
  }

  std::string free_fall() {
    const BodyState fallen = stepped(falling(), steps).front();
    const double t = steps * dt;
    const double expected = 10 - g * t * t / 2 - stated_.drift * g * t * stated_.h;
    const double off = fallen.position.y - expected;
    // Integrators differ by shares of g t h like 1/2. A hundredth is beyond rounding, also of velocities that are kept
    // as differences of positions, whose roundings add up as n^2/2.
    if (std::abs(off) > rounding(steps, 20) + 0.01 * g * t * stated_.h) {
      throw std::runtime_error(
          fmt::format("after {:.3g} s a disc is {:.4g} m above where a drift of {} puts it", t, off, stated_.drift));
    }
    return fmt::format("{:+.4g} mm after 1 s, as stated", 1e3 * (fallen.position.y - (10 - g * t * t / 2)));
  }

  std::string spin() {
    const BodyState state = stepped(falling(), steps).back();
    const double off = std::abs(state.angle - 3 * steps * dt);
    // A rotation kept as cosine and sine may advance by atan(w h) = w h - (w h)^3/3.
    if (off > rounding(steps, 3) + steps * dt * 27 * stated_.h * stated_.h / 3) {
      throw std::runtime_error(fmt::format("3 rad/s turned a disc by {} rad in a second", state.angle));
    }
    return "whole turns are counted";
  }

  std::string one_by_one() {
    if (!same_bits(stepped(falling(), steps), stepped(falling(), 1)))
      throw std::runtime_error("other bits than 60 at once");
    return "the same bits as 60 at once";
  }

  std::string built_again() {
    const auto first = stepped(rolling(), steps);
    if (!same_bits(first, stepped(rolling(), steps))) throw std::runtime_error("other bits than the first time");
    return "the same bits";
  }

  std::string another_process() {
    const auto first = stepped(rolling(), steps);
    process_.reset();
    if (!same_bits(first, stepped(rolling(), steps))) throw std::runtime_error("other bits than in the first process");
    return "the same bits";
  }

  // With a contact, if the engine has half-spaces.
  Scene rolling() {
    Scene scene = falling();
    scene.bodies[0].position = {0, 1};
    scene.bodies[0].velocity = {1, 0};
    scene.bodies.push_back(ground());
    return built(scene).refusal.empty() ? scene : falling();
  }

  std::string unknown_ask() {
    try {
      ask("{\"sing\": 1}", protocol::read_hello);
    } catch (const ProgramFailure&) {
      ask(protocol::ask_hello(), protocol::read_hello);  // it must still be there
      return "is refused, and the program goes on";
    }
    throw std::runtime_error("it answered as if it had been hello");
  }

  std::string end() {
    ask(protocol::ask_hello(), protocol::read_hello);
    process_->send(protocol::ask_end(), limits_);
    try {
      process_->receive(limits_);
    } catch (const ProgramFailure& failure) {
      process_.reset();
      if (std::string_view(failure.what()).find("within") == std::string_view::npos) return "it left";
      throw;
    }
    throw std::runtime_error("it answered instead");
  }

  std::string cost() {
    const auto beyond = [&](bool on_ground) {
      const Scene scene = ten_discs(on_ground);
      if (!built(scene).refusal.empty()) return std::string("not supported");
      const StepCost least = cost_of_step(*process_, limits_, scene.bodies.size());
      return fmt::format("{:.1f} us ({:.1f} of them Plumb's)", 1e6 * least.beyond, 1e6 * least.plumbs);
    };
    const std::string free = beyond(false);
    return fmt::format("a step of ten discs takes {} beyond the engine's own time, {} on the ground", free,
                       beyond(true));
  }

  std::string feature(const Scene& scene) {
    const Answer start = built(scene);
    if (!start.refusal.empty()) return not_supported + start.refusal;
    process_->send(protocol::ask_steps(1, dt), limits_);
    protocol::read_step(process_->receive(limits_), scene.bodies.size(), 1);
    return "runs";
  }

  // Of n steps, with all their sub-steps, of a value of that size.
  double rounding(int n, double size) const { return 2 * n * (dt / stated_.h) * stated_.epsilon * size; }

  static inline const std::string not_supported = "not supported: ";

  std::string command_;
  const std::function<void(const ConformancePoint&)>& found_;
  ProgramLimits limits_;
  std::unique_ptr<LineProcess> process_;
  Settings settings_;
  Stepping stated_{.dt = dt, .h = dt, .epsilon = 0x1p-24};
  bool broken_ = false;
};

}  // namespace

bool check_conformance(const std::string& command, const std::function<void(const ConformancePoint&)>& found) {
  return Conformance(command, found).run();
}

}  // namespace plumb
