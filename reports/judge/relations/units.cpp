#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "reports/judge/observe.h"
#include "reports/judge/poses.h"
#include "scenarios/catalog.h"
#include "scenarios/images.h"

namespace plumb::relations::units {
namespace {

// Mechanics has no unit of length, time or mass. With the same gravity, lengths times L and times times sqrt(L)
// (Froude) leave every equation as it is, with steps longer by sqrt(L), and masses are free. What does not scale are an
// engine's own thresholds: skin and slop, in m; the speeds below which nothing bounces, friction creeps, or bodies
// sleep. Either run may be off by what its thresholds explain; in the image they are smaller by L, and sqrt(L), beside
// the scene. An impact that a gap brings forward may be found in another step: late by the lag.
constexpr double larger = 4;    // L: its root is exact
constexpr double heavier = 10;  // masses

// A method whose only errors are its thresholds, beside a scene whose lengths are `length` times as large.
Stepping thresholds_of(const Stepping& s, double length) {
  const double speed = std::sqrt(length);
  return {.dt = s.dt,
          .h = s.contact_gap() > 0 ? s.h / speed : 0,
          .order = 2,
          .order_in_contact = s.order_in_contact,
          .impact_lag = s.impact_lag,
          .skin = s.skin / length,
          .slop = s.slop / length,
          .joint_slop = s.joint_slop / length,
          .creep = (s.creep + s.rest_speed) / speed,
          .restitution_threshold = s.restitution_threshold / speed};
}

// The threshold that explains most at a moment.
std::string largest_of(const RelationRun& run, const Stepping& all, std::size_t moment, std::size_t body) {
  const std::pair<const char*, Stepping> each[] = {
      {"skin and slop of contacts", {.dt = all.dt, .skin = all.skin, .slop = all.slop}},
      {"slop of joints", {.dt = all.dt, .joint_slop = all.joint_slop}},
      {"speed of creep or sleep", {.dt = all.dt, .creep = all.creep}},
      {"speed below which nothing bounces", {.dt = all.dt, .restitution_threshold = all.restitution_threshold}}};
  std::string name;
  double most = 0;
  for (const auto& [what, stepping] : each) {
    const double here = run.amplification.of_method(stepping, moment, body).value_or(0);
    if (here <= most) continue;
    most = here;
    name = what;
  }
  return name;
}

RelationCheck compare(const RelationRun& run, std::span<const RelationRun> images) {
  const RelationRun& image = images.front();
  const auto poses = [&](std::size_t moment, std::size_t body) {
    BodyState state = image.trace.states(moment)[body];
    state.position = {state.position.x / larger, state.position.y / larger};
    return state;
  };
  std::vector<double> of_image = pose_rounding(image);
  for (double& one : of_image) one /= larger;
  const std::vector<double> rounding = sum_of(pose_rounding(run), of_image);
  const Stepping here = thresholds_of(run.stepping, 1);
  const Stepping there = thresholds_of(image.stepping, larger);
  std::vector<Allowance> allowances = explained_by_rounding(run, rounding);
  allowances.back() = explained_by_method(run, rounding, here, there).back();
  allowances.back().reason = "round-off and the engine's thresholds, as this scene amplifies them";
  const double gaps = here.contact_gap() + here.joint_slop;
  allowances.push_back(decided_otherwise(run, allowances.back(), rounding, rounding.back() + gaps));
  RelationCheck result = compare_poses(run, std::min(run.trace.size(), image.trace.size()), poses, allowances);
  if (!result.why_not.empty() || result.check.value <= rounding.back()) return result;
  const std::size_t moment = run.trace.bracket(result.check.time).before;
  const std::string name = largest_of(run, here, moment, index_of(run.scene, result.check.where));
  if (!name.empty()) result.check.detail += fmt::format("; of the thresholds, most by the {}", name);
  return result;
}

const Catalog<MetamorphicRelation>::Entry entry{
    {.name = "units",
     .unit = "m",
     .definition = "four times as long, in twice the time, ten times as heavy, a scene moves in the same way, but for "
                   "round-off and the engine's own thresholds",
     .excludes = [](const Scene&, const Stepping&) { return ""; },
     .images = [](const Scene& scene, const Trace&, double dt) -> std::vector<Image> {
       return {
           {in_units(scene, {.length = larger, .mass = heavier, .time = std::sqrt(larger)}), dt * std::sqrt(larger)}};
     },
     .compare = compare}};

}  // namespace
}  // namespace plumb::relations::units
