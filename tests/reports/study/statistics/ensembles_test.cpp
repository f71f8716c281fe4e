#include <gmock/gmock.h>

#include "reports/run/selection.h"
#include "reports/study/statistics/verdict.h"

namespace plumb::ensembles_test {
namespace {

using ::testing::ElementsAre;

TEST(Ensembles, AreKnown) {
  std::vector<std::string> names;
  for (const Ensemble* one : Catalog<Ensemble>::all()) names.push_back(one->name);
  EXPECT_THAT(
      names, ElementsAre("domino-wave", "equipartition", "galton", "hourglass", "lyapunov", "repose", "silo", "sinai"));
}

TEST(Ensembles, HaveAQuestionSourcesAndAResolution) {
  for (const Ensemble* one : Catalog<Ensemble>::all()) {
    EXPECT_TRUE(one->question.ends_with("?")) << one->name;
    EXPECT_GT(one->large, 10 * one->runs) << one->name;
    ASSERT_FALSE(one->statistics.empty()) << one->name;
    for (const Statistic& statistic : one->statistics) {
      EXPECT_LE(statistic.low, statistic.high) << one->name;
      EXPECT_GT(statistic.resolution, 0) << one->name;
      EXPECT_FALSE(statistic.source.empty()) << one->name;
    }
  }
}

std::vector<EnsembleFinding> findings(const Ensemble& ensemble, const EngineConfig& config, int runs) {
  std::vector<EnsembleDraw> draws;
  for (int seed = 1; seed <= runs; ++seed) {
    const RunResult result = run_ensemble(ensemble, config, static_cast<std::uint64_t>(seed));
    EXPECT_EQ(result.status, Status::ok) << result.reason;
    draws.insert(draws.end(), result.draws.begin(), result.draws.end());
  }
  return judge_draws(ensemble, draws, 0.01 / 4);
}

// An ensemble, and how many runs tell its control from mechanics.
struct Enough {
  const char* ensemble;
  int runs;
};

class EveryEnsemble : public ::testing::TestWithParam<Enough> {
 protected:
  const Ensemble& ensemble() const { return *Catalog<Ensemble>::find(GetParam().ensemble); }
};

TEST_P(EveryEnsemble, DiffersForItsControlAlone) {
  const Engine control = engine_of(ensemble().control());
  EXPECT_GT(worst_difference(findings(ensemble(), {&control, complete(control, {})}, GetParam().runs)), 0);
  EXPECT_EQ(worst_difference(findings(ensemble(), parse_engine("impulse"), GetParam().runs)), 0);
}

TEST_P(EveryEnsemble, GivesTheSameDrawsForASeedAndOthersForAnother) {
  const EngineConfig config = parse_engine("chipmunk");
  const RunResult first = run_ensemble(ensemble(), config, 1);
  ASSERT_EQ(first.status, Status::ok) << first.reason;
  EXPECT_EQ(first.draws, run_ensemble(ensemble(), config, 1).draws);
  EXPECT_NE(first.draws, run_ensemble(ensemble(), config, 2).draws);
}

INSTANTIATE_TEST_SUITE_P(Ensembles, EveryEnsemble,
                         ::testing::Values(Enough{"domino-wave", 3}, Enough{"equipartition", 3}, Enough{"galton", 12},
                                           Enough{"hourglass", 5}, Enough{"lyapunov", 16}, Enough{"repose", 4},
                                           Enough{"silo", 3}, Enough{"sinai", 1}),
                         [](const auto& tested) {
                           std::string name = tested.param.ensemble;
                           std::erase(name, '-');
                           return name;
                         });

TEST(Ensembles, SayWhyAnEngineCannotRunThem) {
  const Ensemble& silo = *Catalog<Ensemble>::find("silo");
  const RunResult exact = run_ensemble(silo, parse_engine("impulse:solver=exact"), 1);
  EXPECT_EQ(exact.status, Status::not_supported);
  EXPECT_THAT(exact.reason, ::testing::HasSubstr("exact"));
  EXPECT_TRUE(exact.draws.empty());
}

TEST(Ensembles, FailWhereNothingComesToAnEnd) {
  const Engine frozen = engine_of(*Catalog<Control>::find("frozen"));
  const RunResult hanging = run_ensemble(*Catalog<Ensemble>::find("galton"), {&frozen, complete(frozen, {})}, 1);
  EXPECT_EQ(hanging.status, Status::failed);
  EXPECT_EQ(hanging.reason, "31 discs are still on the board after 30 s");
}

}  // namespace
}  // namespace plumb::ensembles_test
