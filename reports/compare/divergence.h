#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/trace.h"
#include "scenarios/scenario.h"

/// Where two runs of one scene part, and over what.
namespace plumb {

/// The part of a step in which they do, as far as they report it.
enum class Stage {
  start,        // before the first step
  integration,  // nothing touches the body
  event_time,   // one meets what the other meets some steps later
  contact_set,  // one touches what the other does not
  manifold,     // the same bodies touch, at other points, normals or separations
  impulse,      // the same contacts push or rub otherwise
  not_reported  // what both tell of the contacts does not explain it
};
const char* name_of(Stage);

/// A run and what its engine states of its steps. The trace must outlive it.
struct Side {
  std::string name;
  const Trace* trace = nullptr;
  Stepping stepping;
};

/// One number as both runs have it.
struct Figure {
  std::string what;  // "y of box"
  std::string unit;
  std::optional<double> a, b;  // nothing where that run does not know it
  double difference = 0;       // |a - b|
  double tolerance = 0;        // below which it counts as the same
};

/// When the first difference had grown to so many times its size.
struct Growth {
  double factor = 1;
  std::size_t step = 0;
  double time = 0;        // s
  double difference = 0;  // the largest of all bodies, in the first difference's unit
};

struct Divergence {
  std::size_t step = 0;  // 0 is the start
  double time = 0;       // s
  Stage stage = Stage::integration;
  std::string body;             // that parted by the most, against what is allowed
  std::string other;            // whom it touches, where that is what they part over; "" else
  Figure first;                 // of the body's state
  std::vector<Figure> figures;  // its state and the contact in question
  std::string advice;           // a sentence or two: where to look
  std::vector<Growth> growth;   // at 1, 10, 100 ... times, as far as it went, and at the end (factor as it is then)
};

struct Compared {
  std::size_t steps = 0;  // that both have
  double until = 0;       // s
  Figure largest;         // where they never part: the difference that came nearest to it
  std::optional<Divergence> parted;
};

/// The first step after which any body's state differs by more than `tolerance` (m, rad, m/s, rad/s alike) or, without
/// one, by more than round-off explains. Both runs are of that scene, with the same time step; throws
/// std::invalid_argument where they are not. Where one ends early, so does the comparison.
Compared compare_steps(const Scene&, const Side& a, const Side& b, std::optional<double> tolerance);

}  // namespace plumb
