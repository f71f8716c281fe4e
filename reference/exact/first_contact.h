#pragma once

#include <optional>
#include <vector>

#include "reference/exact/recognise.h"

namespace plumb {

/// A round corner of a body: a point of its frame, measured from the centre of mass, with a radius (0 for a sharp one).
struct Corner {
  Vec offset;         // m
  double radius = 0;  // m
};

/// The corners of a body, by which alone it can touch a plane.
std::vector<Corner> corners_of(const Body&);

/// How far a corner is off the floor, m.
double clearance(const Corner&, const BodyState&, const Floor&);

struct Contact {
  double time = 0;  // s from the given state
  std::size_t corner = 0;
};

/// The first contact of a spinning body in free flight with the floor within `horizon` seconds, to round-off.
/// A corner that touches at the start and moves away counts from its return.
std::optional<Contact> first_contact(const BodyState&, Vec gravity, const std::vector<Corner>&, const Floor&,
                                     double horizon);

}  // namespace plumb
