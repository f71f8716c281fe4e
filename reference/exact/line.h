#pragma once

#include <limits>
#include <span>
#include <vector>

namespace plumb {

/// Bodies on one line between two walls that keep their speeds except in impacts of two, each by Newton's restitution.
/// Solved from impact to impact. Ends where more than two would meet at once, or where the impacts accumulate.
class Line {
 public:
  struct Particle {
    double position = 0;  // m
    double speed = 0;     // m/s
    double mass = 0;      // kg
    double half = 0;      // m, from the centre to either end
  };
  struct Walls {
    double left = -std::numeric_limits<double>::infinity();
    double right = std::numeric_limits<double>::infinity();
  };

  /// Particles from left to right without overlap. restitution[i] is that of particle i with its left neighbour, which
  /// is the wall for i = 0; the last one is that of the right wall, so there is one more than particles. Solved until
  /// `horizon`, s.
  Line(std::vector<Particle> particles, Walls walls, std::vector<double> restitution, double horizon);

  /// Position and speed of every particle at t <= valid_until.
  void at(double t, std::span<Particle> out) const;

  double valid_until() const { return until_; }
  std::size_t impacts(double until) const;  // number of impacts up to that time

 private:
  struct Epoch {
    double time = 0;  // s, of the impact that starts it
    std::vector<Particle> particles;
  };
  std::vector<Epoch> epochs_;
  double until_ = std::numeric_limits<double>::infinity();
};

}  // namespace plumb
