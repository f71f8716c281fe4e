#include <limits>

#include "reports/study/stability/map.h"
#include "reports/study/stability/watches.h"
#include "scenarios/parts.h"

namespace plumb::maps::tunnelling {
namespace {

constexpr double radius = 0.25;  // m
constexpr int flight = 6;        // steps up to the wall

// m before the wall that a step ends: the worst of all phases. What touches already is stopped, and some engines take a
// centimetre or two for touching; the ball that is farthest through in the next step is just outside of that.
constexpr double gaps[] = {0.001, 0.006, 0.011, 0.016, 0.021};

// What is behind the wall at the next step's end was never seen in it, once v dt > wall + body; what is past its middle
// is let out on the far side, as that is the shorter way.
Watch passes_wall(double thickness) {
  return {"tunnels: the ball is behind the wall, and at no step's end overlapped it; sinks: it is there, and did",
          [=, met = false](const Moment& now) mutable {
            const double x = now.states[0].position.x;
            if (x >= thickness + radius) return std::optional(Symptom{met ? Fate::sinks : Fate::tunnels, 0});
            met = met || x > -radius;
            return std::optional<Symptom>();
          }};
}

std::vector<Trial> trials(double speed, double thickness, const EngineConfig&) {
  std::vector<Trial> all;
  for (const double gap : gaps) {
    Scene scene{.name = "wall", .gravity = {0, 0}, .duration = (flight + 6) * usual_dt};
    Body ball = disc("ball", {-radius - gap - flight * speed * usual_dt, 0}, radius, surface(0, 0));
    ball.velocity = {speed, 0};
    scene.bodies = {ball, fixed(box("wall", {thickness / 2, 0}, {thickness, 4}, surface(0, 0)))};
    all.push_back({.scene = std::make_shared<const Scene>(std::move(scene)),
                   .dt = usual_dt,
                   .watches = {passes_wall(thickness)}});
  }
  return all;
}

const Option* continuous_of(const Engine& engine) {
  for (const Option& option : engine.options) {
    if (option.key == "continuous") return &option;
  }
  return nullptr;
}

// With continuous collision as it comes, and without, where it can be turned off.
std::vector<EngineConfig> variants(const EngineConfig& config) {
  std::vector<EngineConfig> all{config};
  if (continuous_of(*config.engine) == nullptr || config.settings.at("continuous") == "off") return all;
  all.push_back(config);
  all.back().settings["continuous"] = "off";
  return all;
}

bool looks_between_steps(const EngineConfig& config) {
  const bool continuous = continuous_of(*config.engine) != nullptr && config.settings.at("continuous") != "off";
  return continuous || config.engine->stepping(config.settings, usual_dt).looks_ahead;
}

std::optional<double> passes(const EngineConfig& config, double thickness, double share) {
  if (looks_between_steps(config)) return std::numeric_limits<double>::infinity();
  return share * (thickness + 2 * radius) / usual_dt;
}

const Catalog<StabilityMap>::Entry entry{
    {.name = "tunnelling",
     .question = "How fast must a ball be to pass a wall, with continuous collision and without?",
     .x = {.name = "speed", .unit = "m/s", .from = 5, .to = 115, .logarithmic = true},
     .y = Axis{.name = "wall", .unit = "m", .from = 0.05, .to = 1, .logarithmic = true},
     .typical = 0.05,
     .trials = trials,
     .boundaries = {{.name = "unseen",
                     .failing = {Fate::tunnels},
                     .grain = 0.002,
                     .theory = [](const EngineConfig& config, double wall) { return passes(config, wall, 1); },
                     .source = "v dt = wall + body: never with continuous collision, or a solver that looks ahead",
                     .agreement = 0.05},
                    {.name = "stopped",
                     .grain = 0.002,
                     .theory = [](const EngineConfig& config, double wall) { return passes(config, wall, 0.5); },
                     .source = "v dt = (wall + body)/2, from where the far side is nearer: never with continuous "
                               "collision, or a solver that looks ahead",
                     .agreement = 0.05}},
     .variants = variants}};

}  // namespace
}  // namespace plumb::maps::tunnelling
