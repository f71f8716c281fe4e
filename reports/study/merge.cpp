#include "reports/study/merge.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <stdexcept>

#include "reports/study/runner.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

struct Part {
  fs::path path;
  KeptResults kept;
};

const Study& study_of(const Part& part) {
  const std::string& name = part.kept.head.study;
  if (const Study* study = Catalog<Study>::find(name)) return *study;
  std::vector<std::string> names;
  for (const Study* study : Catalog<Study>::all()) names.push_back(study->name);
  throw std::invalid_argument(part.path.string() + ": " + unknown("study", name, names));
}

class Complaints {
 public:
  template <class... Arguments>
  void add(fmt::format_string<Arguments...> what, Arguments&&... arguments) {
    text_ += (text_.empty() ? "" : "\n") + fmt::format(what, std::forward<Arguments>(arguments)...);
  }
  void raise() const {
    if (!text_.empty()) throw std::invalid_argument(text_);
  }

 private:
  std::string text_;
};

void check_points(const Part& part, const std::vector<std::span<const Point>>& share, Complaints& wrong) {
  std::set<std::string> own;
  for (const auto& unit : share) {
    for (const Point& point : unit) own.insert(point.key);
  }
  for (const auto& [key, result] : part.kept.results) {
    if (!own.contains(key))
      wrong.add("{}: \"{}\" is not of shard {}", part.path.string(), key, part.kept.head.shard.name());
  }
  std::size_t missing = 0;
  std::string first;
  for (const std::string& key : own) {
    if (!part.kept.results.contains(key) && missing++ == 0) first = key;
  }
  if (missing > 0) {
    wrong.add("{}: {} of {} points are missing, the first \"{}\"; its command with --resume finds them out",
              part.path.string(), missing, own.size(), first);
  }
}

// Times of shards that ran on different machines stand side by side: the report names all.
void add_place(const ResultsHead& from, ResultsHead& to) {
  for (const char* key : {"system", "processor", "processors"}) {
    std::string& here = to.environment[key];
    const auto there = from.environment.find(key);
    if (there == from.environment.end() || (", " + here + ",").find(", " + there->second + ",") != std::string::npos)
      continue;
    here += (here.empty() ? "" : ", ") + there->second;
  }
}

}  // namespace

Merged merge(const std::vector<fs::path>& files) {
  std::vector<Part> parts;
  for (const fs::path& path : files) parts.push_back({path, read_results(path)});
  if (parts.empty()) throw std::invalid_argument("there is nothing to merge");

  Merged merged{.study = &study_of(parts.front()), .head = parts.front().kept.head};
  const Shard first = merged.head.shard;
  Complaints wrong;
  std::map<int, fs::path> found;
  for (const Part& part : parts) {
    const ResultsHead& head = part.kept.head;
    const std::string foreign = head.foreign_to(merged.head);
    if (!foreign.empty()) {
      wrong.add("{} does not belong to {}: it is of {}", part.path.string(), parts.front().path.string(), foreign);
    } else if (head.shard.n != first.n) {
      wrong.add("{} is shard {}, {} is shard {}: they overlap", part.path.string(), head.shard.name(),
                parts.front().path.string(), first.name());
    } else if (const auto [other, added] = found.emplace(head.shard.k, part.path); !added) {
      wrong.add("{} and {} are both shard {}", other->second.string(), part.path.string(), head.shard.name());
    }
  }
  wrong.raise();
  for (int k = 1; k <= first.n; ++k) {
    if (!found.contains(k)) wrong.add("shard {} is missing", Shard{k, first.n}.name());
  }
  merged.plan = merged.study->plan(merged.head.configuration);
  if (plan_hash(merged.plan.points) != merged.head.plan) {
    throw std::invalid_argument(parts.front().path.string() +
                                ": this program plans other points for that configuration: another version made it");
  }
  const auto units = units_of(merged.plan.points);
  for (const Part& part : parts) check_points(part, share_of(part.kept.head.shard, units), wrong);
  wrong.raise();

  std::map<std::string, PointResult> results;
  for (Part& part : parts) {
    add_place(part.kept.head, merged.head);
    results.merge(part.kept.results);
  }
  for (const Point& point : merged.plan.points) merged.results.push_back(results.at(point.key));
  merged.head.shard = {};
  merged.head.points = merged.results.size();
  return merged;
}

}  // namespace plumb
