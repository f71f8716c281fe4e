#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reference/exact/recognise.h"
#include "reference/simulation.h"
#include "scenarios/scene/scene.h"

/// Free flight, about a centre or under constant gravity, and where it ends.
namespace plumb {

/// The state of a body after t seconds of constant acceleration, m/s^2: r + v t + a t^2/2, angle + w t (Galileo).
BodyState free_flight(const BodyState& start, Vec acceleration, double t);

/// Bodies that touch nothing: each follows a parabola and keeps its angular velocity. Valid for ever.
class Ballistic {
 public:
  Ballistic(std::vector<BodyState> start, std::vector<Vec> acceleration);

  void at(double t, std::span<BodyState> out) const;

 private:
  std::vector<BodyState> start_;
  std::vector<Vec> acceleration_;  // m/s^2, of each body
};

/// A round corner of a body: a point of its frame relative to the centre of mass, with a radius (0 for a sharp corner).
struct Corner {
  Vec offset;         // m
  double radius = 0;  // m
};

/// All corners of a body. It can touch a plane only with one of these.
std::vector<Corner> corners_of(const Body&);

/// Distance of a corner from the floor, m; negative below it.
double clearance(const Corner&, const BodyState&, const Floor&);

struct FloorContact {
  double time = 0;  // s from the given state
  std::size_t corner = 0;
};

/// The first contact with the floor of a spinning body in free flight within `horizon` seconds, to round-off; nullopt
/// if there is none. A corner that touches at the start and moves away counts from its return.
std::optional<FloorContact> first_contact(const BodyState&, Vec gravity, const std::vector<Corner>&, const Floor&,
                                          double horizon);

/// An ellipse about a centre that attracts with strength/r^2 (Kepler). Valid for ever.
class Orbit {
 public:
  /// position in m and velocity in m/s relative to the centre at the start, strength in m^3/s^2. Needs
  /// v^2/2 < strength/r.
  Orbit(Vec position, Vec velocity, double strength);

  struct State {
    Vec position, velocity;
  };
  State at(double t) const;

  double period() const;  // s
  double semi_major_axis() const { return axis_; }

 private:
  Vec position_, velocity_;
  double strength_;
  double axis_;  // m
};

}  // namespace plumb
