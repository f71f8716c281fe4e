#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "reference/faults/engine/faulty.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What a mutated solver may change: the bodies themselves, and copies of the rest that last only for the step.
/// Contacts may be changed, dropped, duplicated and reordered.
struct MutatedStep {
  BodySet& bodies;
  std::vector<Contact> contacts;
  ForceField forces;
  Settings settings;
};

/// A right solver whose input or output is changed before or after each of its steps.
class MutatedSolver : public Solver {
 public:
  explicit MutatedSolver(std::string_view right) : right_(MethodList<Solver>::make(right)) {}

  void step(StepData& data) final;
  void state(const Settings& settings, StatedErrors& errors) const final { right_->state(settings, errors); }
  bool contact_persistence() const final { return right_->contact_persistence(); }
  Margin margin(const Settings& settings) const override { return right_->margin(settings); }

 protected:
  virtual void before(MutatedStep&) {}
  virtual void after(MutatedStep&) {}

 private:
  std::unique_ptr<Solver> right_;
};

/// The same for mistakes without state.
class StatelessMutation : public MutatedSolver {
 public:
  using Change = std::function<void(MutatedStep&)>;
  explicit StatelessMutation(std::string_view right, Change before, Change after = nullptr)
      : MutatedSolver(right), before_(std::move(before)), after_(std::move(after)) {}

 private:
  void before(MutatedStep& step) override {
    if (before_) before_(step);
  }
  void after(MutatedStep& step) override {
    if (after_) after_(step);
  }
  Change before_, after_;
};

/// Adds a fault without state.
inline Faulty<Solver> mutated(Fault fault, const StatelessMutation::Change& before,
                              const StatelessMutation::Change& after = nullptr) {
  const std::string right = fault.mutates;
  return {std::move(fault), [=] { return std::make_unique<StatelessMutation>(right, before, after); }};
}

}  // namespace impulse::inline IMPULSE_PRECISION
