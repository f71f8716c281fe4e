#pragma once

#include <algorithm>
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
#include "scenarios/scene/scene.h"

/// How every closed form becomes an engine: recognise a scene, then evaluate a formula.
namespace plumb {

/// s, the time of an event that does not happen.
constexpr double never = std::numeric_limits<double>::infinity();

/// s, the longest step: the last one of a run may end after the scene, by less than that.
constexpr double longest_step = 1;

/// The motion of a scene, or why the closed form cannot solve it.
template <class Motion>
using Recognised = std::variant<Motion, std::string>;

/// Time by compensated summation (Kahan): after a million steps it is as exact as after one.
class ElapsedTime {
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

/// Writes initial states; the formula of a motion then overwrites those of the bodies that move.
inline void write_states(const std::vector<BodyState>& start, std::span<BodyState> out) {
  std::copy(start.begin(), start.end(), out.begin());
}

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
  ElapsedTime elapsed_;
  double last_ = 0;
};

struct ClosedFormText {
  std::string name;
  std::string about;
  std::string source;
};

/// A closed form as an engine of the catalog. `recognise` depends on the scene alone.
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
  const auto checked = [recognise](const Scene& scene) -> Recognised<Motion> {
    if (has_paths(scene)) return "handles no bodies on paths";
    return recognise(scene);
  };
  engine.unsupported = [checked](const Scene& scene, const Settings&) -> std::string {
    const Recognised<Motion> answer = checked(scene);
    const std::string* reason = std::get_if<std::string>(&answer);
    return reason ? *reason : "";
  };
  engine.build = [checked, name = engine.name](const Scene& scene, const Settings&) -> std::unique_ptr<Simulation> {
    Recognised<Motion> answer = checked(scene);
    if (const std::string* reason = std::get_if<std::string>(&answer)) {
      throw std::invalid_argument(name + " cannot run " + scene.name + ": " + *reason);
    }
    return std::make_unique<ClosedForm<Motion>>(std::get<Motion>(std::move(answer)));
  };
  return engine;
}

}  // namespace plumb
