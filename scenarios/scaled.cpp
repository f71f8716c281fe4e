#include "scenarios/scaled.h"

#include <cmath>

namespace plumb {
namespace {

Vec operator*(double factor, Vec v) { return {factor * v.x, factor * v.y}; }

struct ScaledGeometry {
  double factor;
  Geometry operator()(const Circle& circle) const { return Circle{factor * circle.radius, factor * circle.center}; }
  Geometry operator()(const Box& box) const { return Box{factor * box.size, factor * box.center, box.angle}; }
  Geometry operator()(Polygon polygon) const {
    for (Vec& vertex : polygon.vertices) vertex = factor * vertex;
    return polygon;
  }
  Geometry operator()(const Capsule& capsule) const {
    return Capsule{factor * capsule.from, factor * capsule.to, factor * capsule.radius};
  }
  Geometry operator()(const Segment& segment) const { return Segment{factor * segment.from, factor * segment.to}; }
  Geometry operator()(const HalfSpace& solid) const { return HalfSpace{solid.normal, factor * solid.offset}; }
};

struct ScaledJoint {
  double factor;
  Joint operator()(Distance joint) const {
    joint.anchor_a = factor * joint.anchor_a;
    joint.anchor_b = factor * joint.anchor_b;
    joint.length *= factor;
    return joint;
  }
  template <class AtOneAnchor>
  Joint operator()(AtOneAnchor joint) const {
    joint.anchor = factor * joint.anchor;
    return joint;
  }
};

// With the masses kept, accelerations and forces grow as lengths do, torques as their square; N/m and N s/m stay.
struct ScaledForce {
  double factor;
  Force operator()(Attraction force) const {
    force.strength *= std::pow(factor, 1 + force.exponent);
    return force;
  }
  Force operator()(Spring force) const {
    force.anchor_a = factor * force.anchor_a;
    force.anchor_b = factor * force.anchor_b;
    force.length *= factor;
    return force;
  }
  Force operator()(Constant force) const {
    force.force = factor * force.force;
    force.torque *= factor * factor;
    return force;
  }
};

}  // namespace

Scene scaled(const Scene& scene, double factor) {
  Scene larger = scene;
  larger.gravity = factor * scene.gravity;
  for (Body& body : larger.bodies) {
    body.position = factor * body.position;
    body.velocity = factor * body.velocity;
    for (Shape& shape : body.shapes) {
      shape.geometry = std::visit(ScaledGeometry{factor}, shape.geometry);
      shape.surface.density /= factor * factor;
    }
  }
  for (Joint& joint : larger.joints) joint = std::visit(ScaledJoint{factor}, joint);
  for (Force& force : larger.forces) force = std::visit(ScaledForce{factor}, force);
  return larger;
}

}  // namespace plumb
