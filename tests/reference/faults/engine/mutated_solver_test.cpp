#include <gtest/gtest.h>

#include "reference/faults/altered_engine.h"
#include "reports/find/kind.h"
#include "reports/trace.h"
#include "scenarios/catalog.h"

namespace plumb::mutated_solver_test {
namespace {

std::uint64_t hash_of_run(const Scene& scene, const char* solver) {
  Settings settings = settings_of({});
  settings["solver"] = solver;
  const auto simulation = build_ours(scene, settings);
  Trace trace(scene.bodies.size());
  std::vector<BodyState> states(scene.bodies.size());
  std::vector<ContactState> contacts;
  for (int i = 1; i <= 60; ++i) {
    simulation->step(1.0 / 60);
    simulation->read(states);
    contacts.clear();
    simulation->read_contacts(contacts);
    trace.record(i / 60.0, states, contacts);
  }
  return hash_of(trace);
}

// Else faults would be found by what the mutation of any solver changes.
TEST(MutatedSolver, RunsAndReportsAsTheRightOneIfItChangesNothing) {
  for (const char* kind : {"rocking", "composite", "dome", "drum", "few", "tower", "jointed"}) {
    for (int n = 0; n < 3; ++n) {
      const Scene scene = drawn(*Catalog<Kind>::find(kind), 1, n);
      EXPECT_EQ(hash_of_run(scene, "scaled-inertia=1"), hash_of_run(scene, "accurate")) << scene.name;
    }
  }
}

}  // namespace
}  // namespace plumb::mutated_solver_test
