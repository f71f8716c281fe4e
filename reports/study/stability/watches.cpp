#include "reports/study/stability/watches.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "reports/vec.h"

namespace plumb {
namespace {

// The dynamic body, if any, for which `wrong` says so.
template <class Wrong>
std::optional<Symptom> first(Fate fate, const Scene& scene, Wrong wrong) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].type == BodyType::dynamic && wrong(i)) return Symptom{fate, i};
  }
  return std::nullopt;
}

Vec down_in(const Scene& scene) {
  const double g = length(scene.gravity);
  return g > 0 ? (1 / g) * scene.gravity : Vec{0, -1};
}

std::string degrees(double angle) { return fmt::format("{:.3g} deg", angle * 180 / std::numbers::pi); }

}  // namespace

Watch topples(const SharedScene& scene, double angle, double drop) {
  const auto start = initial_states(*scene);
  const Vec down = down_in(*scene);
  return {fmt::format("topples: a body has turned by more than {} or come down by more than {:.3g} m", degrees(angle),
                      drop),
          [=](const Moment& now) {
            return first(Fate::topples, *scene, [&](std::size_t i) {
              return std::abs(now.states[i].angle - start[i].angle) > angle ||
                     dot(down, now.states[i].position - start[i].position) > drop;
            });
          }};
}

Watch drifts(const SharedScene& scene, double way) {
  const auto start = initial_states(*scene);
  const Vec down = down_in(*scene);
  return {fmt::format("drifts: a body is more than {:.3g} m to the side of where it began", way),
          [=](const Moment& now) {
            return first(Fate::drifts, *scene, [&](std::size_t i) {
              return std::abs(cross(down, now.states[i].position - start[i].position)) > way;
            });
          }};
}

Watch sinks(const SharedScene& scene, double depth, double gap) {
  constexpr double pause = 0.1;  // s
  return {fmt::format("sinks: two bodies overlap by more than {:.3g} m beyond the gap that the method states", depth),
          [=, overlap = std::make_shared<Overlap>(*scene), next = 0.0](const Moment& now) mutable {
            std::optional<Symptom> symptom;
            if (now.time < next && !now.last) return symptom;
            next = now.time + pause;
            const BodyOverlap deepest = overlap->deepest(now.states);
            if (deepest.depth > depth + gap) symptom = Symptom{Fate::sinks, deepest.b};
            return symptom;
          }};
}

Watch gains_energy(const SharedScene& scene, double share) {
  const auto conserved = std::make_shared<Conserved>(*scene);
  const double most = conserved->energy(initial_states(*scene)).total() + share * energy_range(*scene, nullptr);
  return {fmt::format("gains energy: it has more than at the start by more than {:.3g} % of what it can turn over",
                      100 * share),
          [=](const Moment& now) {
            return conserved->energy(now.states).total() > most ? std::optional(Symptom{Fate::gains_energy, {}})
                                                                : std::nullopt;
          }};
}

Watch is_restless(const SharedScene& scene, double still_way) {
  struct Way {
    Vec from, at;
    double length = 0;
  };
  const double begin = scene->duration - 1;  // s
  return {
      fmt::format("jitters: over the last second a body's way is longer than {:.3g} m; drifts: and more than half of "
                  "that leads away",
                  still_way),
      [=, ways = std::vector<Way>()](const Moment& now) mutable {
        if (now.time < begin) return std::optional<Symptom>();
        for (std::size_t i = 0; i < now.states.size(); ++i) {
          const Vec at = now.states[i].position;
          if (ways.size() <= i) ways.push_back({at, at});
          ways[i].length += length(at - ways[i].at);
          ways[i].at = at;
        }
        if (!now.last) return std::optional<Symptom>();
        auto restless = first(Fate::jitters, *scene, [&](std::size_t i) { return ways[i].length > still_way; });
        if (!restless) return restless;
        const Way& way = ways[*restless->body];
        if (length(way.at - way.from) > way.length / 2) restless->fate = Fate::drifts;
        return restless;
      }};
}

Watch gives_way(const SharedScene& scene, std::size_t a, std::size_t b, double limit) {
  return {fmt::format("sinks: {} is more than {:.4g} m from {}", scene->bodies[b].name, limit, scene->bodies[a].name),
          [=](const Moment& now) {
            const bool gave = length(now.states[b].position - now.states[a].position) > limit;
            return gave ? std::optional(Symptom{Fate::sinks, b}) : std::nullopt;
          }};
}

// A body that has come down or to the side by half its size stands no more where it stood. Jitter of 0.02 m a second
// can be seen, and is an eighth of what the speed that gravity gives in a step of 1/60 s would make.
std::vector<Watch> status(const SharedScene& scene, double size, double gap) {
  constexpr double turned = 0.2;      // rad; toppled blocks may come to lean on the ground at 0.45
  constexpr double lifted = 0.1;      // of the energy that a fall would set free
  constexpr double pressed = 0.1;     // of a body's size, beyond the stated gap
  constexpr double still_way = 0.02;  // m
  return {topples(scene, turned, size / 2), drifts(scene, size / 2), gains_energy(scene, lifted),
          sinks(scene, pressed * size, gap), is_restless(scene, still_way)};
}

}  // namespace plumb
