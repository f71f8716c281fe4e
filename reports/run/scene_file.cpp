#include "reports/run/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "reference/scene_facts.h"
#include "reports/judge/mechanics.h"
#include "reports/judge/observe.h"
#include "reports/judge/overlap.h"
#include "reports/run/catalog_case.h"
#include "reports/system/files.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/vec.h"
#include "scenarios/tracker/reported.h"

namespace plumb {
namespace {

bool same_question(const Expectation& one, const StatedTruth& truth) {
  return one.body == truth.body && one.other == truth.with && one.quantity == truth.quantity &&
         one.relation == truth.relation && one.time == truth.time && one.over == truth.over && one.index == truth.index;
}

// Whatever they are called.
bool same_scene(Scene a, const Scene& b) {
  a.name = b.name;
  a.about = b.about;
  return write_scene({a, {}}) == write_scene({b, {}});
}

// The expectations of a scene file.
struct FileExpectations {
  std::vector<Expectation> all;
  bool phased = false;               // whether a tolerance is of a scenario that is
  std::map<std::string, int> stale;  // truths of a case of the catalogue whose scene is another by now, by its name
};

// The case of the catalogue whose tolerance a truth takes.
Case named_case(const StatedTruth& truth, const std::string& context) {
  if (Catalog<Scenario>::find(truth.tolerance_of.substr(0, truth.tolerance_of.find(':'))) == nullptr)
    throw std::invalid_argument(context + "is no scenario; see plumb list");
  return catalog_case(truth.tolerance_of);
}

// Takes the tolerance of the case that a truth names, whose value is that of its scene.
void add_with_tolerance(Expectation expectation, const StatedTruth& truth, const std::string& place, const Scene& scene,
                        FileExpectations& into) {
  const std::string context = place + ".toleranceOf: \"" + truth.tolerance_of + "\" ";
  const Case of = named_case(truth, context);
  auto asked = of.scenario->expectations(of.parameters);
  const auto same = std::ranges::find_if(asked, [&](const Expectation& one) { return same_question(one, truth); });
  if (same == asked.end())
    throw std::invalid_argument(context + "does not ask for this quantity of this body at this time: give a tolerance");
  if (!same_scene(*of.scene, scene)) {
    ++into.stale[truth.tolerance_of];
    return;
  }
  expectation.allowed = std::move(same->allowed);
  expectation.within = same->within;
  into.phased = into.phased || of.scenario->phased;
  into.all.push_back(std::move(expectation));
}

FileExpectations expectations_of(const SceneFile& file, std::string_view name) {
  FileExpectations found;
  for (std::size_t i = 0; i < file.truth.size(); ++i) {
    const StatedTruth& truth = file.truth[i];
    Expectation expectation{.body = truth.body,
                            .other = truth.with,
                            .quantity = truth.quantity,
                            .relation = truth.relation,
                            .time = truth.time,
                            .over = truth.over,
                            .index = truth.index,
                            .expected = truth.value,
                            .within = truth.tolerance,
                            .source = truth.source};
    if (truth.tolerance_of.empty()) {
      found.all.push_back(std::move(expectation));
    } else {
      add_with_tolerance(std::move(expectation), truth, fmt::format("{}: truth[{}]", name, i), file.scene, found);
    }
  }
  return found;
}

std::vector<std::string> in_words(const std::map<std::string, int>& stale) {
  std::vector<std::string> all;
  for (const auto& [name, count] : stale) {
    all.push_back(
        fmt::format("truth: this scene differs from {}, whose values ({}) are left out; state your own, each "
                    "with a tolerance",
                    name, count));
  }
  return all;
}

// The stated truths that the closed form contradicts, as after a change of the scene.
std::vector<std::string> contradicted(const std::vector<StatedTruth>& stated, const Scene& scene,
                                      const Engine& closed_form) {
  std::vector<std::string> all;
  const Truth truth(closed_form, scene);
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const StatedTruth& one = stated[i];
    const bool of_a_moment = one.quantity < Quantity::load && one.over == 0 && one.index == 0;
    if (!of_a_moment || one.relation != Relation::equal || !one.tolerance_of.empty()) continue;
    const Expectation asked{.body = one.body, .quantity = one.quantity, .time = one.time};
    const auto known = expected_value(scene, asked, &truth, one.time.value_or(scene.duration));
    if (!known || std::abs(*known - one.value) <= one.tolerance) continue;
    all.push_back(fmt::format("truth[{}].value: {:.6g}, but {:.6g} by the closed form \"{}\": was the scene changed?",
                              i, one.value, *known, closed_form.name));
  }
  return all;
}

std::optional<double> expected_in(const Case& test_case, const Expectation& expectation) {
  const Scene& scene = *test_case.scene;
  std::optional<Truth> truth;
  if (test_case.closed_form != nullptr && !expectation.expected) truth.emplace(*test_case.closed_form, scene);
  return expected_value(scene, expectation, truth ? &*truth : nullptr, expectation.time.value_or(scene.duration));
}

// NaN if it is not known: a closed form knows the states of a moment only.
double value_of(const Case& test_case, const Expectation& expectation) {
  constexpr double unknown_value = std::numeric_limits<double>::quiet_NaN();
  if (!expectation.expected && expectation.quantity >= Quantity::load) return unknown_value;
  return expected_in(test_case, expectation).value_or(unknown_value);
}

Case case_of_text(std::string_view text, std::string_view name, const std::string& variant) {
  SceneFile file = read_scene(text, name);
  FileExpectations expected = expectations_of(file, name);
  const auto scene = std::make_shared<const Scene>(std::move(file.scene));
  const Engine* closed_form = find_closed_form(*scene);
  std::vector<std::string> doubts = in_words(expected.stale);
  if (closed_form != nullptr)
    std::ranges::move(contradicted(file.truth, *scene, *closed_form), std::back_inserter(doubts));
  const auto scenario = std::make_shared<const Scenario>(
      Scenario{.name = scene->name,
               .question = file.source.empty() ? scene->about : scene->about + " (" + file.source + ")",
               .variants = {{.label = variant}},
               .closed_form = closed_form == nullptr ? "" : closed_form->name,
               .scene = [scene](const Parameters&) { return *scene; },
               .expectations = [all = std::move(expected.all)](const Parameters&) { return all; },
               .phased = expected.phased});
  return {.scenario = scenario.get(),
          .variant = variant,
          .scene = scene,
          .closed_form = closed_form,
          .from_file = scenario,
          .doubts = std::move(doubts)};
}

}  // namespace

