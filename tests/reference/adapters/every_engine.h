#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/programs/program_engine.h"
#include "reference/simulation.h"

/// What every adapter must satisfy: these tests run for every engine that is not a closed form, with its default
/// settings and with every other solver, broad phase and precision that it offers; and for every program of
/// reference/programs/npm that is installed in the folder that the environment variable PLUMB_ENGINES_DIR names.
namespace plumb::every_engine_test {

constexpr double g = 10;         // m/s^2
constexpr double dt = 1.0 / 60;  // s

inline Body body(std::string name, BodyType type, Vec position, Geometry geometry, Surface surface = {1, .5, .5, 0}) {
  Body made;
  made.name = std::move(name);
  made.type = type;
  made.position = position;
  made.shapes.push_back({std::move(geometry), surface});
  return made;
}

inline Body ground(double friction = .5) {
  return body("ground", BodyType::fixed, {}, HalfSpace{}, {1, friction, friction, 0});
}

inline Body box(Vec position, double friction = .5) {
  return body("box", BodyType::dynamic, position, Box{}, {1, friction, friction, 0});
}

inline Scene scene_of(std::vector<Body> bodies) {
  Scene scene;
  scene.name = "test";
  scene.gravity = {0, -g};
  scene.duration = 2;
  scene.bodies = std::move(bodies);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) scene.bodies[i].name += " " + std::to_string(i);
  return scene;
}

struct TestedEngine {
  std::string name;
  Settings settings;
};

// What a program does otherwise by its own design, which its adapter cannot mend: reports call it wrong there.
struct Deviation {
  std::string_view engine, test, reason;
};
inline constexpr std::string_view no_coulomb = "loses mu px a step while it slides, whatever the load";
inline constexpr std::string_view no_contacts = "caches the impulses of slow contacts only, and so reports none";
inline constexpr Deviation deviations[] = {
    {"matter", "UsesTheMixedFrictionOfEveryRule", no_coulomb},
    {"matter", "SticksJustBelowTheAngleOfFrictionAndSlidesJustAbove", no_coulomb},
    {"matter", "UsesTheMixedRestitutionOfEveryRule",
     "a disc is a polygon: landing on a side, two corners divide the impulse and lose part of it"},
    {"matter", "SupportsARestingBoxByImpulsesOfItsWeight", no_contacts},
    {"matter", "KeepsContactImpulsesWhileAsleep", no_contacts},
    {"matter", "ReportsFrictionUphill", no_contacts},
};

inline void PrintTo(const TestedEngine& config, std::ostream* out) {
  *out << config.name;
  for (const auto& [key, value] : config.settings) *out << ' ' << key << '=' << value;
}

class EveryEngine : public testing::TestWithParam<TestedEngine> {
 protected:
  void SetUp() override {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    for (const Deviation& known : deviations) {
      if (engine().name == known.engine && test.starts_with(known.test)) GTEST_SKIP() << known.reason;
    }
  }

  const Engine& engine() const {
    const Engine* const built_in = Catalog<Engine>::find(GetParam().name);
    return built_in != nullptr ? *built_in : engine_of_program(GetParam().name);
  }
  Stepping stated() const { return engine().stepping(GetParam().settings, dt); }
  // A program is only asked when it builds, and never of a scene that cannot be written.
  std::string refusal(const Scene& scene) const {
    std::string reason = engine().unsupported(scene, GetParam().settings);
    if (!reason.empty()) return reason;
    try {
      engine().build(scene, GetParam().settings);
    } catch (const std::domain_error& error) {
      return error.what();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  std::unique_ptr<Simulation> after(const Scene& scene, int steps) const {
    std::unique_ptr<Simulation> simulation = engine().build(scene, GetParam().settings);
    for (int i = 0; i < steps; ++i) simulation->step(dt);
    return simulation;
  }

  static std::vector<BodyState> read(const Scene& scene, const Simulation& simulation) {
    std::vector<BodyState> states(scene.bodies.size());
    simulation.read(states);
    return states;
  }

  std::vector<BodyState> run(const Scene& scene, int steps) const { return read(scene, *after(scene, steps)); }

  /// Bound on the round-off of n steps, with all their sub-steps, of a value of that size. matter keeps positions
  /// alone: its velocities are their differences, divided by the step.
  double rounding(int n, double size) const {
    const double amplified = engine().name == "matter" ? 1 / dt : 1;
    return amplified * 2 * n * (dt / stated().h) * stated().epsilon * size;
  }
};

}  // namespace plumb::every_engine_test
