#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "scenarios/scene/scene.h"

namespace plumb {

/// A disc that rolls in a bowl of flat pieces, each turned from the last by the angle a of a kink. Its centre moves on
/// pieces too.
class RollingInBowl {
 public:
  static constexpr double gravity = 10;  // m/s^2
  static constexpr double radius = 0.5;  // m, of the disc
  static constexpr double round = 3;     // m, from the bowl's centre to each of its flat pieces

  /// Of kinks of that angle, rad; the disc starts on the piece of that index, counted from the level one to the right.
  RollingInBowl(double kink, int first) : kink_(kink), half_((round - radius) * std::tan(kink / 2)), first_(first) {}

  double kink() const { return kink_; }
  int first() const { return first_; }
  double slope(int piece) const { return piece * kink_; }
  Vec normal(int piece) const { return {-std::sin(slope(piece)), std::cos(slope(piece))}; }

  /// About the contact with the next piece the disc keeps its angular momentum: (3/2) v' = (1/2 + cos a) v.
  double kept() const { return (1 + 2 * std::cos(kink_)) / 3; }

  struct Rolling {
    int piece = 0;
    double place = 0;  // m, along the piece, from its middle
    double speed = 0;  // m/s
    double path = 0;   // m, rolled so far, to the right
  };
  double acceleration(const Rolling& now) const { return -2.0 / 3 * gravity * std::sin(slope(now.piece)); }

  Vec centre(const Rolling& now) const {
    const Vec n = normal(now.piece);
    return {-(round - radius) * n.x + now.place * n.y, round - (round - radius) * n.y - now.place * n.x};
  }

  /// A passage over a kink, and what comes before.
  struct Passage {
    double time = 0;  // s
    double took = 0;  // s, on the piece before it
    Rolling before, after;
  };

  /// After that time; kinks on the way are added to `passed`.
  Rolling rolled(Rolling now, double time, std::vector<Passage>* passed = nullptr) const {
    double gone = 0;
    while (true) {
      const double right = reaches(now, half_);
      const double left = reaches(now, -half_);
      const double next = std::min(right, left);
      if (gone + next >= time) return moved(now, time - gone);
      const Rolling before = moved(now, next);
      gone += next;
      const int way = right < left ? 1 : -1;
      now = {before.piece + way, -way * half_, kept() * before.speed, before.path};
      if (passed != nullptr) passed->push_back({gone, next, before, now});
    }
  }

 private:
  Rolling moved(Rolling now, double t) const {
    const double a = acceleration(now);
    const double way = now.speed * t + a * t * t / 2;
    return {now.piece, now.place + way, now.speed + a * t, now.path + way};
  }

  // s, until it is there, from somewhere else; infinite if it never is.
  double reaches(const Rolling& now, double end) const {
    constexpr double somewhere_else = 1e-9;
    const double a = acceleration(now) / 2;
    const double c = now.place - end;
    const double root = std::sqrt(now.speed * now.speed - 4 * a * c);  // NaN if never
    double soonest = std::numeric_limits<double>::infinity();
    for (const double sign : {-1.0, 1.0}) {
      const double t = a == 0 ? -c / now.speed : (-now.speed + sign * root) / (2 * a);
      if (t > somewhere_else) soonest = std::min(soonest, t);
    }
    return soonest;
  }

  double kink_;
  double half_;  // m, half the length of a piece on which the centre moves
  int first_;
};

}  // namespace plumb
