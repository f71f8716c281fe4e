#include "scenarios/images.h"

#include <algorithm>
#include <cmath>

#include "scenarios/scene/mass.h"
#include "scenarios/scene/path.h"
#include "scenarios/scene/shapes.h"

namespace plumb {
namespace {

Vec sum(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }

// In the frame of its body.
struct MirrorGeometry {
  static Vec of(Vec v) { return {-v.x, v.y}; }
  void operator()(Circle& circle) const { circle.center = of(circle.center); }
  void operator()(Box& box) const {
    box.center = of(box.center);
    box.angle = -box.angle;
  }
  void operator()(Polygon& polygon) const {
    for (Vec& vertex : polygon.vertices) vertex = of(vertex);
    std::reverse(polygon.vertices.begin(), polygon.vertices.end());  // keeps the winding
  }
  void operator()(Capsule& capsule) const {
    capsule.from = of(capsule.from);
    capsule.to = of(capsule.to);
  }
  void operator()(Segment& segment) const {
    segment.from = of(segment.from);
    segment.to = of(segment.to);
  }
  void operator()(HalfSpace& half_space) const { half_space.normal = of(half_space.normal); }
};

struct MapJoint {
  const Congruence& map;
  void operator()(Revolute& joint) const {
    joint.anchor = map.of_point(joint.anchor);
    if (map.mirrored && joint.limits) joint.limits = Limits{-joint.limits->high, -joint.limits->low};
    if (joint.motor) joint.motor->speed = map.of_spin(joint.motor->speed);
  }
  void operator()(Distance& joint) const {
    joint.anchor_a = map.of_point(joint.anchor_a);
    joint.anchor_b = map.of_point(joint.anchor_b);
  }
  void operator()(Prismatic& joint) const {
    joint.anchor = map.of_point(joint.anchor);
    joint.axis = map.of_vector(joint.axis);
  }
  void operator()(Weld& joint) const { joint.anchor = map.of_point(joint.anchor); }
};

struct MapForce {
  const Congruence& map;
  void operator()(Attraction&) const {}
  void operator()(Spring& spring) const {
    const auto on_body = [&](Vec anchor) { return map.mirrored ? MirrorGeometry::of(anchor) : anchor; };
    spring.anchor_a = spring.a ? on_body(spring.anchor_a) : map.of_point(spring.anchor_a);
    spring.anchor_b = on_body(spring.anchor_b);
  }
  void operator()(Constant& constant) const {
    constant.force = map.of_vector(constant.force);
    constant.torque = map.of_spin(constant.torque);
  }
};

// Multiplies what has the dimension of a force by `force`, of N/m by `stiffness`, of N s/m by `damping`, of an
// attraction, m^(1 + exponent)/s^2, by length^exponent.
struct StrongerForce {
  double force, length, stiffness, damping;
  void operator()(Attraction& attraction) const { attraction.strength *= std::pow(length, attraction.exponent); }
  void operator()(Spring& spring) const {
    spring.stiffness *= stiffness;
    spring.damping *= damping;
    spring.length *= length;
    spring.anchor_a = scaled(spring.anchor_a, length);
    spring.anchor_b = scaled(spring.anchor_b, length);
  }
  void operator()(Constant& constant) const {
    constant.force = scaled(constant.force, force);
    constant.torque *= force * length;
  }
};

struct StrongerJoint {
  double force, length, time, stiffness, damping;
  void operator()(Revolute& joint) const {
    joint.anchor = scaled(joint.anchor, length);
    if (joint.motor) joint.motor = Motor{joint.motor->speed / time, joint.motor->strength * force * length};
  }
  void operator()(Distance& joint) const {
    joint.anchor_a = scaled(joint.anchor_a, length);
    joint.anchor_b = scaled(joint.anchor_b, length);
    joint.length *= length;
    joint.stiffness *= stiffness;
    joint.damping *= damping;
  }
  void operator()(Prismatic& joint) const {
    joint.anchor = scaled(joint.anchor, length);
    if (joint.limits) joint.limits = Limits{joint.limits->low * length, joint.limits->high * length};
    if (joint.motor) joint.motor = Motor{joint.motor->speed * length / time, joint.motor->strength * force};
  }
  void operator()(Weld& joint) const { joint.anchor = scaled(joint.anchor, length); }
};

// Gives every body another index.
template <class Index>
struct RenumberJoint {
  const Index& index;
  template <class Kind>
  void operator()(Kind& joint) const {
    joint.a = index(joint.a);
    joint.b = index(joint.b);
  }
};

template <class Index>
struct RenumberForce {
  const Index& index;
  void operator()(Attraction& attraction) const { attraction.from = index(attraction.from); }
  void operator()(Spring& spring) const {
    if (spring.a) spring.a = index(*spring.a);
    spring.b = index(spring.b);
  }
  void operator()(Constant& constant) const { constant.body = index(constant.body); }
};

template <class Index>
void renumber(Scene& scene, const Index& index) {
  for (Joint& joint : scene.joints) std::visit(RenumberJoint<Index>{index}, joint);
  for (Force& force : scene.forces) std::visit(RenumberForce<Index>{index}, force);
}

}  // namespace

Vec Congruence::of_vector(Vec v) const {
  const double x = mirrored ? -v.x : v.x;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * x - s * v.y, s * x + c * v.y};
}

