#include "reports/writers/replay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "reports/writers/packed.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/mass.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json pair_of(Vec v) { return Json::array({v.x, v.y}); }

Json json_of(const Outline& outline) {
  if (outline.halfspace) return {{"normal", pair_of(outline.halfspace->normal)}, {"offset", outline.halfspace->offset}};
  Json points = Json::array();
  for (const Vec point : outline.points) points.push_back(pair_of(point));
  return {{"points", points}, {"radius", outline.radius}};
}

const char* name_of(BodyType type) {
  switch (type) {
    case BodyType::fixed:
      return "fixed";
    case BodyType::kinematic:
      return "kinematic";
    case BodyType::dynamic:
      return "dynamic";
  }
  return "";
}

Json joints_of(const Scene& scene) {
  const std::vector<BodyState> start = initial_states(scene);
  const auto local = [&](std::size_t body, Vec anchor) {
    return pair_of(rotated(anchor - start[body].position, -start[body].angle));
  };
  Json joints = Json::array();
  for (const Joint& joint : scene.joints) {
    const JointFacts facts = facts_of(joint);
    joints.push_back({{"a", facts.a},
                      {"b", facts.b},
                      {"at_a", local(facts.a, facts.anchor_a)},
                      {"at_b", local(facts.b, facts.anchor_b)}});
  }
  for (const Force& force : scene.forces) {
    const auto* spring = std::get_if<Spring>(&force);
    if (spring == nullptr) continue;
    const auto of_body = [&](std::size_t body, Vec anchor) {
      return pair_of(anchor - mass_of(scene.bodies[body]).center);
    };
    joints.push_back({{"a", spring->a ? Json(*spring->a) : Json()},
                      {"b", spring->b},
                      {"at_a", spring->a ? of_body(*spring->a, spring->anchor_a) : pair_of(spring->anchor_a)},
                      {"at_b", of_body(spring->b, spring->anchor_b)}});
  }
  return joints;
}

constexpr double microsecond = 1e-6;         // s
constexpr double energy_share = 1.0 / 4096;  // bars are some hundred pixels high
constexpr double impulse_share = 1.0 / 256;  // arrows are shorter

std::vector<std::size_t> kept_moments(std::size_t moments, std::size_t every) {
  std::vector<std::size_t> kept;
  for (std::size_t moment = 0; moment < moments; moment += every) kept.push_back(moment);
  if (kept.back() != moments - 1) kept.push_back(moments - 1);
  return kept;
}

// The rounding steps of a run's columns.
struct RoundingSteps {
  double length = 0, angle = 0, impulse = 0, energy = 0;
};

// A fraction of what a column spans. Changes no larger than the round-off of its values are not motion.
double step_of(double share, double span, double size) {
  constexpr double round_off = 1.0 / (1LL << 40);
  const double step = std::max(share * span, round_off * size);
  return step > 0 ? step : share;
}

class RunReplay {
 public:
  explicit RunReplay(const RunCurves& curves)
      : curves_(curves), scene_(*curves.run->scene), trace_(*curves.run->trace), radii_(radii_of(scene_)) {
    choose_length();
    choose_impulse();
    choose_energy();
  }

  Json json(const ReplayLimits& limits) const {
    std::size_t every = 1;
    std::string poses = poses_of(kept_moments(trace_.size(), every));
    while (poses.size() > limits.poses && every < trace_.size()) {
      // The packed size is about proportional to the number of moments; a little extra saves iterations.
      const double excess = 1.05 * static_cast<double>(poses.size()) / static_cast<double>(limits.poses);
      every = std::max(every + 1, static_cast<std::size_t>(std::ceil(static_cast<double>(every) * excess)));
      poses = poses_of(kept_moments(trace_.size(), every));
    }
    const std::vector<std::size_t> kept = kept_moments(trace_.size(), every);
    std::string touches = shows_contacts() ? touches_of(kept) : "";
    const char* contacts = touches.empty() ? "none" : "kept";
    if (touches.size() > limits.contacts) {
      contacts = "too many";
      touches.clear();
    }
    const RunRecord& run = *curves_.run;
    return {{"engine", run.engine},
            {"method", run.method},
            {"moments", kept.size()},
            {"every", every},
            {"between", off_between(kept)},
            {"length", steps_.length},
            {"angle", steps_.angle},
            {"impulse", steps_.impulse},
            {"energy", steps_.energy},
            {"contacts", contacts},
            {"apart", furthest_apart()},
            {"overlap", deepest_overlap()},
            {"poses", poses},
            {"touches", touches}};
  }

 private:
  bool moves(std::size_t body) const { return scene_.bodies[body].type != BodyType::fixed; }

