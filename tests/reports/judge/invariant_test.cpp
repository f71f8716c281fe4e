#include "reports/judge/invariant.h"

#include <gmock/gmock.h>

#include <set>

#include "../fakes.h"
#include "invariants/forged_runs.h"
#include "reports/run/run.h"

namespace plumb::invariant_test {
namespace {

TEST(Invariants, AreAllThere) {
  std::vector<std::string> names;
  for (const Invariant* invariant : Catalog<Invariant>::all()) names.push_back(invariant->name);
  EXPECT_THAT(names, ::testing::ElementsAre("angular_momentum", "angular_momentum_of_bodies", "bouncing",
                                            "complementarity", "cone", "displacement", "energy", "energy_bound",
                                            "free_motion", "momentum", "momentum_of_bodies", "overlap", "points",
                                            "push", "rest", "start", "sticking", "turning"));
}

TEST(WorstViolation, KeepsTheLargestErrorRatio) {
  WorstViolation worst;
  worst.add(3, 2, 1, 1, [] { return "first"; });
  worst.add(1, 0.5, 1, 2, [] { return "second"; });
  worst.add(4, 4, 1, 3, [] { return "third"; });
  const InvariantCheck check = worst.result();
  EXPECT_EQ(check.ratio, 2);
  EXPECT_EQ(check.where, "second");
  EXPECT_EQ(check.time, 2);
  EXPECT_EQ(check.status, CheckStatus::broken);
}

// The worst tolerance is 5 times that where the law was tested best.
TEST(WorstViolation, StatesTheScaleWhereTheLawWasTestedBest) {
  WorstViolation worst;
  worst.add(5, 10, 20, 1, [] { return "worst"; });
  worst.add(0, 2, 100, 2, [] { return "best tested"; });
  const InvariantCheck check = worst.result();
  EXPECT_EQ(check.where, "worst");
  EXPECT_EQ(check.tolerance, 10);
  EXPECT_EQ(check.scale, 500);
  EXPECT_TRUE(is_evidence(check));
}

TEST(WorstViolation, IsHeldIfNothingWasAdded) { EXPECT_EQ(WorstViolation().result().status, CheckStatus::held); }

Trace shown(const std::vector<ContactState>& contacts) {
  return forged(0.01, {{box_at({0, 0.5}), contacts}, {box_at({0, 0.5}), contacts}});
}

TEST(Invariants, NeverPassWithoutTheContactsTheyNeed) {
  const Scene scene = box_on_ground();
  for (const char* name : {"push", "cone", "complementarity", "sticking", "momentum_of_bodies"}) {
    EXPECT_EQ(status(name, scene, shown({}), {.dt = 0.01}), CheckStatus::not_reported) << name;
  }
  const Stepping parts{.dt = 0.01, .whole_impulses = false};
  for (const char* name : {"cone", "sticking", "momentum_of_bodies"}) {
    EXPECT_EQ(status(name, scene, shown({pushing(1)}), parts), CheckStatus::not_reported) << name;
  }
}

TEST(Invariants, OfContactsAreNotApplicableWhereNothingTouches) {
  const Scene scene = box_on_ground();
  const Trace flight = forged(0.01, {{box_at({0, 5})}, {box_at({0, 5}, {0, -0.1})}});
  for (const char* name : {"push", "cone", "complementarity", "sticking", "bouncing", "momentum_of_bodies"}) {
    EXPECT_EQ(status(name, scene, flight, {.dt = 0.01}), CheckStatus::not_applicable) << name;
  }
}

// The exact motion breaks no invariant at any step, and together the closed forms exercise all of them.
TEST(Invariants, AreHeldByEveryClosedForm) {
  std::set<std::string> held;
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    if (scenario->closed_form.empty()) continue;
    const Engine& closed_form = *Catalog<Engine>::find(scenario->closed_form);
    for (const Variant& variant : scenario->variants) {
      const Scene scene = scenario->scene(complete(*scenario, variant.changes));
      constexpr double dt = 1.0 / 60;
      const Outcome outcome = run(scene, {&closed_form, {}}, dt);
      if (outcome.status != Status::ok) continue;
      for (const InvariantCheck& check : check_invariants({scene, *outcome.trace, closed_form.stepping({}, dt)})) {
        EXPECT_NE(check.status, CheckStatus::broken)
            << scenario->name << ' ' << variant.label << ": " << check.name << ' ' << check.value << " of "
            << check.tolerance << ' ' << check.where << " at " << check.time;
        if (check.status == CheckStatus::held) held.insert(check.name);
      }
    }
  }
  EXPECT_EQ(held.size(), Catalog<Invariant>::all().size());
}

}  // namespace
}  // namespace plumb::invariant_test
