#include "reports/find/shrink.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "reports/judge/contacts.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/overlap.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene_json.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// m/s, at which the joint's constraint is broken at the start.
double speed_apart(const Joint& joint, std::span<const BodyState> start) {
  return std::visit(
      [&](const auto& one) {
        using Tie = std::decay_t<decltype(one)>;
        const BodyState& a = start[one.a];
        const BodyState& b = start[one.b];
        if constexpr (std::is_same_v<Tie, Distance>) {
          const Vec line = one.anchor_b - one.anchor_a;
          const double span = length(line);
          if (one.stiffness > 0 || span == 0) return 0.0;
          return std::abs(dot(line, velocity_at(b, one.anchor_b) - velocity_at(a, one.anchor_a))) / span;
        } else {
          const Vec apart = velocity_at(b, one.anchor) - velocity_at(a, one.anchor);
          const double turning = std::abs(b.angular_velocity - a.angular_velocity);
          if constexpr (std::is_same_v<Tie, Revolute>) return length(apart);
          if constexpr (std::is_same_v<Tie, Weld>) return length(apart) + turning;
          if constexpr (std::is_same_v<Tie, Prismatic>) return std::abs(cross(one.axis, apart)) + turning;
        }
      },
      joint);
}

double gap_of(const Joint& joint) {
  const auto* rod = std::get_if<Distance>(&joint);
  return rod == nullptr || rod->stiffness > 0 ? 0 : std::abs(length(rod->anchor_b - rod->anchor_a) - rod->length);
}

}  // namespace

Contradictions contradictions(const Scene& scene) {
  const auto start = initial_states(scene);
  Contradictions found;
  for (const BodyOverlap& one : Overlap(scene).all(start)) found.overlap = std::max(found.overlap, one.depth);
  for (const Joint& joint : scene.joints) {
    found.joint_speed = std::max(found.joint_speed, speed_apart(joint, start));
    found.joint_gap = std::max(found.joint_gap, gap_of(joint));
  }
  return found;
}

Contradictions operator+(const Contradictions& a, const Contradictions& b) {
  return {a.overlap + b.overlap, a.joint_speed + b.joint_speed, a.joint_gap + b.joint_gap};
}

Contradictions larger(const Contradictions& a, const Contradictions& b) {
  return {std::max(a.overlap, b.overlap), std::max(a.joint_speed, b.joint_speed), std::max(a.joint_gap, b.joint_gap)};
}

Contradictions stated_by(const Stepping& stepping) {
  return {stepping.contact_gap(), stepping.joint_slop / stepping.dt, stepping.joint_slop};
}

bool no_worse(const Scene& scene, const Contradictions& than) {
  constexpr double rounding = 1e-9;  // m, m/s: sums of rounded numbers
  const Contradictions found = contradictions(scene);
  return found.overlap <= than.overlap + rounding && found.joint_speed <= than.joint_speed + rounding &&
         found.joint_gap <= than.joint_gap + rounding;
}

namespace {

constexpr double clearly = 2;     // times what is allowed
constexpr double as_much = 0.01;  // of what it was off by: smaller bodies carry less, but not next to nothing

// The text of a scene; "" if it is not one that a file may hold.
std::string text_of(const Scene& scene) {
  try {
    return write_scene({.scene = scene, .truth = {}});
  } catch (const std::invalid_argument&) {
    return "";
  }
}

class Shrinker {
 public:
  Shrinker(const Scene& scene, const Complaint& complaint, const CutTrial& trial, int budget)
      : best_{scene, complaint, 0},
        start_(contradictions(scene)),
        least_ratio_(std::min(complaint.ratio, clearly)),
        least_value_(as_much * complaint.value),
        trial_(trial),
        budget_(budget) {
    tried_.insert(text_of(scene));
    tried_.insert("");
  }

  // Goes through the simpler scenes of a cut; after a success, on from the same place in the list of the new one's.
  bool apply(const Cut& cut) {
    bool any = false;
    std::vector<Scene> list = simpler(cut);
    for (std::size_t i = 0; i < list.size() && best_.runs < budget_;) {
      if (!takes(list[i], cut)) {
        ++i;
        continue;
      }
      any = true;
      list = simpler(cut);
    }
    return any;
  }

  bool spent() const { return best_.runs >= budget_; }
  Shrunk result() && { return std::move(best_); }

 private:
  std::vector<Scene> simpler(const Cut& cut) {
    const auto states = [this](double time) -> std::vector<BodyState> {
      if (spent()) return {};
      ++best_.runs;
      return trial_.states(best_.scene, time);
    };
    return cut.simpler(best_.scene, {best_.complaint, states});
  }

  bool takes(const Scene& candidate, const Cut& cut) {
    if (!tried_.insert(text_of(candidate)).second) return false;
    const Contradictions allowed = cut.from_run ? start_ + trial_.stated : start_;
    if (!no_worse(candidate, allowed)) return false;
    ++best_.runs;
    const auto complaint = trial_.fails(candidate);
    if (!complaint || !(complaint->ratio >= least_ratio_) || !(complaint->value >= least_value_)) return false;
    best_.scene = candidate;
    best_.complaint = *complaint;
    if (cut.from_run) start_ = larger(start_, contradictions(candidate));
    return true;
  }

  Shrunk best_;
  Contradictions start_;
  double least_ratio_, least_value_;
  const CutTrial& trial_;
  int budget_;
  std::set<std::string> tried_;
};

}  // namespace

Shrunk shrink(const Scene& scene, const Complaint& complaint, const CutTrial& trial, int budget) {
  std::vector<const Cut*> cuts = Catalog<Cut>::all();
  std::ranges::stable_sort(cuts, {}, &Cut::order);
  Shrinker shrinker(scene, complaint, trial, budget);
  for (bool any = true; any && !shrinker.spent();) {
    any = false;
    for (const Cut* cut : cuts) any = shrinker.apply(*cut) || any;
  }
  return std::move(shrinker).result();
}

}  // namespace plumb
