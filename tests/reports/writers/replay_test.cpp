#include "reports/writers/replay.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "sample.h"
#include "unpacking.h"

namespace plumb::replay_test {
namespace {

using Json = nlohmann::ordered_json;

// Two wheels over a floor; the second touches it for a while, twice.
Report rolling(int moments) {
  const auto scene = std::make_shared<const Scene>(
      Scene{.bodies = {{.name = "floor", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}},
                       {.name = "a", .shapes = {{.geometry = Circle{.radius = 0.25}}}},
                       {.name = "b", .shapes = {{.geometry = Circle{.radius = 1}}}}}});
  const auto trace = std::make_shared<Trace>(3);
  for (int i = 0; i < moments; ++i) {
    const double t = i / 60.0;
    const std::vector<BodyState> states{{},
                                        {.position = {3 * std::cos(t), 2 + std::sin(t)}, .angle = 5 * t},
                                        {.position = {4 * t, 1 - 0.01 * (i == 7)}}};
    std::vector<ContactState> contacts;
    if (i >= 3 && i < 6) contacts.push_back({2, 0, {4 * t, 0}, {0, -1}, 2, 0.5, 0});
    if (i == 9) contacts.push_back({0, 2, {4 * t, 0}, {0, 1}, 1, 0, 0});
    trace->record(t, states, contacts);
  }
  RunRecord run{.scenario = "roll", .variant = "v", .engine = "e", .method = "m", .scene = scene, .trace = trace};
  return {.runs = {run}};
}

Json run_of(const Report& report, const ReplayLimits& limits = {}) {
  return replays_of(run_curves(report), limits)[0]["runs"][0];
}

TEST(Replay, PosesAreWithinHalfAStepOfTheTrace) {
  const Report report = rolling(200);
  const Trace& trace = *report.runs[0].trace;
  const Json run = run_of(report);
  ASSERT_EQ(run["moments"], 200u);
  const double length = run["length"];
  const double angle = run["angle"];
  EXPECT_LE(length, position_share * 17.6) << "of what the run covers: from -3.25 to 14.27 m";
  EXPECT_LE(angle * 1, length * (1 + 1e-12)) << "at the rim of the larger wheel";
  Reading reading(unpacked(run["poses"].get<std::string>()));
  const auto times = reading.smooth(200, 1e-6);
  for (std::size_t i = 0; i < 200; ++i) ASSERT_NEAR(times[i], trace.time(i), 0.5e-6 * (1 + 1e-6));
  // Rounding off half a step, and that of the products with it.
  const double slack = 1 + 1e-9;
  for (std::size_t body = 0; body < 3; ++body) {
    const auto x = reading.smooth(200, length);
    const auto y = reading.smooth(200, length);
    const auto turned = reading.smooth(200, angle);
    for (std::size_t i = 0; i < 200; ++i) {
      const BodyState& state = trace.states(i)[body];
      ASSERT_LE(std::abs(x[i] - state.position.x), slack * length / 2);
      ASSERT_LE(std::abs(y[i] - state.position.y), slack * length / 2);
      ASSERT_LE(std::abs(turned[i] - state.angle), slack * angle / 2);
    }
  }
  for (int part = 0; part < 3; ++part) reading.smooth(200, run["energy"]);
  EXPECT_TRUE(reading.ended());
}

TEST(Replay, ContactsComeBackWithTheirImpulseOnTheSecondBody) {
  const Json run = run_of(rolling(20));
  EXPECT_EQ(run["contacts"], "kept");
  Reading reading(unpacked(run["touches"].get<std::string>()));
  const double length = run["length"];
  const double impulse = run["impulse"];
  EXPECT_EQ(reading.next(), 1) << "place: one point between floor and wheel, whichever comes first";
  EXPECT_EQ(reading.next(), 2) << "stays";
  EXPECT_EQ(reading.next(), 3);
  EXPECT_EQ(reading.next(), 3);
  EXPECT_NEAR(reading.steady(3, length)[2], 4 * 5 / 60.0, length);
  EXPECT_NEAR(reading.steady(3, length)[2], 0, length);
  // On the floor 2 along (0, -1) and 0.5 along that turned left, (1, 0); on the wheel the opposite.
  EXPECT_NEAR(reading.steady(3, impulse)[0], -0.5, impulse);
  EXPECT_NEAR(reading.steady(3, impulse)[0], 2, impulse);
  EXPECT_EQ(reading.next(), 3) << "moments after the end of the first stay";
  EXPECT_EQ(reading.next(), 1);
  for (int k = 0; k < 2; ++k) reading.steady(1, length);
  EXPECT_EQ(reading.steady(1, impulse)[0], 0);
  EXPECT_NEAR(reading.steady(1, impulse)[0], 1, impulse);
  EXPECT_TRUE(reading.ended());
}

// What engines say of contacts is not checked; it must not cost the report.
TEST(Replay, LeavesOutContactsThatAreNowhereOrHaveNoImpulse) {
  const Report report = rolling(20);
  Trace altered(3);
  for (std::size_t i = 0; i < report.runs[0].trace->size(); ++i) {
    const Trace& trace = *report.runs[0].trace;
    std::vector<ContactState> contacts(trace.contacts(i).begin(), trace.contacts(i).end());
    for (ContactState& contact : contacts) {
      if (i == 9) contact.point = {1e300, 0};
      if (i == 5) contact.normal_impulse = std::numeric_limits<double>::infinity();
    }
    altered.record(trace.time(i), trace.states(i), contacts);
  }
  Report other = report;
  other.runs[0].trace = std::make_shared<const Trace>(altered);
  const Json run = run_of(other);
  Reading reading(unpacked(run["touches"].get<std::string>()));
  EXPECT_EQ(reading.next(), 1) << "place";
  EXPECT_EQ(reading.next(), 1) << "stay";
  EXPECT_EQ(reading.next(), 3);
  EXPECT_EQ(reading.next(), 2) << "moments";
}

TEST(Replay, ThinsWhatIsTooLongAndSaysHowFarOffItIsBetween) {
  const Report report = rolling(2000);
  const Trace& trace = *report.runs[0].trace;
  const ReplayLimits limits{.poses = 400, .contacts = 1};
  const Json run = run_of(report, limits);
  EXPECT_LE(run["poses"].get<std::string>().size(), limits.poses);
  EXPECT_EQ(run["contacts"], "too many");
  EXPECT_EQ(run["touches"], "");
  const std::size_t every = run["every"];
  ASSERT_GT(every, 1u);
  const std::size_t moments = run["moments"];
  Reading reading(unpacked(run["poses"].get<std::string>()));
  const auto times = reading.smooth(moments, 1e-6);
  EXPECT_NEAR(times[1], static_cast<double>(every) / 60, 1e-6);
  EXPECT_NEAR(times.back(), trace.times().back(), 1e-6) << "the end is kept";
  // The chord of an arc of angle w t and radius 3 (x) and 1 (y) lies r (1 - cos(w t / 2)) off; the angle runs straight.
  const double half = static_cast<double>(every) / 60 / 2;
  EXPECT_GT(run["between"].get<double>(), 0.9 * (1 - std::cos(half)));
  EXPECT_LT(run["between"].get<double>(), 3.2 * (1 - std::cos(half)) + 0.01) << "and the second wheel's dip of 1 cm";
}

TEST(Replay, TellsOfWhatItMayJumpTo) {
  Report report = rolling(20);
  EXPECT_TRUE(run_of(report)["apart"].is_null()) << "measured by itself";
  const Json overlap = run_of(report)["overlap"];
  EXPECT_NEAR(overlap["time"].get<double>(), 7 / 60.0, 1e-12);
  EXPECT_NEAR(overlap["value"].get<double>(), 0.01, 1e-12);
  EXPECT_EQ(overlap["b"], 2u);
  RunRecord other = report.runs[0];
  other.engine = "f";
  const auto moved = std::make_shared<Trace>(3);
  for (std::size_t i = 0; i < 20; ++i) {
    auto states = std::vector<BodyState>(other.trace->states(i).begin(), other.trace->states(i).end());
    if (i == 12) states[1].position.x += 1;
    moved->record(other.trace->time(i), states, {});
  }
  other.trace = moved;
  report.runs.push_back(other);
  const Json apart = replays_of(run_curves(report))[0]["runs"][1]["apart"];
  EXPECT_NEAR(apart["time"].get<double>(), 12 / 60.0, 1e-12);
  EXPECT_NEAR(apart["value"].get<double>(), 1 / std::sqrt(2.0), 1e-12) << "RMS over two moving bodies";
}

TEST(Replay, TakesTremblingByRoundOffForRest) {
  const auto scene = std::make_shared<const Scene>(
      Scene{.bodies = {{.name = "point", .shapes = {{.geometry = Circle{}}}}, {.name = "far", .shapes = {}}}});
  const auto trace = std::make_shared<Trace>(2);
  for (int i = 0; i < 50; ++i) {
    const double tremble = i % 2 == 0 ? 0 : 1e-12;
    const std::vector<BodyState> states{{.position = {1e4, 1e4 + tremble}, .angle = 1e6 + tremble}, {}};
    trace->record(i / 60.0, states, {});
  }
  const Report report{.runs = {{.scenario = "rest", .variant = "v", .engine = "e", .scene = scene, .trace = trace}}};
  EXPECT_LT(run_of(report)["poses"].get<std::string>().size(), 100u);
}

TEST(Replay, HasOneSceneForAllRunsOfACase) {
  const Json replays = replays_of(run_curves(sample_report()));
  ASSERT_EQ(replays.size(), 1u);
  EXPECT_EQ(replays[0]["runs"].size(), 2u) << "the run that failed left no trace";
  EXPECT_EQ(replays[0]["runs"][0]["contacts"], "none");
}

TEST(ReplayScene, HasEachOutlineOnceAboutTheCentreOfMass) {
  const Shape box{.geometry = Box{.size = {2, 1}, .center = {5, 0}}};
  const Json scene =
      outlines_of({.bodies = {{.name = "one", .shapes = {box}},
                              {.name = "two", .shapes = {box}},
                              {.name = "floor", .type = BodyType::fixed, .shapes = {{HalfSpace{}, {}}}}}});
  ASSERT_EQ(scene["outlines"].size(), 2u);
  EXPECT_EQ(scene["outlines"][0]["points"], Json::parse("[[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]]"));
  EXPECT_EQ(scene["outlines"][1], Json::parse(R"({"normal": [0.0, 1.0], "offset": 0.0})"));
  EXPECT_EQ(scene["bodies"][1], Json::parse(R"({"name": "two", "type": "dynamic", "outlines": [0]})"));
  EXPECT_EQ(scene["bodies"][2]["type"], "fixed");
}

TEST(ReplayScene, DrawsCapsulesAndDiscsAsPointsThatAreGrown) {
  const Capsule capsule{.from = {-1, 0}, .to = {1, 0}, .radius = 0.25};
  const Scene scene{.bodies = {{.name = "c", .shapes = {{.geometry = capsule}}}, {.name = "point"}}};
  EXPECT_EQ(outlines_of(scene)["outlines"][0], Json::parse(R"({"points": [[-1.0, 0.0], [1.0, 0.0]], "radius": 0.25})"));
  EXPECT_THAT(radii_of(scene), ::testing::ElementsAre(1.25, 0));
}

TEST(ReplayScene, TiesJointsAndSpringsInTheBodiesFrames) {
  const Shape disc{.geometry = Circle{}};
  const Scene scene{.bodies = {{.name = "a", .position = {1, 0}, .shapes = {disc}},
                               {.name = "b", .position = {3, 0}, .angle = 0, .shapes = {disc}}},
                    .joints = {Revolute{.a = 0, .b = 1, .anchor = {2, 0}}},
                    .forces = {Spring{.b = 1, .anchor_a = {0, 4}, .anchor_b = {0, 0.5}}}};
  const Json joints = outlines_of(scene)["joints"];
  EXPECT_EQ(joints[0], Json::parse(R"({"a": 0, "b": 1, "at_a": [1.0, 0.0], "at_b": [-1.0, 0.0]})"));
  EXPECT_EQ(joints[1], Json::parse(R"({"a": null, "b": 1, "at_a": [0.0, 4.0], "at_b": [0.0, 0.5]})"));
}

}  // namespace
}  // namespace plumb::replay_test
