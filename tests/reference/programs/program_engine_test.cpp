#include "reference/programs/program_engine.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "faults.h"
#include "reports/run/run.h"
#include "reports/run/selection.h"

// Engines that are programs, and every way in which one may misbehave.
namespace plumb::program_engine_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double dt = 1.0 / 60;

std::string faulty(const std::string& fault, const std::string& settings = "") {
  return faulty_program(PLUMB_SOURCE_DIR, fault) + settings;
}

Scene one_disc() {
  return {.name = "one disc",
          .duration = 0.5,
          .bodies = {{.name = "disc", .position = {0, 5}, .shapes = {{Circle{}, {1, 0.5, 0.5, 0}}}}}};
}

Outcome outcome_of(const std::string& word) { return run(one_disc(), parse_engine(word), dt); }

class FaultyProgram : public testing::TestWithParam<ProgramFault> {};

TEST_P(FaultyProgram, FailsItsRunAndNoOther) {
  const Outcome outcome = outcome_of(faulty(GetParam().name, std::string(":timeout=") + GetParam().timeout));
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_THAT(outcome.reason, HasSubstr(GetParam().reason));
  EXPECT_EQ(outcome_of(faulty("none")).status, Status::ok);
}

INSTANTIATE_TEST_SUITE_P(All, FaultyProgram, testing::ValuesIn(program_faults), [](const auto& instance) {
  std::string name = instance.param.name;
  std::erase(name, '-');
  return name;
});

TEST(ProgramEngine, IsRefusedIfItDoesNotSayWhoItIs) {
  const auto refusal = [](const std::string& word) -> std::string {
    try {
      parse_engine(word);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal("exec:/no/such/program"), HasSubstr("could not be started"));
  EXPECT_THAT(refusal("exec:true"), HasSubstr("asked who it is, it ended with exit code 0"));
  EXPECT_THAT(refusal(faulty("other-protocol")), HasSubstr("1, the version of the protocol"));
  EXPECT_THAT(refusal(faulty("name-with-space")), HasSubstr("must be a name without space"));
  EXPECT_THAT(refusal("exec:cat"), HasSubstr("its answer"));
}

TEST(ProgramEngine, RunsAndMayRefuseAScene) {
  const Outcome still = outcome_of(faulty("none"));
  EXPECT_EQ(still.status, Status::ok);
  EXPECT_EQ(still.trace->size(), 31u);
  EXPECT_NEAR(still.stepping, 30e-9, 1e-12) << "30 steps of 1 ns, by its own clock";
  const Outcome refused = outcome_of(faulty("refuses"));
  EXPECT_EQ(refused.status, Status::not_supported);
  EXPECT_EQ(refused.reason, "too round");
}

TEST(ProgramEngine, MayPackItsNumbers) {
  const Outcome packed = outcome_of(faulty("packed"));
  ASSERT_EQ(packed.status, Status::ok) << packed.reason;
  const BodyState last = packed.trace->states(packed.trace->size() - 1)[0];
  EXPECT_EQ(last.position.y, 5);
  EXPECT_EQ(last.velocity.y, 0);
}

TEST(ProgramEngine, MayWriteALogOfAnyLength) { EXPECT_EQ(outcome_of(faulty("logs-a-lot")).status, Status::ok); }

TEST(ProgramEngine, HasItsOwnOptionsAndLimits) {
  EXPECT_EQ(parse_engine(faulty("none", ":knob=2")).settings.at("knob"), "2");
  EXPECT_EQ(parse_engine(faulty("none")).settings.at("timeout"), "10");
  EXPECT_THROW(parse_engine(faulty("none", ":knob=3")), std::invalid_argument);
}

TEST(ProgramEngine, BearsItsVersionIfItsNameIsTaken) {
  const std::string first = parse_engine(faulty("none")).engine->name;
  const std::string second = parse_engine(faulty("refuses")).engine->name;
  EXPECT_NE(first, second);
  EXPECT_EQ(parse_engine(faulty("none")).engine->name, first);
  EXPECT_EQ(known_program(second), parse_engine(faulty("refuses")).engine);
  EXPECT_EQ(known_program("nobody"), nullptr);
}

// Every engine that Plumb comes with, as itself and through `plumb engine serve`.
TEST(IsolatedEngine, MovesToTheSameBits) {
  Scene scene = one_disc();
  scene.bodies.push_back(
      {.name = "ground", .type = BodyType::fixed, .position = {0, 4}, .shapes = {{HalfSpace{}, {1, 0.5, 0.5, 0.5}}}});
  for (const EngineConfig& own : default_engines()) {
    const std::string label = own.engine->name + ':' + own.method();
    const std::string word = "exec:" PLUMB_PROGRAM " engine serve " + own.engine->name;
    const EngineConfig served = parse_engine(own.method().empty() ? word : word + ':' + own.method());
    EXPECT_THAT(served.engine->name, testing::StartsWith(own.engine->name + '@')) << label;
    EXPECT_EQ(served.engine->caveats, own.engine->caveats) << label;
    const Outcome a = run(scene, own, dt);
    const Outcome b = run(scene, served, dt);
    ASSERT_EQ(a.status, Status::ok) << label << ": " << a.reason;
    ASSERT_EQ(b.status, Status::ok) << label << ": " << b.reason;
    ASSERT_EQ(a.trace->size(), b.trace->size());
    for (std::size_t moment = 0; moment < a.trace->size(); ++moment) {
      EXPECT_EQ(a.trace->states(moment)[0].position, b.trace->states(moment)[0].position) << label;
      EXPECT_EQ(a.trace->states(moment)[0].velocity, b.trace->states(moment)[0].velocity) << label;
      EXPECT_EQ(a.trace->contacts(moment).size(), b.trace->contacts(moment).size()) << label;
    }
  }
}

}  // namespace
}  // namespace plumb::program_engine_test
