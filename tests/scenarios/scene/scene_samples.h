#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <variant>

#include "scenarios/scene/scene_json.h"

namespace plumb {

/// Random scenes with every kind of body, shape, joint and force; physically meaningless. The same seed gives the same
/// scene with any standard library.
class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed) : draw_(seed) {}

  SceneFile make() {
    SceneFile file;
    Scene& scene = file.scene;
    scene.name = "random \"\\/ \u00fc\u4e16\U0001F3B1";
    scene.gravity = point();
    scene.duration = 1 + between(0, 100);
    scene.mixing = {static_cast<FrictionMixing>(below(6)), static_cast<RestitutionMixing>(below(4))};
    // The first body is always dynamic because every joint needs a dynamic body.
    for (std::size_t i = 0; i < 3 + below(5); ++i) scene.bodies.push_back(body(i));
    for (std::size_t i = below(4); i > 0; --i) scene.joints.push_back(joint(other(scene)));
    for (std::size_t i = below(4); i > 0; --i) scene.forces.push_back(force(other(scene)));
    for (std::size_t i = below(3); i > 0; --i) {
      file.truth.push_back({scene.bodies[below(scene.bodies.size())].name, Quantity::angular_velocity,
                            scene.duration * between(0, 1), number(), std::abs(number()), "", "drawn"});
    }
    if (below(2) == 0) file.truth.push_back({"", Quantity::energy, std::nullopt, number(), 0, "", "drawn"});
    return file;
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(draw_() % n); }
  double between(double low, double high) { return low + (high - low) * static_cast<double>(draw_() >> 11) * 0x1p-53; }
  double sometimes(double otherwise, double value) { return below(2) == 0 ? otherwise : value; }

  // Numbers of every magnitude, and those that a file format loses most easily.
  double number() {
    switch (below(8)) {
      case 0:
        return -0.0;
      case 1:
        return std::numeric_limits<double>::denorm_min() * static_cast<double>(1 + below(1000));
      case 2:
        return -std::numeric_limits<double>::min();
      case 3:
        return static_cast<double>(below(7)) - 3;
      default:
        return std::ldexp(between(-1, 1), static_cast<int>(below(30)) - 15);
    }
  }
  double positive() { return std::ldexp(between(0.5, 1), static_cast<int>(below(20)) - 10); }
  Vec point() { return {number(), number()}; }

  Geometry geometry() {
    switch (below(6)) {
      case 0:
        return Circle{positive(), point()};
      case 1:
        return Box{{positive(), positive()}, point(), number()};
      case 2: {
        Polygon polygon;
        const auto n = 3 + below(6);
        const double sense = below(2) == 0 ? 1 : -1;
        for (std::size_t i = 0; i < n; ++i) {
          const double a = sense * 6.28 * static_cast<double>(i) / static_cast<double>(n);
          polygon.vertices.push_back({std::cos(a), std::sin(a)});
        }
        return polygon;
      }
      case 3:
        return Capsule{{1, number()}, {-1, number()}, positive()};
      case 4:
        return Segment{{1, number()}, {-1, number()}};
      default:
        return HalfSpace{{0.6, -0.8}, number()};
    }
  }

  Shape shape(Geometry of) {
    const double sliding = positive();
    return {std::move(of), {positive(), sometimes(sliding, sliding + 1), sliding, between(0, 1)}};
  }

  Body body(std::size_t index) {
    Body body{.name = "body " + std::to_string(index),
              .type = index == 0 ? BodyType::dynamic : static_cast<BodyType>(below(3)),
              .position = point(),
              .angle = number()};
    if (body.type != BodyType::fixed) {
      body.velocity = point();
      body.angular_velocity = number();
    }
    body.gravity_scale = sometimes(1, number());
    body.fixed_rotation = below(2) == 0;
    body.bullet = below(2) == 0;
    if (below(2) == 0) body.layers = static_cast<std::uint32_t>(draw_());
    body.linear_damping = sometimes(0, std::abs(number()));
    body.angular_damping = sometimes(0, std::abs(number()));
    if (body.type == BodyType::kinematic && below(2) == 0) body.path = path();
    body.shapes.push_back(shape(Circle{positive(), {}}));
    for (std::size_t i = below(3); i > 0; --i) body.shapes.push_back(shape(geometry()));
    return body;
  }

  std::size_t other(const Scene& scene) { return 1 + below(scene.bodies.size() - 1); }

  Path path() {
    const Vec amplitude{between(-9, 9), between(-9, 9)};
    return {amplitude, between(0, 9), sometimes(0, number())};
  }

  std::optional<Limits> limits() {
    if (below(2) == 0) return std::nullopt;
    const double low = -positive();
    return Limits{low, low + positive()};
  }

  std::optional<Motor> motor() {
    if (below(2) == 0) return std::nullopt;
    const double speed = number();
    return Motor{speed, positive()};
  }

  Joint joint(std::size_t with) {
    switch (below(4)) {
      case 0:
        return Revolute{0, with, point(), limits(), motor()};
      case 1:
        return Distance{with, 0, point(), point(), positive(), sometimes(0, positive()), sometimes(0, positive())};
      case 2:
        return Prismatic{0, with, point(), {positive(), number()}, limits(), motor()};
      default:
        return Weld{with, 0, point()};
    }
  }

  Force force(std::size_t with) {
    switch (below(4)) {
      case 0:
        return Attraction{with, number(), between(-3, 3), below(2) == 0};
      case 1:
        return Spring{with, 0, point(), point(), positive(), positive(), sometimes(0, positive())};
      case 2:
        return Spring{std::nullopt, 0, point(), below(2) == 0 ? Vec{} : point(), positive(), positive()};
      default:
        return Constant{0, point(), number()};
    }
  }

  std::mt19937_64 draw_;
};

