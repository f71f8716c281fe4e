#include "reports/compare/divergence.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "../fakes.h"
#include "scenarios/scene/vec.h"

namespace plumb::divergence_test {
namespace {

using ::testing::HasSubstr;

constexpr double dt = 0.125;  // s; exact in binary
constexpr std::size_t steps = 16;

/// A disc on the ground and another on top. Nothing moves unless a test moves it.
Scene two_discs() {
  const auto disc = [](const char* name, double y) {
    return Body{.name = name, .position = {0, y}, .shapes = {{.geometry = Circle{.radius = 0.5}}}};
  };
  return {.name = "discs",
          .bodies = {{.name = "ground", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{}}}},
                     disc("low", 0.5),
                     disc("high", 1.5)}};
}

using Edit = std::function<void(std::size_t step, std::vector<BodyState>&, std::vector<ContactState>&)>;

const ContactState low_on_ground{.a = 0, .b = 1, .point = {0, 0}, .normal = {0, 1}, .normal_impulse = 2};
const ContactState high_on_low{.a = 1, .b = 2, .point = {0, 1}, .normal = {0, 1}, .normal_impulse = 1};

/// A run with both contacts throughout, changed by a test.
class EditedRun {
 public:
  explicit EditedRun(const char* name, const Edit& edit = nullptr, double epsilon = 0x1p-53) : trace_(3) {
    for (std::size_t step = 0; step <= steps; ++step) {
      std::vector<BodyState> states = initial_states(two_discs());
      std::vector<ContactState> contacts;
      if (step > 0) contacts = {low_on_ground, high_on_low};
      if (edit) edit(step, states, contacts);
      trace_.record(static_cast<double>(step) * dt, states, contacts);
    }
    compared_ = {name, &trace_, {.dt = dt, .h = dt, .drift = 0.5, .epsilon = epsilon}};
  }
  EditedRun(const EditedRun&) = delete;
  const ComparedRun& compared() const { return compared_; }

 private:
  Trace trace_;
  ComparedRun compared_;
};

TraceComparison compare_edited(const EditedRun& a, const EditedRun& b, std::optional<double> tolerance = std::nullopt) {
  return compare_traces(two_discs(), a.compared(), b.compared(), tolerance);
}

Divergence divergence_of(const Edit& a, const Edit& b) {
  const TraceComparison both = compare_edited(EditedRun("one", a), EditedRun("other", b));
  if (!both.divergence) throw std::logic_error("the runs should diverge");
  return *both.divergence;
}

void shift(std::vector<BodyState>& states, double by) { states[2].velocity.x += by; }

TEST(CompareTraces, FindsNoDivergenceOfEqualRuns) {
  const TraceComparison same = compare_edited(EditedRun("one"), EditedRun("other"));
  EXPECT_FALSE(same.divergence);
  EXPECT_EQ(same.steps, steps);
  EXPECT_EQ(same.until, steps * dt);
  EXPECT_EQ(same.largest.difference, 0);
}

TEST(CompareTraces, ToleratesRoundOffAndNoMore) {
  const auto off = [](double by) -> Edit { return [by](auto, auto& states, auto&) { shift(states, by); }; };
  constexpr double single = 0x1p-24;
  EXPECT_FALSE(compare_edited(EditedRun("one"), EditedRun("other", off(1e-15))).divergence);
  EXPECT_TRUE(compare_edited(EditedRun("one"), EditedRun("other", off(1e-12))).divergence);
  EXPECT_FALSE(compare_edited(EditedRun("one"), EditedRun("other", off(1e-7), single)).divergence);
  EXPECT_TRUE(compare_edited(EditedRun("one"), EditedRun("other", off(1e-3), single)).divergence);
}

TEST(CompareTraces, UsesAToleranceInsteadOfRoundOff) {
  const Edit off = [](auto, auto& states, auto&) { shift(states, 0.01); };
  EXPECT_FALSE(compare_edited(EditedRun("one"), EditedRun("other", off), 0.02).divergence);
  EXPECT_EQ(compare_edited(EditedRun("one"), EditedRun("other", off), 0.02).largest.what, "vx of high");
  EXPECT_TRUE(compare_edited(EditedRun("one"), EditedRun("other", off), 0.005).divergence);
}

TEST(CompareTraces, FindsDifferentStarts) {
  const Divergence found = divergence_of(nullptr, [](auto, auto& states, auto&) { states[1].position.x = 0.1; });
  EXPECT_EQ(found.stage, Stage::start);
  EXPECT_EQ(found.step, 0u);
  EXPECT_EQ(found.first.what, "x of low");
}

