#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "scenarios/scene/json_reader.h"
#include "scenarios/scene/scene.h"

/// What reading and writing the parts of a scene file (bodies, shapes, joints, forces) have in common. Private to this
/// folder.
namespace plumb {

/// What a scene file may contain. A run counts as lost beyond 1e7 m and 1e6 m/s, so a scene starts well inside that.
/// The other limits keep masses, inertias and forces within the range of single precision, so that every engine can run
/// it.
namespace limits {

constexpr NumberRange coordinate{-1e6, 1e6, "m"};
constexpr NumberRange size{1e-6, 1e6, "m"};
constexpr NumberRange length{0, 1e6, "m"};
constexpr NumberRange angle{-1e6, 1e6, "rad"};
constexpr NumberRange speed{-1e5, 1e5, "m/s"};
constexpr NumberRange spin{-1e5, 1e5, "rad/s"};
constexpr NumberRange acceleration{-1e6, 1e6, "m/s^2"};
constexpr NumberRange density{0, 1e9, "kg/m^2"};
constexpr NumberRange friction{0, 1e6, ""};
constexpr NumberRange restitution{0, 1, ""};
constexpr NumberRange amplitude{-1000, 1000, "m"};
constexpr NumberRange frequency{0, 1000, "Hz"};
constexpr NumberRange damping{0, 1e6, "1/s"};
constexpr NumberRange factor{-1e6, 1e6, ""};
constexpr NumberRange stiffness{0, 1e12, "N/m"};
constexpr NumberRange resistance{0, 1e12, "N s/m"};
constexpr NumberRange force{-1e12, 1e12, "N"};
constexpr NumberRange torque{-1e12, 1e12, "N m"};
constexpr NumberRange motor_force{0, 1e12, "N"};
constexpr NumberRange motor_torque{0, 1e12, "N m"};
constexpr NumberRange strength{-1e12, 1e12, ""};
constexpr NumberRange exponent{-10, 10, ""};
constexpr NumberRange duration{1e-6, 3600, "s"};
constexpr NumberRange layers{0, 4294967295.0, ""};
constexpr NumberRange reading{-1e30, 1e30, ""};
constexpr NumberRange tolerance{0, 1e30, ""};

// Beyond these, judging a run of a few seconds takes hours.
constexpr std::size_t shapes = 10'000;  // of a body
constexpr std::size_t bodies = 20'000;

constexpr std::size_t name = 200;  // bytes
constexpr std::size_t text = 2000;

}  // namespace limits

/// Looks up the bodies of a scene that is being read by their names.
class BodyNames {
 public:
  /// `scene` must outlive this.
  explicit BodyNames(const Scene& scene) : scene_(scene) {}

  /// Gives the next body its name. Refuses a name that is already taken.
  void add(const JsonReader& in, const std::string& name);
  /// The index of the body with the name that is read.
  std::size_t find(const JsonReader& in) const;
  /// The same; refuses a body that is not dynamic.
  std::size_t find_dynamic(const JsonReader& in) const;
  /// A list of two different bodies, at least one of them dynamic.
  std::pair<std::size_t, std::size_t> find_two(const JsonReader& in) const;

 private:
  bool is_dynamic(std::size_t body) const { return scene_.bodies[body].type == BodyType::dynamic; }

  const Scene& scene_;
  std::map<std::string, std::size_t> indices_;
};

/// Refuses an object that has any of these keys, which elsewhere mean something, as what the foreign word means.
void refuse_as_foreign(const JsonReader&, std::initializer_list<const char*> keys, const char* word);

/// A list of two points.
std::pair<Vec, Vec> read_anchors(const JsonReader&);

using OrderedJson = nlohmann::ordered_json;

inline OrderedJson as_json(Vec v) { return {v.x, v.y}; }

/// Whether two numbers are the same, with 0 and -0 different.
inline bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

/// Writes a member unless it has, to the bit, the value that a reader assumes when it is absent.
void write_unless(OrderedJson& into, const char* key, double value, double otherwise);
void write_unless(OrderedJson& into, const char* key, Vec value, Vec otherwise);

}  // namespace plumb