/// Every field of a scene as text, numbers by their bits: two scenes are identical if their texts are. Tells -0 from 0.
class SceneBits {
 public:
  static std::string of(const SceneFile& file) {
    SceneBits bits;
    bits.all(file.scene);
    for (const StatedTruth& truth : file.truth) {
      bits.add(truth.body, name_of(truth.quantity), truth.time.has_value(), truth.time.value_or(0), truth.value,
               truth.tolerance, truth.tolerance_of, truth.source, name_of(truth.relation), truth.over,
               std::to_string(truth.index), truth.with);
    }
    return bits.out_.str();
  }

 private:
  template <class... Parts>
  void add(const Parts&... parts) {
    (one(parts), ...);
    out_ << '\n';
  }
  void one(double number) { out_ << std::hex << std::bit_cast<std::uint64_t>(number) << ' '; }
  void one(Vec v) {
    one(v.x);
    one(v.y);
  }
  void one(const std::string& text) { out_ << '"' << text << "\" "; }
  void one(const char* text) { out_ << text << ' '; }
  template <class Whole>
  requires std::is_integral_v<Whole> || std::is_enum_v<Whole>
  void one(Whole number) { out_ << std::dec << static_cast<std::int64_t>(number) << ' '; }

  void add_motor(const std::optional<Motor>& motor) {
    const Motor given = motor.value_or(Motor{});
    add(motor.has_value(), given.speed, given.strength);
  }

  void add_limits(const std::optional<Limits>& limits) {
    const Limits given = limits.value_or(Limits{});
    add(limits.has_value(), given.low, given.high);
  }

  void all(const Scene& scene) {
    add(scene.name, scene.about, scene.gravity, scene.duration, scene.mixing.friction, scene.mixing.restitution);
    for (const Body& body : scene.bodies) {
      add(body.name, body.type, body.position, body.angle, body.velocity, body.angular_velocity, body.gravity_scale,
          body.fixed_rotation, body.bullet, body.layers, body.linear_damping, body.angular_damping);
      const Path path = body.path.value_or(Path{});
      add(body.path.has_value(), path.amplitude, path.frequency, path.phase);
      for (const Shape& shape : body.shapes) {
        const Surface& surface = shape.surface;
        std::visit(*this, shape.geometry);
        add(surface.density, surface.static_friction, surface.dynamic_friction, surface.restitution);
      }
    }
    for (const Joint& joint : scene.joints) std::visit(*this, joint);
    for (const Force& force : scene.forces) std::visit(*this, force);
  }

  SceneBits() = default;
  std::ostringstream out_;

 public:
  // Called by std::visit.
  void operator()(const Circle& c) { add("circle", c.radius, c.center); }
  void operator()(const Box& b) { add("box", b.size, b.center, b.angle); }
  void operator()(const Capsule& c) { add("capsule", c.from, c.to, c.radius); }
  void operator()(const Segment& s) { add("segment", s.from, s.to); }
  void operator()(const HalfSpace& h) { add("halfspace", h.normal, h.offset); }
  void operator()(const Polygon& p) {
    out_ << "polygon ";
    for (const Vec& vertex : p.vertices) add(vertex);
  }
  void operator()(const Revolute& j) {
    add("revolute", j.a, j.b, j.anchor);
    add_limits(j.limits);
    add_motor(j.motor);
  }
  void operator()(const Distance& j) {
    add("distance", j.a, j.b, j.anchor_a, j.anchor_b, j.length, j.stiffness, j.damping);
  }
  void operator()(const Prismatic& j) {
    add("prismatic", j.a, j.b, j.anchor, j.axis);
    add_limits(j.limits);
    add_motor(j.motor);
  }
  void operator()(const Weld& j) { add("weld", j.a, j.b, j.anchor); }
  void operator()(const Attraction& f) { add("attraction", f.from, f.strength, f.exponent, f.mutual); }
  void operator()(const Spring& f) {
    add("spring", f.a.has_value(), f.a.value_or(0), f.b, f.anchor_a, f.anchor_b, f.stiffness, f.length, f.damping);
  }
  void operator()(const Constant& f) { add("constant", f.body, f.force, f.torque); }
};

}  // namespace plumb
