#pragma once

#include <concepts>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reference/simulation.h"

/// The road that every closed form takes: recognise a scene, then evaluate.
namespace plumb {

/// s, when what does not happen happens.
constexpr double never = std::numeric_limits<double>::infinity();

/// What a closed form makes of a scene: the motion it can solve, or why it cannot.
template <class Motion>
using Recognised = std::variant<Motion, std::string>;

/// Time by compensated summation (Kahan), so that a million steps are as exact as one.
class Elapsed {
 public:
  void add(double dt) {
    const double term = dt - lost_;
    const double sum = time_ + term;
    lost_ = (sum - time_) - term;
    time_ = sum;
  }
  double seconds() const { return time_; }

 private:
  double time_ = 0;
  double lost_ = 0;
};

/// A formula as a Simulation. Motion has
///     void at(double t, std::span<BodyState> out) const;                              // every body, in Scene order
/// and may have
///     double valid_until() const;                                                      // s
///     void contacts(double t, double dt, std::vector<ContactState>& out) const;        // impulses over the last dt
template <class Motion>
class ClosedForm final : public Simulation {
 public:
  explicit ClosedForm(Motion motion) : motion_(std::move(motion)) {}

  void step(double dt) override {
    elapsed_.add(dt);
    last_ = dt;
  }

  void read(std::span<BodyState> out) const override { motion_.at(elapsed_.seconds(), out); }

  void read_contacts(std::vector<ContactState>& out) const override {
    if constexpr (requires { motion_.contacts(0.0, 0.0, out); }) motion_.contacts(elapsed_.seconds(), last_, out);
  }

  double valid_until() const override {
    if constexpr (requires { motion_.valid_until(); }) {
      return motion_.valid_until();
    } else {
      return Simulation::valid_until();
    }
  }

 private:
  Motion motion_;
  Elapsed elapsed_;
  double last_ = 0;
};

struct ClosedFormText {
  std::string name;
  std::string about;
  std::string source;
};

/// The catalog's entry of a closed form; `recognise` reads nothing but the scene.
template <class Motion>
Engine closed_form(ClosedFormText text, Recognised<Motion> (*recognise)(const Scene&)) {
  Engine engine;
  engine.name = std::move(text.name);
  engine.about = std::move(text.about);
  engine.source = std::move(text.source);
  engine.exact = true;
  engine.stepping = [](const Settings&, double dt) {
    return Stepping{.dt = dt, .h = 0, .impact_lag = 0, .epsilon = 0x1p-53};
  };
  engine.unsupported = [recognise](const Scene& scene, const Settings&) -> std::string {
    const Recognised<Motion> answer = recognise(scene);
    const std::string* reason = std::get_if<std::string>(&answer);
    return reason ? *reason : "";
  };
  engine.build = [recognise, name = engine.name](const Scene& scene, const Settings&) -> std::unique_ptr<Simulation> {
    Recognised<Motion> answer = recognise(scene);
    if (const std::string* reason = std::get_if<std::string>(&answer)) {
      throw std::invalid_argument(name + " cannot run " + scene.name + ": " + *reason);
    }
    return std::make_unique<ClosedForm<Motion>>(std::get<Motion>(std::move(answer)));
  };
  return engine;
}

}  // namespace plumb