TEST(CompareTraces, BlamesTheIntegrationOfABodyThatNothingTouches) {
  const Edit flies = [](auto, auto&, auto& contacts) { contacts.clear(); };
  const Divergence found = divergence_of(flies, [](std::size_t step, auto& states, auto& contacts) {
    if (!contacts.empty()) contacts = {low_on_ground};
    if (step >= 3) states[2].angle = 0.25;
  });
  EXPECT_EQ(found.stage, Stage::integration);
  EXPECT_EQ(found.step, 3u);
  EXPECT_EQ(found.time, 3 * dt);
  EXPECT_EQ(found.body, "high");
  EXPECT_EQ(found.first.what, "angle of high");
  EXPECT_EQ(found.first.a, 0);
  EXPECT_EQ(found.first.b, 0.25);
  EXPECT_THAT(found.advice, HasSubstr("Nothing touches high"));
}

// As a closed form, which reports no contacts and finds an impact in the step in which it is.
TEST(CompareTraces, BlamesTheTimeOfAnImpactThatOneRunDoesNotReport) {
  const Edit silent = [](std::size_t step, auto& states, auto& contacts) {
    contacts.clear();
    if (step >= 3) shift(states, 5);
  };
  const Edit late = [](std::size_t step, auto& states, auto& contacts) {
    if (step < 4) contacts.clear();
    if (step >= 4) shift(states, 5);
  };
  const Divergence found = divergence_of(silent, late);
  EXPECT_EQ(found.stage, Stage::event_time);
  EXPECT_EQ(found.step, 3u);
  EXPECT_EQ(found.other, "low");
  EXPECT_THAT(found.advice,
              HasSubstr("the velocity of high jumps in step 3; in other, low and high collide in step 4"));
}

TEST(CompareTraces, BlamesTheContactSetIfBodiesTouchInOneRunOnly) {
  const Divergence found = divergence_of(nullptr, [](std::size_t step, auto& states, auto& contacts) {
    if (step < 4) return;
    contacts = {high_on_low};
    shift(states, 1);
  });
  EXPECT_EQ(found.stage, Stage::contact_set);
  EXPECT_EQ(found.step, 4u);
  EXPECT_THAT(found.advice, HasSubstr("ground and low touch in one but not in other"));
}

TEST(CompareTraces, BlamesTheEventTimeIfTheOtherRunHasTheImpactSoon) {
  const auto meets_in = [](std::size_t first) -> Edit {
    return [first](std::size_t step, auto& states, auto& contacts) {
      if (step < first) contacts.clear();
      if (step >= first) shift(states, 1);
    };
  };
  const Divergence found = divergence_of(meets_in(6), meets_in(5));
  EXPECT_EQ(found.stage, Stage::event_time);
  EXPECT_EQ(found.step, 5u);
  EXPECT_EQ(found.other, "low");
  EXPECT_THAT(found.advice, HasSubstr("In other, low and high collide in step 5; in one, in step 6"));
  EXPECT_EQ(divergence_of(meets_in(9), meets_in(5)).stage, Stage::contact_set) << "too late to be a matter of timing";
}

TEST(CompareTraces, BlamesTheEventTimeWithinAStepToo) {
  const auto meets_and_is_at = [](double x) -> Edit {
    return [x](std::size_t step, auto& states, auto& contacts) {
      if (step < 5) contacts.clear();
      if (step < 5) states[2].velocity.y = -20;
      if (step >= 5) states[2].position.x = x;
    };
  };
  const Divergence found = divergence_of(meets_and_is_at(0), meets_and_is_at(0.25));
  EXPECT_EQ(found.stage, Stage::event_time);
  EXPECT_THAT(found.advice, HasSubstr("at different moments of the step"));
}

TEST(CompareTraces, TellsASkinFromAContactReportedAfterTheMove) {
  const auto lifted = [](double reported) {
    return divergence_of(nullptr, [reported](std::size_t step, auto& states, auto& contacts) {
      if (step < 2) return;
      contacts[1].separation = reported;
      states[2].position.y += 0.01;
    });
  };
  EXPECT_EQ(lifted(0.01).stage, Stage::not_reported) << "off by as much as it moved";
  EXPECT_EQ(lifted(-0.01).stage, Stage::manifold) << "deeper, so that it caused the move";
}