  // A step of the angle moves no point of a body farther than a step of its position.
  void choose_length() {
    Vec low{1e300, 1e300};
    Vec high{-1e300, -1e300};
    double largest = 0;
    double size = 0;
    double turned = 0;
    for (std::size_t body = 0; body < radii_.size(); ++body) {
      if (moves(body)) largest = std::max(largest, radii_[body]);
      for (std::size_t moment = 0; moment < trace_.size(); ++moment) {
        const BodyState& state = trace_.states(moment)[body];
        const Vec at = state.position;
        size = std::max({size, std::abs(at.x), std::abs(at.y)});
        turned = std::max(turned, std::abs(state.angle));
        if (!moves(body)) continue;
        low = {std::min(low.x, at.x - radii_[body]), std::min(low.y, at.y - radii_[body])};
        high = {std::max(high.x, at.x + radii_[body]), std::max(high.y, at.y + radii_[body])};
      }
    }
    steps_.length = step_of(position_share, std::max({0.0, high.x - low.x, high.y - low.y}), size);
    steps_.angle = step_of(largest > 0 ? steps_.length / largest : position_share, 1, turned);
  }

  void choose_impulse() {
    double largest = 0;
    for (std::size_t moment = 0; moment < trace_.size(); ++moment) {
      for (const ContactState& contact : trace_.contacts(moment)) {
        const double impulse = std::hypot(contact.normal_impulse, contact.tangent_impulse);
        if (std::isfinite(impulse)) largest = std::max(largest, impulse);
      }
    }
    steps_.impulse = step_of(impulse_share, largest, 0);
  }

  void choose_energy() {
    const Conserved conserved(scene_);
    for (std::size_t moment = 0; moment < trace_.size(); ++moment) {
      const Energy energy = conserved.energy(trace_.states(moment));
      energy_.push_back({energy.linear, energy.rotational, energy.potential});
    }
    double widest = 0;
    double size = 0;
    for (std::size_t part = 0; part < 3; ++part) {
      const auto [low, high] = std::minmax_element(energy_.begin(), energy_.end(),
                                                   [&](const auto& a, const auto& b) { return a[part] < b[part]; });
      widest = std::max(widest, (*high)[part] - (*low)[part]);
      size = std::max({size, std::abs((*low)[part]), std::abs((*high)[part])});
    }
    steps_.energy = step_of(energy_share, widest, size);
  }

  std::string poses_of(const std::vector<std::size_t>& kept) const {
    Numbers numbers;
    std::vector<double> column(kept.size());
    const auto put = [&](auto value, double step) {
      for (std::size_t i = 0; i < kept.size(); ++i) column[i] = value(kept[i]);
      numbers.put_smooth(column, step);
    };
    put([&](std::size_t moment) { return trace_.time(moment); }, microsecond);
    for (std::size_t body = 0; body < trace_.bodies(); ++body) {
      put([&](std::size_t moment) { return trace_.states(moment)[body].position.x; }, steps_.length);
      put([&](std::size_t moment) { return trace_.states(moment)[body].position.y; }, steps_.length);
      put([&](std::size_t moment) { return trace_.states(moment)[body].angle; }, steps_.angle);
    }
    for (std::size_t part = 0; part < 3; ++part) {
      put([&](std::size_t moment) { return energy_[moment][part]; }, steps_.energy);
    }
    return packed(numbers.bytes());
  }

  struct Touch {
    std::size_t moment;  // of those kept
    std::array<double, 4> values;
  };

  static bool can_be_shown(Vec v, double step) { return Numbers::holds(v.x, step) && Numbers::holds(v.y, step); }

  // The k-th point between two bodies, in the order in which the engine reports them.
  using Place = std::tuple<std::size_t, std::size_t, std::size_t>;

