#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "solver/impact_row.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Newton's impact law with Coulomb friction, at one or two points of a contact, in the space of their relative
/// velocities: v' = v + K j. Vectors are (normal, tangential); K holds the inverse effective masses (1/kg) of the two
/// bodies, or of all that joints connect with them.
class Collision {
 public:
  /// The points of the row that hit at these velocities: the lower of those that approach, and the other one too if it
  /// also almost touches.
  Collision(ImpactRow& row, const Velocity& a, const Velocity& b);

  /// Takes K from the masses of the two bodies.
  void couple();
  /// Takes K from how impulses change velocities: `respond(push)` calls push(a, b) with the bodies' velocities, and
  /// returns the bodies with the velocities that the joints make of them.
  template <class Respond>
  void couple(Respond respond);
  /// Computes the impulses, which the points' totals take.
  void solve();
  /// Applies them to the velocities of the two bodies.
  void apply(Velocity& a, Velocity& b) const;

 private:
  struct Point {
    RowPoint* row = nullptr;
    Vec2 v;  // m/s
    Vec2 j;  // N s
  };
  std::span<Point> points() { return std::span(points_).first(count_); }
  void push(std::size_t at, Vec2 j);
  void solve_one();
  void solve_two();
  bool rub(std::size_t at, Real most);

  ImpactRow& row_;
  std::size_t count_ = 1;
  std::array<Point, 2> points_;
  std::array<std::array<Mat22, 2>, 2> k_;  // [point][point pushed]
};

template <class Respond>
void Collision::couple(Respond respond) {
  for (std::size_t to = 0; to < count_; ++to) {
    const RowPoint& pushed = *points_[to].row;
    for (const bool tangential : {false, true}) {
      // As large as stops a metre a second without joints.
      const Real unit = tangential ? effective_mass(row_, pushed.dot_a, pushed.dot_b)
                                   : effective_mass(row_, pushed.cross_a, pushed.cross_b);
      const auto [a, b] = respond([&](Velocity& va, Velocity& vb) {
        ContactFrame frame(row_, va, vb);
        if (tangential) {
          frame.push_tangent(row_, pushed, unit);
        } else {
          frame.push_normal(row_, pushed, unit);
        }
        frame.write_back(row_, va, vb);
      });
      const ContactFrame frame(row_, a, b);
      for (std::size_t at = 0; at < count_; ++at) {
        const RowPoint& p = *points_[at].row;
        const Vec2 now{frame.normal_velocity(p), frame.tangent_velocity(p)};
        (tangential ? k_[at][to].y : k_[at][to].x) = (now - points_[at].v) / unit;
      }
    }
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