TEST(CompareTraces, BlamesTheManifoldIfTheSameBodiesTouchDifferently) {
  const auto with = [](const std::function<void(ContactState&)>& change) {
    return divergence_of(nullptr, [&](std::size_t step, auto& states, auto& contacts) {
      if (step < 2) return;
      change(contacts[1]);
      states[2].velocity.x = 1e-3;
    });
  };
  for (const Divergence& found :
       {with([](ContactState& contact) { contact.point.x = 0.25; }),
        with([](ContactState& contact) { contact.separation = -0.01; }), with([](ContactState& contact) {
          contact.normal = {0.6, 0.8};
        })}) {
    EXPECT_EQ(found.stage, Stage::manifold);
    EXPECT_EQ(found.step, 2u);
    EXPECT_EQ(found.other, "low");
  }
}

TEST(CompareTraces, BlamesTheImpulseIfTheContactIsTheSame) {
  const auto with = [](double ContactState::*which) {
    return divergence_of(nullptr, [&](std::size_t step, auto& states, auto& contacts) {
      if (step < 7) return;
      contacts[1].*which += 0.5;
      contacts[1].point.x += 1e-3;  // as reported after a move at the different velocity
      states[2].velocity.x = 0.5;
    });
  };
  EXPECT_EQ(with(&ContactState::normal_impulse).stage, Stage::impulse);
  EXPECT_EQ(with(&ContactState::tangent_impulse).stage, Stage::impulse);
  EXPECT_EQ(with(&ContactState::normal_impulse).step, 7u);
}

TEST(CompareTraces, FollowsContactsFromBodyToBodyButNotThroughTheGround) {
  const Edit below = [](std::size_t step, auto& states, auto& contacts) {
    if (step < 2) return;
    contacts[0].normal_impulse = 3;  // of low only
    shift(states, 1);                // shows in high
  };
  const Divergence found = divergence_of(nullptr, below);
  EXPECT_EQ(found.body, "high");
  EXPECT_EQ(found.stage, Stage::impulse);
  EXPECT_EQ(found.other, "ground") << "where it came from";
  const Edit elsewhere = [&](std::size_t step, auto& states, auto& contacts) {
    below(step, states, contacts);
    if (contacts.size() == 2) contacts.pop_back();  // nothing connects high to low
  };
  EXPECT_EQ(
      divergence_of([](auto, auto&, auto& contacts) { contacts.resize(contacts.empty() ? 0 : 1); }, elsewhere).stage,
      Stage::integration);
}

TEST(CompareTraces, SaysIfTheReportedContactsDoNotExplainIt) {
  const Divergence same = divergence_of(nullptr, [](std::size_t step, auto& states, auto&) {
    if (step > 0) shift(states, 1);
  });
  EXPECT_EQ(same.stage, Stage::not_reported);
  EXPECT_THAT(same.advice, HasSubstr("same contacts and impulses"));

  const Divergence silent = divergence_of(nullptr, [](std::size_t step, auto& states, auto& contacts) {
    contacts.clear();
    if (step > 0) shift(states, 1);
  });
  EXPECT_EQ(silent.stage, Stage::not_reported);
  EXPECT_THAT(silent.advice, HasSubstr("other reports no contacts"));
}

TEST(CompareTraces, DoesNotDependOnWhichBodyAnEngineCallsA) {
  EXPECT_FALSE(compare_edited(EditedRun("one"), EditedRun("other",
                                                          [](auto, auto&, auto& contacts) {
                                                            for (ContactState& contact : contacts) {
                                                              std::swap(contact.a, contact.b);
                                                              contact.normal = -1 * contact.normal;
                                                            }
                                                          }))
                   .divergence);
  const Divergence found = divergence_of(nullptr, [](std::size_t step, auto& states, auto& contacts) {
    for (ContactState& contact : contacts) {
      std::swap(contact.a, contact.b);
      contact.normal = -1 * contact.normal;
    }
    if (step > 0) shift(states, 1);
  });
  EXPECT_EQ(found.stage, Stage::not_reported) << "the contacts are the same";
}

TEST(CompareTraces, ReportsTheGrowthOverTime) {
  const Divergence found = divergence_of(nullptr, [](std::size_t step, auto& states, auto&) {
    if (step > 0) shift(states, 1e-6 * std::ldexp(1.0, static_cast<int>(step)));
  });
  ASSERT_EQ(found.growth.size(), 6u);
  EXPECT_EQ(found.growth[0].step, 1u);
  EXPECT_EQ(found.growth[0].factor, 1);
  EXPECT_EQ(found.growth[1].step, 5u) << "2^4 is the first power of two above 10";
  EXPECT_DOUBLE_EQ(found.growth[1].factor, 16);
  EXPECT_EQ(found.growth[4].step, 15u);
  EXPECT_EQ(found.growth[5].step, steps) << "the end is always reported";
}