bool is_scene_file(std::string_view word) {
  std::error_code ignored;
  return word.ends_with(".json") ||
         (word.find('/') != word.npos && std::filesystem::exists(std::filesystem::path(word), ignored));
}

const Engine* find_closed_form(const Scene& scene) {
  const Engine* longest = nullptr;
  double until = 0;
  for (const Engine* engine : Catalog<Engine>::all()) {
    if (!engine->exact || !engine->unsupported(scene, complete(*engine, {})).empty()) continue;
    const double valid = std::min(Truth(*engine, scene).until(), scene.duration);
    if (longest != nullptr && valid <= until) continue;
    longest = engine;
    until = valid;
  }
  return longest;
}

Case case_of_file(const std::string& path) { return case_of_text(read_text(path, largest_scene_file), path, path); }

SceneFile scene_file_of(const std::string& word) {
  constexpr std::string_view prefix = "tracker:";
  if (is_scene_file(word)) return read_scene(read_text(word, largest_scene_file), word);
  if (word.starts_with(prefix)) {
    for (const ReportedScene& scene : reported_scenes()) {
      if (scene.name == std::string_view(word).substr(prefix.size())) return read_scene(scene.text, scene.name);
    }
  }
  throw std::invalid_argument(word + " is no scene file");
}

std::vector<Case> reported_cases() {
  std::vector<Case> cases;
  for (const ReportedScene& scene : reported_scenes())
    cases.push_back(case_of_text(scene.text, scene.name, std::string(tracker)));
  return cases;
}

StatedTruths truths_of(const Case& test_case) {
  StatedTruths stated;
  const std::string word = test_case.scenario->name + (test_case.variant.empty() ? "" : ":" + test_case.variant);
  for (const Expectation& expectation : test_case.scenario->expectations(test_case.parameters)) {
    const std::string what = (expectation.body.empty() ? "" : expectation.body + " ") + name_of(expectation.quantity);
    const double value = value_of(test_case, expectation);
    if (!std::isfinite(value)) {
      stated.left_out.push_back(what + ": the closed form is not valid that long");
      continue;
    }
    stated.truth.push_back({.body = expectation.body,
                            .quantity = expectation.quantity,
                            .time = expectation.time,
                            .value = value,
                            .tolerance = expectation.within.value_or(0),
                            .tolerance_of = expectation.within ? "" : word,
                            .source = expectation.source,
                            .relation = expectation.relation,
                            .over = expectation.over,
                            .index = expectation.index,
                            .with = expectation.other});
  }
  return stated;
}

namespace {

// Of one kind; more would hide what else there is.
constexpr std::size_t most_warnings = 5;

// Adds at most so many warnings, and how many more there are.
class Warnings {
 public:
  explicit Warnings(std::vector<std::string>& all) : all_(all) {}
  Warnings(const Warnings&) = delete;
  Warnings& operator=(const Warnings&) = delete;
  ~Warnings() {
    if (count_ > most_warnings) all_.push_back(fmt::format("and {} more like that", count_ - most_warnings));
  }
  void add(const std::string& text) {
    if (++count_ <= most_warnings) all_.push_back(text);
  }

