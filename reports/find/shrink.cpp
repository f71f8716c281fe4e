#include "reports/find/shrink.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "reports/find/admissible.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

constexpr double clearly = 2;  // times what is allowed

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
  Shrinker(const Scene& scene, const Complaint& complaint, const Failing& fails, int budget)
      : best_{scene, complaint, 0},
        start_(contradictions(scene)),
        least_(std::min(complaint.ratio, clearly)),
        fails_(fails),
        budget_(budget) {
    tried_.insert(text_of(scene));
    tried_.insert("");
  }

  // Goes through the simpler scenes of a cut; after a success, on from the same place in the list of the new one's.
  bool apply(const Cut& cut) {
    bool any = false;
    std::vector<Scene> list = cut.simpler(best_.scene, best_.complaint);
    for (std::size_t i = 0; i < list.size() && best_.runs < budget_;) {
      if (!takes(list[i])) {
        ++i;
        continue;
      }
      any = true;
      list = cut.simpler(best_.scene, best_.complaint);
    }
    return any;
  }

  bool spent() const { return best_.runs >= budget_; }
  Shrunk result() && { return std::move(best_); }

 private:
  bool takes(const Scene& candidate) {
    if (!tried_.insert(text_of(candidate)).second || !no_worse(candidate, start_)) return false;
    ++best_.runs;
    const auto complaint = fails_(candidate);
    if (!complaint || !(complaint->ratio >= least_)) return false;
    best_.scene = candidate;
    best_.complaint = *complaint;
    return true;
  }

  Shrunk best_;
  Contradictions start_;
  double least_;
  const Failing& fails_;
  int budget_;
  std::set<std::string> tried_;
};

}  // namespace

Shrunk shrink(const Scene& scene, const Complaint& complaint, const Failing& fails, int budget) {
  std::vector<const Cut*> cuts = Catalog<Cut>::all();
  std::ranges::stable_sort(cuts, {}, &Cut::order);
  Shrinker shrinker(scene, complaint, fails, budget);
  for (bool any = true; any && !shrinker.spent();) {
    any = false;
    for (const Cut* cut : cuts) any = shrinker.apply(*cut) || any;
  }
  return std::move(shrinker).result();
}

}  // namespace plumb
