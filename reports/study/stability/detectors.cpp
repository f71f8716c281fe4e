#include "reports/study/stability/detectors.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

constexpr std::array<FailureModeText, 10> all_modes{{
    {FailureMode::not_supported, '-', "not supported", "the method cannot run the scene"},
    {FailureMode::holds, 'h', "holds", "none of the failures"},
    {FailureMode::drifts, 'd', "drifts", "a body leaves its place, or keeps moving in one direction"},
    {FailureMode::jitters, 'j', "jitters", "a body stays near its place but does not come to rest"},
    {FailureMode::sinks, 's', "sinks", "bodies penetrate each other, or a joint separates"},
    {FailureMode::tunnels, 't', "tunnels", "a body is behind a wall and overlapped it at the end of no step"},
    {FailureMode::topples, 'o', "topples", "a body turns over or falls down"},
    {FailureMode::gains_energy, 'g', "gains energy", "the scene has more energy than physics allows"},
    {FailureMode::diverges, 'x', "diverges", "a number is not finite, or above 1e7 m, 1e6 m/s or 1e6 rad/s"},
    {FailureMode::fails, 'e', "fails", "the engine threw an error"},
}};

const FailureModeText& text_of(FailureMode mode) { return all_modes[static_cast<std::size_t>(mode)]; }

// The first dynamic body for whose index `wrong` is true, if any.
template <class Wrong>
std::optional<DetectorFinding> find_body(FailureMode mode, const Scene& scene, Wrong wrong) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].type == BodyType::dynamic && wrong(i)) return DetectorFinding{mode, i};
  }
  return std::nullopt;
}

// The direction of gravity; without gravity that of -y.
Vec down_in(const Scene& scene) {
  const double g = length(scene.gravity);
  return g > 0 ? (1 / g) * scene.gravity : Vec{0, -1};
}

std::string degrees_text(double angle) { return fmt::format("{:.3g} deg", angle * 180 / std::numbers::pi); }

}  // namespace

std::span<const FailureModeText> failure_modes() { return all_modes; }
char letter_of(FailureMode mode) { return text_of(mode).letter; }
const char* name_of(FailureMode mode) { return text_of(mode).name; }
bool is_failure(FailureMode mode) { return mode != FailureMode::holds && mode != FailureMode::not_supported; }

Detector topple_detector(const SharedScene& scene, double angle, double drop) {
  const auto start = initial_states(*scene);
  const Vec down = down_in(*scene);
  return {fmt::format("topples: a body has turned by more than {} or dropped by more than {:.3g} m",
                      degrees_text(angle), drop),
          [=](const ObservedStep& now) {
            return find_body(FailureMode::topples, *scene, [&](std::size_t i) {
              return std::abs(now.states[i].angle - start[i].angle) > angle ||
                     dot(down, now.states[i].position - start[i].position) > drop;
            });
          }};
}

Detector drift_detector(const SharedScene& scene, double distance) {
  const auto start = initial_states(*scene);
  const Vec down = down_in(*scene);
  return {fmt::format("drifts: a body is more than {:.3g} m to the side of its initial position", distance),
          [=](const ObservedStep& now) {
            return find_body(FailureMode::drifts, *scene, [&](std::size_t i) {
              return std::abs(cross(down, now.states[i].position - start[i].position)) > distance;
            });
          }};
}

Detector sink_detector(const SharedScene& scene, double depth, double gap) {
  constexpr double interval = 0.1;  // s
  return {fmt::format("sinks: two bodies overlap by more than {:.3g} m beyond the gap that the method states", depth),
          [=, overlap = std::make_shared<Overlap>(*scene), next = 0.0](const ObservedStep& now) mutable {
            std::optional<DetectorFinding> found;
            if (now.time < next && !now.last) return found;
            next = now.time + interval;
            const BodyOverlap deepest = overlap->deepest(now.states);
            if (deepest.depth > depth + gap) found = DetectorFinding{FailureMode::sinks, deepest.b};
            return found;
          }};
}

Detector energy_detector(const SharedScene& scene, double fraction) {
  const auto conserved = std::make_shared<Conserved>(*scene);
  const double most = conserved->energy(initial_states(*scene)).total() + fraction * energy_range(*scene, nullptr);
  return {fmt::format("gains energy: the energy is above that of the start by more than {:.3g} % of its range",
                      100 * fraction),
          [=](const ObservedStep& now) {
            return conserved->energy(now.states).total() > most
                       ? std::optional(DetectorFinding{FailureMode::gains_energy, {}})
                       : std::nullopt;
          }};
}

Detector restlessness_detector(const SharedScene& scene, double path) {
  struct BodyPath {
    Vec from, at;
    double length = 0;
  };
  const double begin = scene->duration - 1;  // s
  return {fmt::format("jitters: over the last second a body moves along a path longer than {:.3g} m; drifts: and its "
                      "displacement is more than half of that path",
                      path),
          [=, paths = std::vector<BodyPath>()](const ObservedStep& now) mutable {
            if (now.time < begin) return std::optional<DetectorFinding>();
            for (std::size_t i = 0; i < now.states.size(); ++i) {
              const Vec at = now.states[i].position;
              if (paths.size() <= i) paths.push_back({at, at});
              paths[i].length += length(at - paths[i].at);
              paths[i].at = at;
            }
            if (!now.last) return std::optional<DetectorFinding>();
            auto found = find_body(FailureMode::jitters, *scene, [&](std::size_t i) { return paths[i].length > path; });
            if (!found) return found;
            const BodyPath& longest = paths[*found->body];
            if (length(longest.at - longest.from) > longest.length / 2) found->mode = FailureMode::drifts;
            return found;
          }};
}

Detector separation_detector(const SharedScene& scene, std::size_t a, std::size_t b, double distance) {
  return {
      fmt::format("sinks: {} is more than {:.4g} m from {}", scene->bodies[b].name, distance, scene->bodies[a].name),
      [=](const ObservedStep& now) {
        const bool apart = length(now.states[b].position - now.states[a].position) > distance;
        return apart ? std::optional(DetectorFinding{FailureMode::sinks, b}) : std::nullopt;
      }};
}

// A body that has dropped or moved sideways by half its size no longer stands where it stood. Jitter of 0.02 m/s is
// visible, and an eighth of the speed that gravity adds in a step of 1/60 s.
std::vector<Detector> structure_detectors(const SharedScene& scene, double size, double gap) {
  constexpr double angle = 0.2;     // rad; toppled blocks may come to lean on the ground at 0.45
  constexpr double fraction = 0.1;  // of the energy that a fall would set free
  constexpr double depth = 0.1;     // of a body's size, beyond the stated gap
  constexpr double path = 0.02;     // m
  return {topple_detector(scene, angle, size / 2), drift_detector(scene, size / 2), energy_detector(scene, fraction),
          sink_detector(scene, depth * size, gap), restlessness_detector(scene, path)};
}

}  // namespace plumb
