#include "reports/study/model/least_model.h"

#include <algorithm>

namespace plumb {
namespace {

struct Candidate {
  Drop drop;
  double ratio;  // of its cost alone to that of the full model
};

Levels with(Levels levels, const Drop& drop) {
  levels[drop.feature] = drop.rung;
  return levels;
}

// A drop that is not sufficient alone would need another to make up for it: none is known to.
std::vector<Candidate> by_saving(const std::vector<Drop>& drops, const Levels& full, const Trials& trials) {
  std::vector<Candidate> candidates;
  for (const Drop& drop : drops) {
    const Levels alone = with(full, drop);
    if (trials.sufficient(alone)) candidates.push_back({drop, trials.cost_ratio(alone, full)});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.ratio < b.ratio; });
  return candidates;
}

}  // namespace

Levels least_model(const std::vector<Drop>& drops, std::size_t features, const Trials& trials) {
  Levels least(features, 0);
  const std::vector<Candidate> candidates = by_saving(drops, least, trials);
  for (const Candidate& candidate : candidates) {
    if (least[candidate.drop.feature] != 0) continue;
    const Levels lower = with(least, candidate.drop);
    if (trials.sufficient(lower) && trials.cheaper(lower, least)) least = lower;
  }
  for (std::size_t f = 0; f < features; ++f) {
    if (least[f] == 0) continue;
    Levels back = least;
    back[f] = 0;
    if (trials.sufficient(back) && !trials.cheaper(least, back)) least = back;
  }
  return least;
}

}  // namespace plumb
