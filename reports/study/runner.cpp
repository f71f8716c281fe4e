#include "reports/study/runner.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "reports/timing/repetitions.h"

namespace plumb {
namespace {

using Children = std::vector<std::unique_ptr<Child>>;

struct Interrupted {};

PointResult result_of(const Child& child) {
  PointResult result = child.result();
  const std::size_t repetitions = child.repetitions().counted().size();
  if (repetitions == 0) return result;
  const Quartiles of = child.repetitions().spread();
  result.row.times["median"] = of.median;
  result.row.times["low"] = of.low;
  result.row.times["high"] = of.high;
  result.row.times["repetitions"] = repetitions;
  result.row.times["wide"] = child.repetitions().wide();
  return result;
}

class Runner {
 public:
  explicit Runner(const Execution& how) : how_(how) {}

  // Runs the points, up to `jobs` at once; `finished` is handed each child that has nothing more to do but turns.
  void run(std::span<const Point* const> points, int jobs,
           const std::function<void(std::unique_ptr<Child>)>& finished) const {
    Children working;
    for (std::size_t next = 0; next < points.size() || !working.empty();) {
      while (next < points.size() && working.size() < static_cast<std::size_t>(std::max(jobs, 1))) {
        if (points[next]->prepare) points[next]->prepare();
        working.push_back(std::make_unique<Child>(*points[next++]));
      }
      attend(working);
      const auto idle =
          std::stable_partition(working.begin(), working.end(), [](const auto& one) { return one->busy(); });
      std::for_each(idle, working.end(), [&](auto& one) { finished(std::move(one)); });
      working.erase(idle, working.end());
    }
  }

  void take_turns(Children& children) const {
    repeat_until_settled(children.size(), [&](std::size_t i) {
      const std::span<const std::unique_ptr<Child>> one(&children[i], 1);
      if (!one[0]->ready() || one[0]->repetitions().settled()) return false;
      one[0]->take_turn();
      while (one[0]->busy()) attend(one);
      return true;
    });
  }

 private:
  void attend(std::span<const std::unique_ptr<Child>> children) const {
    Child::attend(children, how_.limits);
    if (how_.interrupted()) throw Interrupted{};
  }

  const Execution& how_;
};

bool takes_turns(std::span<const Point> unit) {
  return std::any_of(unit.begin(), unit.end(), [](const Point& point) { return point.turn != nullptr; });
}

bool needs_all(std::span<const Point> unit) {
  return takes_turns(unit) || std::any_of(unit.begin(), unit.end(), [](const Point& point) { return point.alone; });
}

}  // namespace

std::vector<std::span<const Point>> units_of(std::span<const Point> points) {
  std::vector<std::span<const Point>> units;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i + 1;
    while (!points[i].group.empty() && end < points.size() && points[end].group == points[i].group) ++end;
    units.push_back(points.subspan(i, end - i));
    i = end;
  }
  return units;
}

bool execute(std::span<const std::span<const Point>> units, const Execution& how,
             const std::function<void(std::span<const PointResult>)>& keep) {
  const Runner runner(how);
  const auto keep_one = [&](const std::unique_ptr<Child>& child) {
    const PointResult result = result_of(*child);
    keep({&result, 1});
  };
  try {
    for (std::size_t i = 0; i < units.size();) {
      std::vector<const Point*> points;
      if (!needs_all(units[i])) {
        for (; i < units.size() && !needs_all(units[i]); ++i) {
          for (const Point& point : units[i]) points.push_back(&point);
        }
        runner.run(points, how.jobs, keep_one);
        continue;
      }
      for (const Point& point : units[i]) points.push_back(&point);
      const bool timed = takes_turns(units[i++]);
      Children children;
      runner.run(points, timed ? how.jobs : 1,
                 [&](std::unique_ptr<Child> child) { children.push_back(std::move(child)); });
      // By the point's place, not by who was first: the turns' order hangs on no chance.
      std::sort(children.begin(), children.end(),
                [](const auto& a, const auto& b) { return &a->point() < &b->point(); });
      runner.take_turns(children);
      std::vector<PointResult> results;
      std::transform(children.begin(), children.end(), std::back_inserter(results),
                     [](const auto& child) { return result_of(*child); });
      keep(results);
    }
  } catch (const Interrupted&) {
    return false;
  }
  return true;
}

}  // namespace plumb
