// Maps of fast impacts: a disc that bounces on the ground, and a ball that may pass through a wall.

#include <cmath>
#include <limits>
#include <utility>

#include "reports/study/stability/map.h"
#include "scenarios/parts.h"

namespace plumb::maps::impacts {
namespace {

// Apex n is at e^(2n) h. Samples dt apart show it at most g dt^2/8 too low, and never too high. If the impact is
// noticed one step late, the disc can be as deep as it falls in a step.
Detector bounce_detector(double dt, double e, double height) {
  constexpr double radius = 0.5;          // m
  constexpr double gravity = 10;          // m/s^2
  const double tolerance = 0.1 * height;  // m
  const double deepest = (std::sqrt(2 * gravity * height) + gravity * dt) * dt + radius;
  return {
      "gains energy: a bounce is higher than restitution allows, by more than a tenth of the drop; sinks: the disc is "
      "in the ground by more than its radius and what it falls in a step",
      [=, apex = height, falling = true, before = height](const ObservedStep& now) mutable {
        const double y = now.states[1].position.y - radius;
        const bool was_falling = std::exchange(falling, y < before || (falling && y == before));
        if (was_falling && !falling) apex *= e * e;  // it has bounced
        before = y;
        if (y > apex + tolerance) return std::optional(DetectorFinding{FailureMode::gains_energy, 1});
        return y < -deepest ? std::optional(DetectorFinding{FailureMode::sinks, 1}) : std::nullopt;
      }};
}

// Impacts fall into several phases of a step.
std::vector<Trial> bounce_trials(double dt, double e, const EngineConfig&) {
  constexpr double height = 4;  // m
  constexpr int phases = 4;
  const auto scene = std::make_shared<const Scene>(catalog_scene("bounce", {{"restitution", e}, {"height", height}}));
  std::vector<Trial> all;
  for (int k = 1; k <= phases; ++k) {
    const double first_step = static_cast<double>(k) / phases;
    all.push_back({.scene = scene, .dt = dt, .first_step = first_step, .detectors = {bounce_detector(dt, e, height)}});
  }
  return all;
}

const Catalog<StabilityMap>::Entry restitution{
    {.name = "restitution",
     .question = "Up to which step does a disc never bounce higher than its restitution allows?",
     .x = {.name = "dt", .unit = "s", .from = 1.0 / 480, .to = 0.2, .logarithmic = true},
     .y = Axis{.name = "restitution", .from = 0.3, .to = 1},
     .typical = 0.8,
     .trials = bounce_trials,
     .boundaries = {{.name = "bounces", .resolution = 0.01}}}};

constexpr double ball_radius = 0.25;  // m

// If v dt > wall + body, a ball that is behind the wall at the end of a step can never have overlapped it. A ball that
// is past the middle of the wall is pushed out on the far side, as that is the shorter way.
Detector wall_detector(double thickness) {
  return {
      "tunnels: the ball is behind the wall, and overlapped it at the end of no step; sinks: it is behind the wall, "
      "and did overlap it",
      [=, met = false](const ObservedStep& now) mutable {
        const double x = now.states[0].position.x;
        if (x >= thickness + ball_radius) {
          return std::optional(DetectorFinding{met ? FailureMode::sinks : FailureMode::tunnels, 0});
        }
        met = met || x > -ball_radius;
        return std::optional<DetectorFinding>();
      }};
}

// The last step before the wall ends at several gaps, to find the worst phase. A ball that touches is stopped, and some
// engines count a gap of a centimetre or two as touching; the ball that gets farthest through in the next step starts
// just outside of that.
std::vector<Trial> wall_trials(double speed, double thickness, const EngineConfig&) {
  constexpr double gaps[] = {0.001, 0.006, 0.011, 0.016, 0.021};  // m
  constexpr int flight = 6;                                       // steps up to the wall
  std::vector<Trial> all;
  for (const double gap : gaps) {
    Scene scene{.name = "wall", .gravity = {0, 0}, .duration = (flight + 6) * usual_dt};
    Body ball = disc("ball", {-ball_radius - gap - flight * speed * usual_dt, 0}, ball_radius, surface(0, 0));
    ball.velocity = {speed, 0};
    scene.bodies = {ball, fixed(box("wall", {thickness / 2, 0}, {thickness, 4}, surface(0, 0)))};
    all.push_back({.scene = std::make_shared<const Scene>(std::move(scene)),
                   .dt = usual_dt,
                   .detectors = {wall_detector(thickness)}});
  }
  return all;
}

bool has_continuous_option(const Engine& engine) {
  for (const Option& option : engine.options) {
    if (option.key == "continuous") return true;
  }
  return false;
}

bool is_continuous(const EngineConfig& config) {
  return has_continuous_option(*config.engine) && config.settings.at("continuous") != "off";
}

// The method as it is, and without continuous collision if it has an option for that.
std::vector<EngineConfig> wall_variants(const EngineConfig& config) {
  std::vector<EngineConfig> all{config};
  if (!is_continuous(config)) return all;
  all.push_back(config);
  all.back().settings["continuous"] = "off";
  return all;
}

// m/s, at which the ball covers `share` of the wall's thickness and its own diameter in a step; infinite for methods
// that look between steps.
std::optional<double> passing_speed(const EngineConfig& config, double thickness, double share) {
  std::string why_not;
  const auto stated = stepping_of(config, usual_dt, why_not);
  if (!stated) return std::nullopt;
  if (is_continuous(config) || stated->looks_ahead) return std::numeric_limits<double>::infinity();
  return share * (thickness + 2 * ball_radius) / usual_dt;
}

const Catalog<StabilityMap>::Entry tunnelling{
    {.name = "tunnelling",
     .question = "How fast must a ball be to pass through a wall, with continuous collision and without?",
     .x = {.name = "speed", .unit = "m/s", .from = 5, .to = 115, .logarithmic = true},
     .y = Axis{.name = "wall", .unit = "m", .from = 0.05, .to = 1, .logarithmic = true},
     .typical = 0.05,
     .trials = wall_trials,
     .boundaries = {{.name = "unseen",
                     .failing = {FailureMode::tunnels},
                     .resolution = 0.002,
                     .theory = [](const EngineConfig& config, double wall) { return passing_speed(config, wall, 1); },
                     .source = "v dt = wall + body: never with continuous collision, or a solver that looks ahead",
                     .agreement = 0.05},
                    {.name = "stopped",
                     .resolution = 0.002,
                     .theory = [](const EngineConfig& config, double wall) { return passing_speed(config, wall, 0.5); },
                     .source = "v dt = (wall + body)/2, beyond which the far side is nearer: never with continuous "
                               "collision, or a solver that looks ahead",
                     .agreement = 0.05}},
     .variants = wall_variants}};

}  // namespace
}  // namespace plumb::maps::impacts
