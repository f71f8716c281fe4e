#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reports/prove/detection.h"
#include "reports/run/selection.h"
#include "scenarios/random.h"

// The catalogue's variants were chosen; parameters that nobody chose are drawn from one seed, over all families.
namespace plumb::random_parameters_test {
namespace {

constexpr std::uint64_t seed = 20261123;
constexpr double dt = 1.0 / 60;    // s
constexpr double largest = 6'000;  // steps of a shape in a case, all phases together

// Of each family. PLUMB_DRAWS: fewer, where what counts is that they run, not what is found.
constexpr int all_draws = 3;
int draws() {
  const char* chosen = std::getenv("PLUMB_DRAWS");
  return chosen == nullptr ? all_draws : std::clamp(std::atoi(chosen), 1, all_draws);
}

// Uniform, or uniform in the logarithm where the range spans more than a factor of 20.
double drawn(const Parameter& of, Random& random) {
  const bool wide = of.min > 0 && of.max > 20 * of.min;
  const double value = wide ? of.min * std::exp(random.between(0, std::log(of.max / of.min)))
                            : random.between(of.min, of.max + (of.whole ? 1 : 0));
  return of.whole ? std::min(std::floor(value), of.max) : value;
}

double cost(const Case& one) {
  std::size_t shapes = 0;
  for (const Body& body : one.scene->bodies) shapes += body.shapes.size();
  const double phases = one.scenario->phased ? judged_phases : 1;
  return static_cast<double>(shapes * steps_in(one.scene->duration, dt)) * phases;
}

// "NAME:parameter=value,...", as `plumb run` takes it: the first of fifty draws that is cheap enough, or the cheapest.
std::string drawn_case(const Scenario& family, Random& random) {
  std::string cheapest;
  double least = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 50 && least > largest; ++attempt) {
    std::string word = family.name;
    for (const Parameter& parameter : family.parameters) {
      word += fmt::format("{}{}={}", word == family.name ? ':' : ',', parameter.name, drawn(parameter, random));
    }
    if (const double its = cost(parse_case(word)); its < least) {
      least = its;
      cheapest = word;
    }
  }
  return cheapest;
}

// Each family has numbers of its own, so that a new family leaves the others' cases as they are. FNV-1a of the name.
std::uint64_t seed_of(const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return seed ^ hash;
}

std::vector<std::string> drawn_cases() {
  std::vector<std::string> words;
  for (const Scenario* family : Catalog<Scenario>::all()) {
    Random random(seed_of(family->name));
    for (int i = 0; i < draws(); ++i) words.push_back(drawn_case(*family, random));
  }
  return words;
}

std::vector<std::string> wrong_by(const std::string& engine) {
  const EngineConfig config = parse_engine(engine);
  std::vector<std::string> wrong;
  for (const std::string& word : drawn_cases()) {
    const Case one = parse_case(word);
    const JudgedRun run = judge_run(one, config, dt, run_case(one, config, dt), CaseTruth(one, dt, 0));
    if (run.status == Status::failed || (run.status == Status::ok && run.judgement.verdict == Verdict::wrong)) {
      wrong.push_back(word);
    }
  }
  return wrong;
}

std::set<std::string> families_of(const std::vector<std::string>& words) {
  std::set<std::string> names;
  for (const std::string& word : words) names.insert(word.substr(0, word.find(':')));
  return names;
}

TEST(RandomParameters, AreDrawnFromEveryFamily) {
  EXPECT_EQ(families_of(drawn_cases()).size(), Catalog<Scenario>::all().size());
  EXPECT_GE(drawn_cases().size() * all_draws / draws(), 200u);
}

// `plumb run` takes the words that a failure prints.
TEST(RandomParameters, FindNothingWrong) {
  for (const char* engine : {"impulse", "impulse:precision=float"}) {
    EXPECT_THAT(wrong_by(engine), testing::IsEmpty()) << engine;
  }
}

// A control: without gravity, most of what falls, slides or rolls is wrong.
TEST(RandomParameters, FindAnEngineWithoutGravityWrong) {
  int wrong = 0;
  for (const std::string& word : drawn_cases()) {
    const Case one = parse_case(word);
    if (one.scene->duration > 2 || cost(one) > largest) continue;
    Case altered = one;
    Scene scene = *one.scene;
    scene.gravity = {};
    altered.scene = std::make_shared<const Scene>(scene);
    const EngineConfig config = parse_engine("impulse");
    const CaseRun run = run_case(altered, config, dt);
    if (judge_run(one, config, dt, run, CaseTruth(one, dt, 0)).judgement.verdict == Verdict::wrong) ++wrong;
  }
  EXPECT_GT(wrong, 30);
}

}  // namespace
}  // namespace plumb::random_parameters_test