Vec Congruence::of_point(Vec p) const { return sum(of_vector(p), shift); }

double Congruence::of_angle(double turned) const { return of_spin(turned) + angle; }

// Without a mirror the inverse turns back; a mirror M has R(a) M = M R(-a), so that R(a) M is its own inverse.
Congruence Congruence::inverse() const {
  Congruence back{.mirrored = mirrored, .angle = mirrored ? angle : -angle, .shift = {}};
  back.shift = scaled(back.of_vector(shift), -1);
  return back;
}

Scene mapped(const Scene& scene, const Congruence& map) {
  Scene image = scene;
  image.gravity = map.of_vector(scene.gravity);
  for (Body& body : image.bodies) {
    body.position = map.of_point(body.position);
    body.angle = map.of_angle(body.angle);
    body.velocity = map.of_vector(body.velocity);
    body.angular_velocity = map.of_spin(body.angular_velocity);
    if (body.path) body.path->amplitude = map.of_vector(body.path->amplitude);
    if (!map.mirrored) continue;
    for (Shape& shape : body.shapes) std::visit(MirrorGeometry{}, shape.geometry);
  }
  for (Joint& joint : image.joints) std::visit(MapJoint{map}, joint);
  for (Force& force : image.forces) std::visit(MapForce{map}, force);
  return image;
}

Scene with_masses(const Scene& scene, double factor) {
  Scene image = scene;
  for (Body& body : image.bodies) {
    for (Shape& shape : body.shapes) shape.surface.density *= factor;
  }
  for (Joint& joint : image.joints) std::visit(StrongerJoint{factor, 1, 1, factor, factor}, joint);
  for (Force& force : image.forces) std::visit(StrongerForce{factor, 1, factor, factor}, force);
  return image;
}

Scene in_units(const Scene& scene, double length, double mass) {
  const double time = std::sqrt(length);
  Scene image = scene;
  image.duration *= time;
  for (Body& body : image.bodies) {
    body.position = scaled(body.position, length);
    body.velocity = scaled(body.velocity, length / time);
    body.angular_velocity /= time;
    body.linear_damping /= time;
    body.angular_damping /= time;
    if (body.path) {
      body.path = scaled(*body.path, length);
      body.path->frequency /= time;
    }
    for (Shape& shape : body.shapes) {
      shape.geometry = scaled(shape.geometry, length);
      shape.surface.density *= mass / (length * length);
    }
  }
  const double stiffness = mass / (time * time);
  const double damping = mass / time;
  for (Joint& joint : image.joints) std::visit(StrongerJoint{mass, length, time, stiffness, damping}, joint);
  for (Force& force : image.forces) std::visit(StrongerForce{mass, length, stiffness, damping}, force);
  return image;
}

Scene boosted(const Scene& scene, Vec u) {
  Scene image = scene;
  for (Body& body : image.bodies) {
    if (body.type == BodyType::fixed) {
      body.type = BodyType::kinematic;
      body.velocity = {};
      body.angular_velocity = 0;
    }
    body.velocity = sum(body.velocity, u);
  }
  return image;
}

Scene listed_backwards(const Scene& scene) {
  Scene image = scene;
  renumber(image, [last = scene.bodies.size() - 1](std::size_t i) { return last - i; });
  std::reverse(image.bodies.begin(), image.bodies.end());
  for (Body& body : image.bodies) std::reverse(body.shapes.begin(), body.shapes.end());
  std::reverse(image.joints.begin(), image.joints.end());
  std::reverse(image.forces.begin(), image.forces.end());
  return image;
}

Scene doubled(const Scene& scene, Vec shift, std::uint32_t layers, int apart) {
  Scene copy = mapped(scene, {.shift = shift});
  renumber(copy, [n = scene.bodies.size()](std::size_t i) { return n + i; });
  Scene both = scene;
  for (Body& body : both.bodies) body.layers &= layers;
  for (Body& body : copy.bodies) {
    body.name += " (copy)";
    body.layers = (body.layers & layers) << apart;
  }
  both.bodies.insert(both.bodies.end(), copy.bodies.begin(), copy.bodies.end());
  both.joints.insert(both.joints.end(), copy.joints.begin(), copy.joints.end());
  both.forces.insert(both.forces.end(), copy.forces.begin(), copy.forces.end());
  return both;
}

double extent_of(const Scene& scene) {
  Vec low, high;
  double size = 0;
  bool any = false;
  for (const Body& body : scene.bodies) {
    const Mass mass = mass_of(body);
    if (body.type != BodyType::dynamic) continue;
    if (mass.mass > 0 && mass.inertia > 0) size = std::max(size, std::sqrt(mass.inertia / mass.mass));
    low = any ? Vec{std::min(low.x, body.position.x), std::min(low.y, body.position.y)} : body.position;
    high = any ? Vec{std::max(high.x, body.position.x), std::max(high.y, body.position.y)} : body.position;
    any = true;
  }
  const double apart = std::hypot(high.x - low.x, high.y - low.y) / 2 + size;
  return apart > 0 ? apart : 1;
}

}  // namespace plumb