  std::map<Place, std::vector<Touch>> touches_by_place(const std::vector<std::size_t>& kept) const {
    std::map<Place, std::vector<Touch>> places;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      std::map<std::pair<std::size_t, std::size_t>, std::size_t> points;
      for (const ContactState& contact : trace_.contacts(kept[i])) {
        const Vec along = contact.normal_impulse * contact.normal;
        const Vec across = contact.tangent_impulse * Vec{-contact.normal.y, contact.normal.x};
        Vec on_second = along + across;
        if (!can_be_shown(contact.point, steps_.length) || !can_be_shown(on_second, steps_.impulse)) continue;
        const auto pair = std::minmax(contact.a, contact.b);
        if (contact.a > contact.b) on_second = -1.0 * on_second;
        places[{pair.first, pair.second, points[pair]++}].push_back(
            {i, {contact.point.x, contact.point.y, on_second.x, on_second.y}});
      }
    }
    return places;
  }

  bool shows_contacts() const {
    for (std::size_t moment = 0; moment < trace_.size(); ++moment) {
      if (!trace_.contacts(moment).empty()) return true;
    }
    return false;
  }

  std::string touches_of(const std::vector<std::size_t>& kept) const {
    const auto places = touches_by_place(kept);
    Numbers numbers;
    numbers.put(static_cast<std::int64_t>(places.size()));
    for (const auto& [place, touches] : places) put_place(touches, numbers);
    return packed(numbers.bytes());
  }

  void put_place(std::span<const Touch> touches, Numbers& numbers) const {
    std::vector<std::span<const Touch>> stays;
    for (std::size_t begin = 0, i = 1; i <= touches.size(); ++i) {
      if (i < touches.size() && touches[i].moment == touches[i - 1].moment + 1) continue;
      stays.push_back(touches.subspan(begin, i - begin));
      begin = i;
    }
    numbers.put(static_cast<std::int64_t>(stays.size()));
    std::size_t end = 0;
    std::vector<double> column;
    for (const std::span<const Touch> stay : stays) {
      numbers.put(static_cast<std::int64_t>(stay.front().moment - end));
      numbers.put(static_cast<std::int64_t>(stay.size()));
      end = stay.back().moment + 1;
      for (std::size_t k = 0; k < 4; ++k) {
        column.clear();
        for (const Touch& touch : stay) column.push_back(touch.values[k]);
        numbers.put_steady(column, k < 2 ? steps_.length : steps_.impulse);
      }
    }
  }

  // m, the largest distance of any point of a body between its recorded motion and the straight line between kept
  // moments.
  double off_between(const std::vector<std::size_t>& kept) const {
    double most = 0;
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
      const auto before = trace_.states(kept[i]);
      const auto after = trace_.states(kept[i + 1]);
      const double span = trace_.time(kept[i + 1]) - trace_.time(kept[i]);
      for (std::size_t moment = kept[i] + 1; moment < kept[i + 1]; ++moment) {
        const double share = (trace_.time(moment) - trace_.time(kept[i])) / span;
        const auto there = trace_.states(moment);
        for (std::size_t body = 0; body < there.size(); ++body) {
          const Vec line = before[body].position + share * (after[body].position - before[body].position);
          const double turn = before[body].angle + share * (after[body].angle - before[body].angle);
          const double off = length(there[body].position - line) + radii_[body] * std::abs(there[body].angle - turn);
          most = std::max(most, off);
        }
      }
    }
    return most;
  }

  Json furthest_apart() const {
    const auto& apart = curves_.difference;
    const auto worst = std::max_element(apart.begin(), apart.end(),
                                        [](const auto& a, const auto& b) { return a.position < b.position; });
    if (worst == apart.end() || !(worst->position > 0)) return {};
    const auto moment = static_cast<std::size_t>(worst - apart.begin());
    return {{"time", trace_.time(moment)}, {"value", worst->position}};
  }

  Json deepest_overlap() const {
    const auto& deepest = curves_.deepest;
    const auto worst = std::max_element(deepest.begin(), deepest.end(),
                                        [](const auto& a, const auto& b) { return a.depth < b.depth; });
    if (worst == deepest.end() || !(worst->depth > 0)) return {};
    const auto moment = static_cast<std::size_t>(worst - deepest.begin());
    return {{"time", trace_.time(moment)}, {"value", worst->depth}, {"a", worst->a}, {"b", worst->b}};
  }

  const RunCurves& curves_;
  const Scene& scene_;
  const Trace& trace_;
  std::vector<double> radii_;
  RoundingSteps steps_;
  std::vector<std::array<double, 3>> energy_;  // J, by moment: linear, rotational, potential
};

}  // namespace

Json outlines_of(const Scene& scene) {
  Json outlines = Json::array();
  Json bodies = Json::array();
  std::map<std::string, std::size_t> known;
  for (const Body& body : scene.bodies) {
    const Vec center = mass_of(body).center;
    Json indices = Json::array();
    for (const Shape& shape : body.shapes) {
      Json outline = json_of(outline_of(shape.geometry, center));
      const auto [place, added] = known.try_emplace(outline.dump(), outlines.size());
      if (added) outlines.push_back(std::move(outline));
      indices.push_back(place->second);
    }
    bodies.push_back({{"name", body.name}, {"type", name_of(body.type)}, {"outlines", indices}});
  }
  return {{"outlines", outlines}, {"bodies", bodies}, {"joints", joints_of(scene)}};
}

std::vector<double> radii_of(const Scene& scene) {
  std::vector<double> radii;
  for (const Body& body : scene.bodies) {
    const Vec center = mass_of(body).center;
    double radius = 0;
    for (const Shape& shape : body.shapes) {
      const Outline outline = outline_of(shape.geometry, center);
      for (const Vec point : outline.points) radius = std::max(radius, length(point) + outline.radius);
    }
    radii.push_back(radius);
  }
  return radii;
}

Json replays_of(std::span<const RunCurves> curves, const ReplayLimits& limits) {
  Json replays = Json::array();
  for (const RunCurves& one : curves) {
    const RunRecord& run = *one.run;
    const auto same = [&](const Json& replay) {
      return replay["scenario"] == run.scenario && replay["variant"] == run.variant;
    };
    auto replay = std::find_if(replays.begin(), replays.end(), same);
    if (replay == replays.end()) {
      replays.push_back({{"scenario", run.scenario},
                         {"variant", run.variant},
                         {"scene", packed(outlines_of(*run.scene).dump())},
                         {"runs", Json::array()}});
      replay = std::prev(replays.end());
    }
    (*replay)["runs"].push_back(RunReplay(one).json(limits));
  }
  return replays;
}

}  // namespace plumb
