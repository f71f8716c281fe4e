#pragma once

#include <box2d/box2d.h>

#include <cmath>

#include "scenarios/scene/scene.h"

/// The scene's vectors and angles in Box2D's types. In a namespace of their own: 2.4 has types of the same names.
namespace plumb::box2d_v3 {

inline b2Vec2 to_b2(Vec v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

template <class Point>  // b2Vec2, or b2Pos of doubles
Vec from_b2(Point p) {
  return {p.x, p.y};
}

inline b2Rot turn_of(double angle) {
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

}  // namespace plumb::box2d_v3