 private:
  std::vector<std::string>& all_;
  std::size_t count_ = 0;
};

std::string place_of(const Scene& scene, std::size_t body) {
  return fmt::format("bodies[{}] (\"{}\")", body, scene.bodies[body].name);
}

// Pairs of bodies whose discs around them meet at the start, counted up to `most`: those that are tried at every step.
std::size_t close_pairs(const Scene& scene, const std::vector<BodyState>& states, std::size_t most) {
  struct Disc {
    double left, right;
    std::size_t body;
  };
  std::vector<Disc> discs;
  std::vector<double> radii;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    radii.push_back(bounding_radius(scene.bodies[i]));
    discs.push_back({states[i].position.x - radii[i], states[i].position.x + radii[i], i});
  }
  std::ranges::sort(discs, {}, &Disc::left);
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size() && discs[j].left <= discs[i].right; ++j) {
      const std::size_t a = discs[i].body;
      const std::size_t b = discs[j].body;
      if (length(states[a].position - states[b].position) > radii[a] + radii[b]) continue;
      if (++pairs == most) return pairs;
    }
  }
  return pairs;
}

constexpr std::size_t many_pairs = 100'000;  // a second or so a step
constexpr std::size_t many_shapes = 3'000;

void warn_of_size(const Scene& scene, std::size_t pairs, std::vector<std::string>& all) {
  Warnings warnings(all);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].shapes.size() < many_shapes) continue;
    warnings.add(
        fmt::format("{}: has {} shapes: a run may take minutes", place_of(scene, i), scene.bodies[i].shapes.size()));
  }
  if (pairs == many_pairs) warnings.add("bodies: most start in one place: a run may take minutes");
}

void warn_of_overlaps(const Scene& scene, const std::vector<BodyState>& states, std::vector<std::string>& all) {
  constexpr double share = 0.01;  // of the smaller body; less may be meant, or rounding
  Warnings warnings(all);
  for (const BodyOverlap& one : Overlap(scene).all(states)) {
    const auto size = [&](std::size_t body) {
      const double radius = bounding_radius(scene.bodies[body]);
      return radius > 0 ? radius : HUGE_VAL;  // a half-space has none
    };
    if (one.depth <= share * std::min(size(one.a), size(one.b))) continue;
    warnings.add(
        fmt::format("{}: starts {:.3g} m inside {}", place_of(scene, one.b), one.depth, place_of(scene, one.a)));
  }
}

void warn_of_angles(const Scene& scene, std::vector<std::string>& all) {
  Warnings warnings(all);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const double angle = scene.bodies[i].angle;
    if (std::abs(angle) <= 2 * std::numbers::pi) continue;
    warnings.add(
        fmt::format("{}.angle: {:g} is more than a full turn; angles are in radians, and {:g} degrees are {:.6g}",
                    place_of(scene, i), angle, angle, angle * std::numbers::pi / 180));
  }
}

// Densities per volume, kg/m^3, begin there; a scene in metres and kilograms has about 1 kg/m^2.
void warn_of_densities(const Scene& scene, std::vector<std::string>& all) {
  constexpr double per_volume = 500;
  Warnings warnings(all);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const auto heavy =
        std::ranges::find_if(body.shapes, [](const Shape& one) { return one.surface.density >= per_volume; });
    if (body.type != BodyType::dynamic || heavy == body.shapes.end()) continue;
    warnings.add(fmt::format("{}.shapes[{}].density: {:g} kg/m^2 is per area; 1000 is that of water per volume",
                             place_of(scene, i), heavy - body.shapes.begin(), heavy->surface.density));
  }
}

void warn_of_joints(const Scene& scene, std::vector<std::string>& all) {
  constexpr double share = 0.01;  // of the length
  Warnings warnings(all);
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const JointFacts facts = facts_of(scene.joints[i]);
    if (facts.keeps != JointFacts::Keeps::rod) continue;
    const double apart = length(facts.anchor_b - facts.anchor_a);
    if (std::abs(apart - facts.length) <= share * facts.length) continue;
    warnings.add(
        fmt::format("joints[{}].length: is {:g} m, but the anchors start {:g} m apart", i, facts.length, apart));
  }
}

}  // namespace

std::vector<std::string> warnings_about(const Scene& scene) {
  std::vector<std::string> all;
  const std::vector<BodyState> states = initial_states(scene);
  const std::size_t pairs = close_pairs(scene, states, many_pairs);
  std::size_t shapes = 0;
  for (const Body& body : scene.bodies) shapes += body.shapes.size();
  warn_of_size(scene, pairs, all);
  if (pairs < many_pairs && shapes < many_shapes) warn_of_overlaps(scene, states, all);
  warn_of_angles(scene, all);
  warn_of_densities(scene, all);
  warn_of_joints(scene, all);
  return all;
}

}  // namespace plumb
