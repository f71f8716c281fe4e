#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "reports/judge/mechanics.h"
#include "reports/trace.h"
#include "scenarios/scenario.h"

/// The quantities that scenarios expect, from a trace and from the closed form.
namespace plumb {

/// A quantity read from a trace.
struct Observation {
  double time = 0;  // s; of an apex or a landing: when it happened
  double value = 0;
};

/// The index of the body of that name in Scene::bodies. Throws std::invalid_argument, suggesting the nearest name, if
/// there is none.
std::size_t index_of(const Scene&, std::string_view body);

/// A quantity that the states of one moment determine (those before Quantity::load); throws std::invalid_argument for
/// the others. `body` matters only for quantities of a body.
double quantity_of(Quantity, std::size_t body, const Conserved&, std::span<const BodyState>);

/// The largest rise of the energy above that of an earlier moment, J, up to the moment `last`, and when.
Observation energy_rise(const Conserved&, const Trace&, std::size_t last);

/// Whether the engine reports what the quantity needs: a load needs contacts.
bool is_reported(const Trace&, Quantity);

/// An expectation's quantity: at its time, interpolated linearly, or a pose by a cubic through its speeds; or its mean
/// over the time before that; or, for an apex, the vertex of the parabola through the highest sample and its
/// neighbours, exact in free flight. A landing is where the flights before and after the lowest sample meet, exact
/// likewise. `time`, s, applies if the expectation has none. Returns nullopt if the trace ends before that time or has
/// no such extremum.
std::optional<Observation> observe(const Scene&, const Trace&, const Expectation&, double time);

/// The closed form of one scene. The engine and the scene must outlive it.
class Truth {
 public:
  /// `closed_form` must support the scene.
  Truth(const Engine& closed_form, const Scene&);
  /// That ends at a time, s, at the latest.
  Truth(const Engine& closed_form, const Scene&, double until);

  /// The states at a time, s, evaluated in one step; nullopt beyond its validity.
  std::optional<std::vector<BodyState>> at(double time) const;

  /// The duration for which it is valid, s.
  double until() const { return until_; }

 private:
  const Engine& closed_form_;
  const Scene& scene_;
  double until_;
};

/// The value that an expectation states, or else the closed form's at a time, s. Returns nullopt if there is no closed
/// form or it is not valid then. `truth` may be null.
std::optional<double> expected_value(const Scene&, const Expectation&, const Truth* truth, double time);

}  // namespace plumb
