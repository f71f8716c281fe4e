#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scenarios/scene/surface.h"
#include "scenarios/scene/vec.h"

/// The engine-neutral scene that every engine is given. SI units (m, kg, s, rad, N; density in kg/m^2), double
/// precision, angles counter-clockwise, y up. Nothing here is specific to an engine.
namespace plumb {

constexpr double standard_gravity = 10;  // m/s^2, of a scene that says nothing else

struct Circle {
  double radius = 0.5;
  Vec center;  // body frame
};

struct Box {
  Vec size{1, 1};    // full width and height
  Vec center;        // body frame
  double angle = 0;  // relative to the body frame
};

struct Polygon {
  std::vector<Vec> vertices;  // body frame, convex, any winding
};

struct Capsule {
  Vec from, to;  // body frame
  double radius = 0.5;
};

struct Segment {
  Vec from, to;  // body frame
};

/// The points p with normal . p <= offset are solid, in the body frame.
struct HalfSpace {
  Vec normal{0, 1};  // unit length
  double offset = 0;
};

/// To add a kind of shape: a struct, an entry here, its functions in shapes.cpp and its entry in scene.schema.json.
using Geometry = std::variant<Circle, Box, Polygon, Capsule, Segment, HalfSpace>;

struct Shape {
  Geometry geometry;
  Surface surface;
};

enum class BodyType { fixed, kinematic, dynamic };

/// Of a kinematic body: at the time t it is amplitude (sin(2 pi frequency t + phase) - sin(phase)) beside where its
/// velocity alone would take it.
struct Path {
  Vec amplitude;         // m
  double frequency = 1;  // Hz
  double phase = 0;      // rad, at the start
  friend bool operator==(const Path&, const Path&) = default;
};

struct Body {
  std::string name;
  BodyType type = BodyType::dynamic;
  Vec position;  // of the body frame's origin; the centre of mass is computed from the shapes
  double angle = 0;
  Vec velocity;  // of the centre of mass
  double angular_velocity = 0;
  double gravity_scale = 1;
  bool fixed_rotation = false;
  bool bullet = false;
  std::uint32_t layers = ~std::uint32_t{0};  // bit mask; two bodies collide only if their masks share a bit
  double linear_damping = 0;                 // 1/s
  double angular_damping = 0;                // 1/s
  std::optional<Path> path = std::nullopt;   // of a kinematic body
  std::vector<Shape> shapes;
};

/// Joints and forces refer to bodies by their index in Scene::bodies.
/// Of b relative to a, 0 at the start; low <= high. An impact on them has no restitution.
struct Limits {
  double low = 0, high = 0;  // rad of a revolute joint, m along the axis of a prismatic one
};

/// Drives a joint to a speed as fast as its strength allows, and holds it there while its strength suffices.
struct Motor {
  double speed = 0;     // of b relative to a: rad/s of a revolute joint, m/s along the axis of a prismatic one
  double strength = 0;  // the most it exerts: N m or N
};

struct Revolute {
  std::size_t a = 0, b = 0;
  Vec anchor;  // world frame, at the start
  std::optional<Limits> limits = std::nullopt;
  std::optional<Motor> motor = std::nullopt;
};

struct Distance {
  std::size_t a = 0, b = 0;
  Vec anchor_a, anchor_b;  // world frame, at the start
  double length = 0;
  double stiffness = 0;  // N/m; 0 means rigid
  double damping = 0;    // N s/m
};

struct Prismatic {
  std::size_t a = 0, b = 0;
  Vec anchor;  // world frame, at the start
  Vec axis{1, 0};
  std::optional<Limits> limits = std::nullopt;
  std::optional<Motor> motor = std::nullopt;
};

struct Weld {
  std::size_t a = 0, b = 0;
  Vec anchor;  // world frame, at the start
};

/// Two bodies connected by a joint do not collide with each other.
/// To add a kind of joint: a struct, an entry here, its functions in joints.cpp and its entry in scene.schema.json.
using Joint = std::variant<Revolute, Distance, Prismatic, Weld>;

/// Every other dynamic body is accelerated towards `from` by strength / r^exponent.
struct Attraction {
  std::size_t from = 0;
  double strength = 0;  // m^(1+exponent)/s^2
  double exponent = 2;
  bool mutual = false;  // whether the opposite force acts on `from`
};

/// Force along the line between two anchors: stiffness (distance - length) + damping d(distance)/dt.
struct Spring {
  std::optional<std::size_t> a;  // nullopt: anchor_a is a point of the world
  std::size_t b = 0;
  Vec anchor_a, anchor_b;  // each in its body's frame; anchor_a in the world frame if there is no body a
  double stiffness = 0;    // N/m
  double length = 0;       // m
  double damping = 0;      // N s/m
};

struct Constant {
  std::size_t body = 0;
  Vec force;  // N at the centre of mass, world frame
  double torque = 0;
};

/// A new kind of force likewise: its functions are in forces.cpp.
using Force = std::variant<Attraction, Spring, Constant>;

struct Scene {
  std::string name;
  std::string about;
  Vec gravity{0, -standard_gravity};
  double duration = 1;  // s
  Mixing mixing;
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Force> forces;
};

/// m, how far its path has taken a body after t seconds; its velocity's straight way is not included.
Vec path_offset(const Path&, double t);

/// m/s, of a body at the start, its path included.
Vec start_velocity(const Body&);

/// Whether the body is kinematic and ever moves.
bool is_carried(const Body&);

/// Whether any body has a path.
bool has_paths(const Scene&);

}  // namespace plumb
