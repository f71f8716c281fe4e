#include "impulse/settings.h"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

#include "../support.h"

namespace settings_test {
namespace {

using namespace impulse;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

std::string rejection(const Settings& settings) {
  try {
    validate(settings);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Settings, AreValidByDefault) { EXPECT_EQ(rejection({}), ""); }

TEST(Settings, RejectInvalidStepsByName) {
  for (const double dt : {0.0, -1.0, 1e9, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    Settings settings;
    settings.dt = real(dt);
    EXPECT_THAT(rejection(settings), HasSubstr("dt must be")) << dt;
  }
}

TEST(Settings, RejectInvalidGravityByName) {
  for (const double gravity : {1e9, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    Settings settings;
    settings.gravity.y = real(gravity);
    EXPECT_THAT(rejection(settings), HasSubstr("gravity must be")) << gravity;
  }
}

TEST(Settings, RejectInvalidCountsByName) {
  for (const int iterations : {0, -1, 1000000000}) {
    Settings settings;
    settings.iterations = iterations;
    EXPECT_THAT(rejection(settings), HasSubstr("iterations must be")) << iterations;
  }
  for (const int iterations : {-1, 1000000000}) {
    Settings settings;
    settings.position_iterations = iterations;
    EXPECT_THAT(rejection(settings), HasSubstr("position_iterations must be")) << iterations;
  }
}

TEST(Settings, ListTheKnownMethodsWhenTheyRejectOne) {
  Settings settings;
  settings.integrator = "euler";
  EXPECT_THAT(rejection(settings), HasSubstr("explicit-euler, rk4, symplectic-euler, velocity-verlet"));
  settings = {};
  settings.solver = "";
  EXPECT_THAT(rejection(settings), HasSubstr("article"));
  settings = {};
  settings.broad_phase = "Brute";
  EXPECT_THAT(rejection(settings), HasSubstr("brute"));
}

TEST(Settings, OfferAllMethods) {
  for (const char* name :
       {"accurate", "article", "block", "exact", "sequential-impulse", "soft-step", "split-impulse", "xpbd"}) {
    EXPECT_THAT(solvers(), Contains(Field(&MethodInfo::name, name)));
  }
  EXPECT_THAT(solvers(), Not(Contains(Field(&MethodInfo::source, ""))));
  EXPECT_THAT(broad_phases(), Contains(Field(&MethodInfo::name, "brute")));
  for (const char* name : {"explicit-euler", "rk4", "symplectic-euler", "velocity-verlet"}) {
    EXPECT_THAT(integrators(), Contains(Field(&MethodInfo::name, name)));
  }
  EXPECT_THAT(integrators(), Not(Contains(Field(&MethodInfo::source, ""))));
}

TEST(StatedErrors, SayWhetherTheSolverLooksAhead) {
  for (const char* solver : {"accurate", "exact", "soft-step", "xpbd"}) {
    EXPECT_TRUE(stated_errors({.solver = solver}).looks_ahead) << solver;
  }
  for (const char* solver : {"article", "block", "sequential-impulse", "split-impulse"}) {
    EXPECT_FALSE(stated_errors({.solver = solver}).looks_ahead) << solver;
  }
  EXPECT_THROW(stated_errors({.solver = "none"}), std::invalid_argument);
}

}  // namespace
}  // namespace settings_test
