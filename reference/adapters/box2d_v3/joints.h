#pragma once

#include <box2d/box2d.h>

#include <cmath>
#include <span>
#include <string>

#include "scenarios/scene/scene.h"

/// Vectors, angles and joints of the scene in the types of Box2D 3. In a namespace of their own because 2.4 has types
/// of the same names.
namespace plumb::box2d_v3 {

inline b2Vec2 to_b2(Vec v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

template <class Point>  // b2Vec2, or b2Pos with double coordinates
Vec from_b2(Point p) {
  return {p.x, p.y};
}

inline b2Rot rotation_by(double angle) {
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

/// Adds the scene's joints to a world that holds its bodies, given in Scene order and centred (see plumb::centered).
void add_joints(b2WorldId, const Scene&, std::span<const b2BodyId>);

/// Why the stiffness of a soft distance joint cannot be set; "" if it can.
std::string eccentric_spring_refusal(const Scene&);

}  // namespace plumb::box2d_v3
