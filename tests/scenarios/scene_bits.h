#pragma once

#include <bit>
#include <cstdint>
#include <sstream>
#include <string>
#include <type_traits>
#include <variant>

#include "scenarios/scene/scene_json.h"

/// All of a scene, its numbers by their bits: two scenes with the same words are the same, -0 and 0 told apart.
namespace plumb {

class SceneBits {
 public:
  static std::string of(const SceneFile& file) {
    SceneBits bits;
    bits.all(file.scene);
    for (const StatedTruth& truth : file.truth) {
      bits.add(truth.body, name_of(truth.quantity), truth.time.has_value(), truth.time.value_or(0), truth.value,
               truth.tolerance, truth.source);
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

  void all(const Scene& scene) {
    add(scene.name, scene.about, scene.gravity, scene.duration, scene.mixing.friction, scene.mixing.restitution);
    for (const Body& body : scene.bodies) {
      add(body.name, body.type, body.position, body.angle, body.velocity, body.angular_velocity, body.gravity_scale,
          body.fixed_rotation, body.bullet, body.layers, body.linear_damping, body.angular_damping);
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
  void operator()(const Revolute& j) { add("revolute", j.a, j.b, j.anchor); }
  void operator()(const Distance& j) {
    add("distance", j.a, j.b, j.anchor_a, j.anchor_b, j.length, j.stiffness, j.damping);
  }
  void operator()(const Prismatic& j) { add("prismatic", j.a, j.b, j.anchor, j.axis); }
  void operator()(const Weld& j) { add("weld", j.a, j.b, j.anchor); }
  void operator()(const Attraction& f) { add("attraction", f.from, f.strength, f.exponent, f.mutual); }
  void operator()(const Spring& f) {
    add("spring", f.a.has_value(), f.a.value_or(0), f.b, f.anchor_a, f.anchor_b, f.stiffness, f.length, f.damping);
  }
  void operator()(const Constant& f) { add("constant", f.body, f.force, f.torque); }
};

}  // namespace plumb
