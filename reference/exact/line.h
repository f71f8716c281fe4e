#pragma once

#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace plumb {

/// Bodies on one line between two walls that keep their speeds but for impacts of two, each by Newton's restitution.
/// Solved from impact to impact. Ends where more than two would meet at once, or where impacts pile up without end.
class Line {
 public:
  struct Particle {
    double place = 0;  // m
    double speed = 0;  // m/s
    double mass = 0;   // kg
    double half = 0;   // m, from the centre to either end
  };
  struct Walls {
    double left = -std::numeric_limits<double>::infinity();
    double right = std::numeric_limits<double>::infinity();
  };

  /// Particles from left to right without overlap; restitution of particle i with its left neighbour, the wall for i =
  /// 0, is restitution[i], and the last is that of the right wall: one more than particles. Solved until `horizon` s.
  Line(std::vector<Particle> particles, Walls walls, std::vector<double> restitution, double horizon);

  /// Place and speed of every particle at t <= valid_until.
  void at(double t, std::span<Particle> out) const;

  double valid_until() const { return until_; }
  std::size_t impacts(double until) const;  // up to that time

 private:
  struct Epoch {
    double time = 0;  // s, of the impact that begins it
    std::vector<Particle> particles;
  };
  std::vector<Epoch> epochs_;
  double until_ = std::numeric_limits<double>::infinity();
};

}  // namespace plumb
