#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "reference/scene_facts.h"
#include "scenarios/scene/vec.h"

/// What closed forms look for in a scene.
namespace plumb {

/// Why no textbook case fits: joints, forces or damping; "" if one may.
std::string textbook_refusal(const Scene&);

/// The same for closed forms of bodies that touch: also if there are bodies that pass through each other.
std::string contact_refusal(const Scene&);

/// A straight floor in the world frame: solid where normal . p <= offset, for `from` <= along . p <= `to`.
struct Floor {
  Vec normal;
  double offset = 0;  // m
  double from = 0;    // m
  double to = 0;      // m
  Vec along() const { return {normal.y, -normal.x}; }
};

/// The surface of a fixed body made of one half-space, or the face of its only box that `above` is over, or, if none
/// is, the face that is most opposed to gravity; nullopt for other bodies.
std::optional<Floor> floor_of(const Body&, Vec gravity, std::optional<Vec> above = std::nullopt);

/// Two bodies, one fixed and one dynamic, in either order.
struct BodyOnGround {
  std::size_t ground = 0, body = 0;
};
std::optional<BodyOnGround> single_body_on_ground(const Scene&);

/// One dynamic body over a fixed floor: a single fixed body, or several whose surfaces are flush and side by side, with
/// the same coefficients. nullopt for other scenes.
struct BodyOnFloor {
  std::size_t body = 0;
  std::size_t ground = 0;  // one of the fixed bodies
  Floor floor;
};
std::optional<BodyOnFloor> single_body_on_floor(const Scene&);

/// Width along the floor and height above it of a box whose body has this angle; nullopt if its sides are not parallel
/// to the floor within `geometry_tolerance`.
struct Footprint {
  double width = 0, height = 0;  // m
};
std::optional<Footprint> footprint(const Box&, double angle, const Floor&);

constexpr double geometry_tolerance = 1e-9;  // rad and m: error of a scene file, which has ten digits

struct Coefficients {
  double static_friction = 0, dynamic_friction = 0, restitution = 0;
  friend bool operator==(const Coefficients&, const Coefficients&) = default;
};

/// The mixed coefficients of the first shapes of two bodies.
Coefficients mixed_coefficients(const Scene&, const Body&, const Body&);

}  // namespace plumb
