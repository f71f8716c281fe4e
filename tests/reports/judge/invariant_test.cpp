#include "reports/judge/invariant.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

#include "../fakes.h"
#include "invariants/holding.h"
#include "reports/judge/verdict.h"
#include "reports/run/run.h"

namespace plumb {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Invariants, AreAllThere) {
  std::vector<std::string> names;
  for (const Invariant* invariant : Catalog<Invariant>::all()) names.push_back(invariant->name);
  EXPECT_THAT(names, ::testing::ElementsAre("angular_momentum", "complementarity", "cone", "energy", "momentum",
                                            "momentum_of_bodies", "overlap", "push", "rest", "sticking"));
}

TEST(Worst, KeepsWhatIsWorstAgainstWhatIsAllowedThere) {
  Worst worst;
  worst.see(3, 2, 1, [] { return "first"; });
  worst.see(1, 0.5, 2, [] { return "second"; });
  worst.see(4, 4, 3, [] { return "third"; });
  const InvariantCheck check = worst.result();
  EXPECT_EQ(check.ratio, 2);
  EXPECT_EQ(check.where, "second");
  EXPECT_EQ(check.time, 2);
  EXPECT_EQ(check.status, CheckStatus::broken);
}

TEST(Worst, NeverPassesWhatIsNotFinite) {
  EXPECT_EQ(Worst::times_allowed(std::nan(""), 1), infinity);
  EXPECT_EQ(Worst::times_allowed(1, infinity), infinity);
  EXPECT_EQ(Worst::times_allowed(1, 0), infinity);
  EXPECT_EQ(Worst::times_allowed(0, 0), 0);
  EXPECT_EQ(Worst().result().status, CheckStatus::held);
}

TEST(Concluded, IsWrongWhereAnInvariantIsBrokenWhateverTheTruthSays) {
  const std::vector<TruthCheck> passed{{.passed = true}};
  const std::vector<InvariantCheck> held{{.status = CheckStatus::held}, {.status = CheckStatus::not_reported}};
  const std::vector<InvariantCheck> broken{{.status = CheckStatus::held}, {.status = CheckStatus::broken}};
  EXPECT_EQ(concluded(passed, held), Verdict::right);
  EXPECT_EQ(concluded(passed, broken), Verdict::wrong);
  EXPECT_EQ(concluded({}, held), Verdict::plausible);
  EXPECT_EQ(concluded({}, broken), Verdict::wrong);
}

Trace shown(const std::vector<ContactState>& contacts) {
  return forged(0.01, {{box_at({0, 0.5}), contacts}, {box_at({0, 0.5}), contacts}});
}

TEST(Invariants, NeverPassWhatIsNotReported) {
  const Scene scene = box_on_ground();
  for (const char* name : {"push", "cone", "complementarity", "sticking", "momentum_of_bodies"}) {
    EXPECT_EQ(status(name, scene, shown({}), {.dt = 0.01}), CheckStatus::not_reported) << name;
  }
  const Stepping parts{.dt = 0.01, .whole_impulses = false};
  for (const char* name : {"cone", "sticking", "momentum_of_bodies"}) {
    EXPECT_EQ(status(name, scene, shown({pushing(1)}), parts), CheckStatus::not_reported) << name;
  }
}

// The exact motion breaks nothing, whatever the step; at least it would show in all the ways there are.
TEST(Invariants, AreHeldByEveryClosedForm) {
  std::set<std::string> seen;
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
        if (check.status == CheckStatus::held) seen.insert(check.name);
      }
    }
  }
  EXPECT_EQ(seen.size(), Catalog<Invariant>::all().size());
}

}  // namespace
}  // namespace plumb