TEST(CompareTraces, NoticesIfMostOfTheDifferenceWasThereBefore) {
  const auto of = [](double first) {
    const EditedRun slow("slow", [first](std::size_t step, auto& states, auto&) {
      if (step > 0) shift(states, step == 1 ? first : 1);
    });
    return compare_edited(EditedRun("one"), slow, 0.95).divergence.value().advice;
  };
  EXPECT_THAT(of(0.9), HasSubstr("there a step earlier"));
  EXPECT_THAT(of(0.1), ::testing::Not(HasSubstr("there a step earlier")));
}

TEST(CompareTraces, RecognisesADifferenceThatTheStatedDriftsExplain) {
  const Scene scene = fakes::thrown_box();
  const Trace exact = fakes::flight_of(scene, dt);
  Trace stepped(1);
  fakes::Stepper stepper(scene, fakes::Stepper::Fault::none);
  std::vector<BodyState> states(1);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (i > 0) stepper.step(dt);
    stepper.read(states);
    stepped.record(exact.time(i), states, {});
  }
  const auto advice = [&](double drift) {
    const ComparedRun a{"exact", &exact, {.dt = dt, .epsilon = 0x1p-53}};
    const ComparedRun b{"stepped", &stepped, {.dt = dt, .h = dt, .drift = drift, .epsilon = 0x1p-53}};
    return compare_traces(scene, a, b, std::nullopt).divergence.value().advice;
  };
  EXPECT_THAT(advice(0.5), HasSubstr("Their integrators explain it"));
  EXPECT_THAT(advice(0), ::testing::Not(HasSubstr("explain")));
}

TEST(CompareTraces, RequiresRunsOfOneSceneAtTheSameMoments) {
  const EditedRun run("one");
  Trace later(3);
  later.record(1, run.compared().trace->states(0), {});
  EXPECT_THROW(compare_traces(two_discs(), run.compared(), {"later", &later, {}}, std::nullopt), std::invalid_argument);
  EXPECT_THROW(compare_traces(fakes::thrown_box(), run.compared(), run.compared(), std::nullopt),
               std::invalid_argument);
}

constexpr double tick = 1.0 / 64;  // s
const std::vector<BodyState> moved{{.position = {3, 4}, .velocity = {0, 2}}};

Stepping rounding_by(double epsilon) { return {.dt = tick, .h = tick, .epsilon = epsilon}; }

StateTolerance after(double time, double epsilon_a, double epsilon_b) {
  static const Scene scene = fakes::thrown_box();
  return RoundOffTolerance(scene, rounding_by(epsilon_a), rounding_by(epsilon_b)).at(time, moved, moved);
}

TEST(RoundOffTolerance, AddsTheRoundingOfBothRuns) {
  const double fine = 0x1p-53;
  const double coarse = 0x1p-24;
  EXPECT_DOUBLE_EQ(after(1, fine, coarse).position, after(1, fine, 0).position + after(1, 0, coarse).position);
  EXPECT_EQ(after(1, 0, 0).velocity, 0);
}

TEST(RoundOffTolerance, CountsEveryStep) {
  // 4 epsilon (n + 1) (|x| + |v| t), with the g dt that a step adds to v.
  const double speed = 2 + 10 * tick;
  EXPECT_DOUBLE_EQ(after(1, 0x1p-24, 0).position, 4 * 0x1p-24 * 65 * (5 + speed));
  EXPECT_DOUBLE_EQ(after(1, 0x1p-24, 0).velocity, 4 * 0x1p-24 * (65 * speed + 5 / tick));
}

TEST(RoundOffTolerance, RemembersTheLargestNumbers) {
  const Scene scene = fakes::thrown_box();
  const std::vector<BodyState> still(1);
  RoundOffTolerance round_off(scene, rounding_by(0x1p-24), rounding_by(0x1p-24));
  const double before = round_off.at(0, moved, still).velocity;
  EXPECT_DOUBLE_EQ(round_off.at(0, still, still).velocity, before);
}

TEST(UniformTolerance, ScalesImpulsesByTheLightestBody) {
  Scene scene = fakes::thrown_box();  // 2 kg
  scene.bodies.push_back({.shapes = {{.geometry = Box{.size = {1, 0.5}}}}});
  scene.bodies.push_back({.type = BodyType::fixed});
  EXPECT_EQ(uniform_tolerance(0.1, scene).impulse, 0.05);
  EXPECT_EQ(uniform_tolerance(0.1, scene).angle, 0.1);
}

}  // namespace
}  // namespace plumb::divergence_test
