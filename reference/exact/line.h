#pragma once

#include <limits>
#include <span>
#include <vector>

/// Impacts on one line: of a point on a floor, and of bodies between two walls.
namespace plumb {

/// A point dropped vertically onto a floor: a sequence of parabolas, each starting at e times the speed of the last.
/// Valid for ever: if e < 1 the landings accumulate at a finite time, and the point rests from then on.
class Bounce {
 public:
  /// height in m above the floor and speed in m/s upwards at the start, gravity in m/s^2 > 0, restitution 0 ... 1.
  Bounce(double height, double speed, double gravity, double restitution);

  struct State {
    double height = 0;  // m
    double speed = 0;   // m/s upwards
  };
  State at(double t) const;

  double apex(int n) const;    // m, height after the n-th landing
  double impact(int n) const;  // s, time of the n-th landing
  double rest() const;         // s, time when it comes to rest; infinite for e = 1

 private:
  State start_;
  double gravity_;
  double restitution_;
  double landing_;        // s, of the first
  double landing_speed_;  // m/s downwards, of the first
};

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
