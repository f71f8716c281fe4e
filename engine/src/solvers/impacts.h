#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "body_set.h"
#include "contact_rows.h"

namespace impulse::inline IMPULSE_PRECISION {

/// How far a body has come since the start of the step. Small numbers, so that float keeps them to the last place.
struct Motion {
  Vec2 d;         // m
  Real turn = 0;  // rad
  Real sine = 0;  // of turn
  Real drop = 0;  // cos(turn) - 1
  void turn_by(Real angle);
};

/// A row, and what the sub-step of `accurate` needs to know beside it.
struct ImpactRow : ContactRow {
  Real offset = 0;           // m, standing correction of the separation (see accurate.cpp)
  Real disc_distance = 0;    // m, sum of radii when both are discs about their centres: their normal turns as they move
  Vec2 between;              // of those centres at the start of the step
  std::array<Vec2, 2> half;  // of each point's last impulse, along normal and tangent
  int age = 0;               // steps since the contact began
  bool active = true;        // takes part in this sub-step's solve
  bool fresh = false;        // first step of the contact
  bool block = false;        // its two points are solved together
};

/// s(t) of a point whose bodies have come so far, exact for rigid motion against a normal that stands still:
/// n . (R(turn) r - r) = sine (r x n) + drop (r . n).
inline Real separation(const ImpactRow& row, const RowPoint& p, const Motion& a, const Motion& b) {
  return p.separation + dot(row.normal, b.d - a.d) + (b.sine * p.cross_b + b.drop * p.turn_b) -
         (a.sine * p.cross_a + a.drop * p.turn_a);
}

/// Slower approaches (m/s) are left to the contact solve: ends the infinite sequence of ever smaller bounces ("Zeno").
constexpr Real impact_threshold = static_cast<Real>(0.1);

/// Newton's impact law at the very moment of touching, inside a sub-step of h seconds.
///
/// Between impacts a body moves as d + v t + a t^2/2. At the earliest impact time tau the impulse J changes v by J/m;
/// shifting the start of the path by -tau J/m makes the whole sub-step come out as if it had been split at tau, without
/// splitting it. Repeats in order of time until no contact with restitution hits before h. Rows that still approach
/// afterwards hit in a later sub-step and are made inactive for this one.
class Impacts {
 public:
  void resolve(std::span<ImpactRow> rows, BodySet& bodies, std::vector<Motion>& motion,
               const std::vector<Velocity>& acceleration, Real h);

 private:
  struct Candidate {
    std::size_t row = 0;
    Real time = 0;   // of the next impact; infinite when there is none
    Real speed = 0;  // of approach then
  };
  std::vector<Candidate> candidates_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
