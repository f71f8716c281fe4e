#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "reports/run/run.h"
#include "reports/run/selection.h"

namespace plumb::painleve_rod_test {
namespace {

struct Speeds {
  double expected = 0, measured = 0;  // m/s
};

// Soon after the jam, along the ground, of our engine with exact contacts.
Speeds speeds_of(const char* word, double dt) {
  const Case one = parse_cases(word).front();
  const std::vector<Expectation> all = one.scenario->expectations(one.parameters);
  const auto jam =
      std::find_if(all.begin(), all.end(), [](const Expectation& of) { return of.quantity == Quantity::vx; });
  if (jam == all.end()) return {};
  Scene scene = *one.scene;
  scene.duration = *jam->time;
  const Outcome outcome = run(scene, parse_engine("impulse:solver=exact"), dt);
  return {*jam->expected, outcome.trace->states(outcome.trace->size() - 1)[1].velocity.x};
}

// It jams in the first step, with arms that turn in it: an error of first order, at most 2.9 m/s times 3.2 rad/s dt.
TEST(PainleveRod, MovesOnAfterTheJamAsARodWhoseFootStandsOrSlides) {
  for (const char* word : {"painleve-rod:mu=2", "painleve-rod:mu=5"}) {
    const auto error = [&](double dt) {
      const Speeds speeds = speeds_of(word, dt);
      EXPECT_GT(speeds.expected, 2) << word;
      return std::abs(speeds.measured - speeds.expected);
    };
    constexpr double dt = 1.0 / 600;
    EXPECT_LT(error(dt), 2.9 * 3.2 * dt) << word;
    EXPECT_NEAR(error(dt) / error(dt / 4), 4, 0.1) << word;
    EXPECT_NEAR(error(dt / 4) / error(dt / 16), 4, 0.1) << word;
  }
}

}  // namespace
}  // namespace plumb::painleve_rod_test
