#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "scenarios/catalog.h"
#include "scenarios/scene/scene.h"

/// What a step costs each engine, on scenes that engines are commonly timed on.
namespace plumb::benchmarks {

/// Steps `from` ... `to` - 1 of a run, counted from its start.
struct Window {
  int from = 0, to = 0;
  int steps() const { return to - from; }
};

/// One body that was put upon another.
struct Rest {
  std::size_t above = 0, below = 0;
};

/// A scene to be timed, and what tells whether it is still that scene: time on a broken one is no result.
struct Start {
  Scene scene;
  double size = 0;                                         // m, across the smallest body
  std::vector<Rest> rests;                                 // what must still lie as it was put
  Vec center;                                              // of the circle that no dynamic body may leave
  double reach = std::numeric_limits<double>::infinity();  // m, its radius
};

/// A kind of scene with the parts of its run that are worth timing.
struct Course {
  std::string name;
  std::string about;  // one line
  Window settled;     // at rest; none: empty
  Window moving;      // what moves, falls or collides; none: empty
  std::function<Start()> start;
};

}  // namespace plumb::benchmarks
