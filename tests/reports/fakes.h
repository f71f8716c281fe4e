#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reference/simulation.h"
#include "reports/judge/mechanics.h"
#include "reports/run/run.h"
#include "reports/trace.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/vec.h"

/// Small scenes and engines with known results.
namespace plumb::fakes {

/// One body, 1 m x 2 m and 2 kg, thrown with spin: I = 2 (1 + 4)/12.
inline Scene thrown_box() {
  return {.name = "thrown",
          .gravity = {0, -10},
          .duration = 2,
          .bodies = {{.name = "box",
                      .position = {1, 2},
                      .angle = 0.5,
                      .velocity = {3, 8},
                      .angular_velocity = 4,
                      .shapes = {{.geometry = Box{.size = {1, 2}}, .surface = {.density = 1}}}}}};
}

/// Free bodies, evaluated exactly, valid for a given time, s.
class FreeFlight : public Simulation {
 public:
  explicit FreeFlight(const Scene& scene, double valid = std::numeric_limits<double>::infinity())
      : scene_(scene), valid_(valid), start_(initial_states(scene)) {}
  void step(double dt) override { time_ += dt; }
  void read(std::span<BodyState> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Vec g =
          scene_.bodies[i].type == BodyType::dynamic ? scene_.bodies[i].gravity_scale * scene_.gravity : Vec{};
      out[i] = start_[i];
      out[i].position = start_[i].position + time_ * start_[i].velocity + time_ * time_ / 2 * g;
      out[i].velocity = start_[i].velocity + time_ * g;
      out[i].angle += time_ * start_[i].angular_velocity;
    }
  }
  double valid_until() const override { return valid_; }

 private:
  const Scene& scene_;
  double valid_;
  std::vector<BodyState> start_;
  double time_ = 0;
};

/// Symplectic Euler, which fails at a given time, s, if told to.
class Stepper : public Simulation {
 public:
  enum class Fault { none, nan, explosion, exception, beyond };
  Stepper(const Scene& scene, Fault fault, double when = 1)
      : scene_(scene), fault_(fault), when_(when), states_(initial_states(scene)) {}
  void step(double dt) override {
    time_ += dt;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (scene_.bodies[i].type != BodyType::dynamic) continue;
      BodyState& state = states_[i];
      state.velocity = state.velocity + scene_.bodies[i].gravity_scale * dt * scene_.gravity;
      state.position = state.position + dt * state.velocity;
      state.angle += dt * state.angular_velocity;
    }
    if (time_ < when_) return;
    if (fault_ == Fault::nan) states_.back().position.x = std::nan("");
    if (fault_ == Fault::explosion) states_.back().velocity.y = 1e9;
    if (fault_ == Fault::exception) throw std::runtime_error("the engine gave up");
    if (fault_ == Fault::beyond) throw std::domain_error("too much for it");
  }
  void read(std::span<BodyState> out) const override { std::copy(states_.begin(), states_.end(), out.begin()); }

 private:
  const Scene& scene_;
  Fault fault_;
  double when_;
  std::vector<BodyState> states_;
  double time_ = 0;
};

inline Engine engine(const std::string& name, Stepper::Fault fault = Stepper::Fault::none) {
  return {.name = name,
          .about = "symplectic Euler",
          .source = "these tests",
          .stepping =
              [](const Settings&, double dt) {
                return Stepping{.dt = dt, .h = dt, .drift = 0.5, .epsilon = std::numeric_limits<double>::epsilon()};
              },
          .unsupported = [](const Scene&, const Settings&) { return ""; },
          .build = [fault](const Scene& scene, const Settings&) -> std::unique_ptr<Simulation> {
            return std::make_unique<Stepper>(scene, fault);
          }};
}

inline Engine free_flight(double valid = std::numeric_limits<double>::infinity()) {
  return {.name = "free-flight",
          .about = "r = r0 + v0 t + g t^2/2",
          .source = "Galileo",
          .exact = true,
          .stepping = [](const Settings&, double dt) { return Stepping{.dt = dt, .h = dt}; },
          .unsupported = [](const Scene&, const Settings&) { return ""; },
          .build = [valid](const Scene& scene, const Settings&) -> std::unique_ptr<Simulation> {
            return std::make_unique<FreeFlight>(scene, valid);
          }};
}

/// A thrown box, expected to end where free flight ends: symplectic Euler is off by g t dt/2 in y.
inline Scenario throwing() {
  return {.name = "throw",
          .question = "Does a thrown box fly as Galileo says?",
          .variants = {{.label = "as it is"}},
          .closed_form = "free-flight",
          .scene = [](const Parameters&) { return thrown_box(); },
          .expectations = [](const Parameters&) -> std::vector<Expectation> {
            const auto drift = [](const Stepping& by) { return std::abs(by.drift) * 10 * 2 * by.h; };
            return {{.body = "box", .quantity = Quantity::y, .allowed = drift, .source = "g t dt/2"},
                    {.body = "box", .quantity = Quantity::vx, .allowed = [](const Stepping&) { return 0.0; }}};
          }};
}

inline Case case_of(const Scenario& scenario, const Engine* closed_form) {
  return {.scenario = &scenario,
          .variant = scenario.variants.front().label,
          .scene = std::make_shared<const Scene>(scenario.scene({})),
          .closed_form = closed_form};
}

inline Trace flight_of(const Scene& scene, double dt) {
  FreeFlight flight(scene);
  Trace trace(scene.bodies.size());
  std::vector<BodyState> states(scene.bodies.size());
  for (std::size_t i = 0; i <= steps_in(scene.duration, dt); ++i) {
    if (i > 0) flight.step(dt);
    flight.read(states);
    trace.record(static_cast<double>(i) * dt, states, {});
  }
  return trace;
}

}  // namespace plumb::fakes
