#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reference/plane.h"

/// What closed forms look for in a scene.
namespace plumb {

/// Why no textbook case fits: joints, forces or damping; "" when one may.
std::string beyond_textbook(const Scene&);

/// The state of the centre of mass at the start.
BodyState start_of(const Body&);
std::vector<BodyState> start_of(const Scene&);

/// Gravity as this body feels it, m/s^2.
Vec gravity_of(const Scene&, const Body&);

/// A straight floor in the world frame: solid where normal . p <= offset, for `from` <= along . p <= `to`.
struct Floor {
  Vec normal;
  double offset = 0;  // m
  double from = 0;    // m
  double to = 0;      // m
  Vec along() const { return {normal.y, -normal.x}; }
};

/// The surface of a fixed body made of one half-space, or that face of its one box that looks against gravity the most.
/// Nothing for other bodies.
std::optional<Floor> floor_of(const Body&, Vec gravity);

/// The only shape of a body, if it is of that kind; null otherwise.
template <class Kind>
const Kind* lone(const Body& body) {
  return body.shapes.size() == 1 ? std::get_if<Kind>(&body.shapes.front().geometry) : nullptr;
}

/// Two bodies of which one is fixed and the other dynamic, in either order.
struct Pair {
  std::size_t ground = 0, body = 0;
};
std::optional<Pair> one_on_ground(const Scene&);

/// One dynamic body over fixed ground with one surface: a single fixed body, or several whose surfaces lie flush, side
/// by side, and rub alike. Nothing for other scenes.
struct OnFloor {
  std::size_t body = 0;
  std::size_t ground = 0;  // one of the fixed bodies
  Floor floor;
};
std::optional<OnFloor> one_on_floor(const Scene&);

/// How a box at `angle` lies on a floor: its width along and its height off it. Nothing if its sides are not parallel
/// to the floor within `flat`.
struct Footprint {
  double width = 0, height = 0;  // m
};
std::optional<Footprint> footprint(const Box&, double angle, const Floor&);
constexpr double flat = 1e-9;  // rad and m: what a scene written with ten digits, as its format shows, leaves

struct Coefficients {
  double static_friction = 0, dynamic_friction = 0, restitution = 0;
  friend bool operator==(const Coefficients&, const Coefficients&) = default;
};

/// The mixed ones of the first shapes of two bodies.
Coefficients between(const Scene&, const Body&, const Body&);

}  // namespace plumb
