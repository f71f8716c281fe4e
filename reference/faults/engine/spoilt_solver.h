#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "reference/faults/engine/faulty.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What a spoilt solver may tamper with: the bodies themselves, and copies of all else that go no further than the
/// step. Contacts may be changed, dropped, doubled and put in any order.
struct SpoiltStep {
  BodySet& bodies;
  std::vector<Contact> contacts;
  ForceField forces;
  Settings settings;
};

/// A solver that does as a right one does, but for what is tampered with before or after a step of it.
class SpoiltSolver : public Solver {
 public:
  explicit SpoiltSolver(std::string_view right) : right_(MethodList<Solver>::make(right)) {}

  void step(StepData& data) final;
  void state(const Settings& settings, StatedErrors& errors) const final { right_->state(settings, errors); }
  bool contact_persistence() const final { return right_->contact_persistence(); }
  Margin margin(const Settings& settings) const override { return right_->margin(settings); }

 protected:
  virtual void before(SpoiltStep&) {}
  virtual void after(SpoiltStep&) {}

 private:
  std::unique_ptr<Solver> right_;
};

/// The same for mistakes that remember nothing.
class Spoilt : public SpoiltSolver {
 public:
  using Tampering = std::function<void(SpoiltStep&)>;
  explicit Spoilt(std::string_view right, Tampering before, Tampering after = nullptr)
      : SpoiltSolver(right), before_(std::move(before)), after_(std::move(after)) {}

 private:
  void before(SpoiltStep& step) override {
    if (before_) before_(step);
  }
  void after(SpoiltStep& step) override {
    if (after_) after_(step);
  }
  Tampering before_, after_;
};

/// Joins a mistake that remembers nothing.
inline Faulty<Solver> spoilt(Fault fault, const Spoilt::Tampering& before, const Spoilt::Tampering& after = nullptr) {
  const std::string right = fault.spoils;
  return {std::move(fault), [=] { return std::make_unique<Spoilt>(right, before, after); }};
}

}  // namespace impulse::inline IMPULSE_PRECISION
