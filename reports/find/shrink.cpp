#include "reports/find/shrink.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "scenarios/catalog.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
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
