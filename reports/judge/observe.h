#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "reports/judge/conserved.h"
#include "reports/trace.h"
#include "scenarios/scenario.h"

namespace plumb {

struct Reading {
  double time = 0;  // s; of an apex: when it was passed
  double value = 0;
};

/// The index of the body of that name in Scene::bodies. Throws std::invalid_argument, naming the nearest, if there is
/// none.
std::size_t index_of(const Scene&, std::string_view body);

/// A quantity that a moment has by itself (those before load). `body` counts for quantities of a body only.
double quantity_of(Quantity, std::size_t body, const Conserved&, std::span<const BodyState>);

/// The most by which the energy comes above that of an earlier moment, J, up to the given moment; and when.
Reading energy_rise(const Conserved&, const Trace&, std::size_t last);

/// Whether a engine showed what a quantity is read from: loads need contacts, and some engines report none.
bool reports(const Trace&, Quantity);

/// What a trace says of an expectation's quantity: at its time, linear between steps; or the mean over the time up to
/// then; or at an apex: the vertex of the parabola through the highest sample and its neighbours, exact in free flight.
/// A landing is the lowest sample. `time` counts where the expectation gives none. Nothing when the trace ends before
/// that or has no such extremum.
std::optional<Reading> observe(const Scene&, const Trace&, const Expectation&, double time);

}  // namespace plumb
