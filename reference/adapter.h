#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/joints.h"
#include "scenarios/scene/scene.h"
#include "scenarios/scene/shapes.h"

/// What adapters of physics engines share: refusals, features of a scene that an engine lacks, options, and bodies on
/// paths. Nothing here depends on the types of an engine.
namespace plumb {

/// Whether an adapter supports a kind of shape or joint: the usual ones, which all do, and those that it gives in
/// `Also`. An adapter need not know any other.
template <class Kind, class... Kinds>
constexpr bool one_of = (std::is_same_v<Kind, Kinds> || ...);
template <class Kind, class... Also>
constexpr bool supports =
    one_of<Kind, Circle, Box, Polygon, Capsule, Segment, HalfSpace, Revolute, Distance, Prismatic, Weld, Also...>;

/// Passes a shape or joint of a supported kind to `make`. kind_refusal keeps others away.
template <class... Also, class Make, class... Kinds>
decltype(auto) visit_supported(Make&& make, const std::variant<Kinds...>& any) {
  using Made = decltype(make(std::get<0>(any)));
  return std::visit(
      [&]<class Kind>(const Kind& kind) -> Made {
        if constexpr (supports<Kind, Also...>) {
          return make(kind);
        } else {
          throw std::logic_error("a kind that the adapter does not support");
        }
      },
      any);
}

/// Names the first shape or joint of a kind that is not supported; "" if there is none.
template <class... Also>
std::string kind_refusal(const Scene& scene) {
  const auto refused = [](const auto& any) {
    const bool known = std::visit([]<class Kind>(const Kind&) { return supports<Kind, Also...>; }, any);
    return known ? std::string() : std::string("does not support the kind \"") + kind_name(any) + "\"";
  };
  std::string reason;
  for (const Body& body : scene.bodies) {
    for (const Shape& shape : body.shapes) reason = reason.empty() ? refused(shape.geometry) : reason;
  }
  for (const Joint& joint : scene.joints) reason = reason.empty() ? refused(joint) : reason;
  return reason;
}

/// Why an engine cannot run the scene if it has one coefficient of friction per surface, half-spaces on fixed bodies
/// only (see HalfSpaceEdge) and no massless dynamic bodies; "" if it can.
std::string feature_refusal(const Scene&);
/// Parts of it.
std::string moving_half_space_refusal(const Scene&);
std::string massless_refusal(const Scene&);

/// The same of an engine that has no kinds of shapes and joints but the usual ones and `Also`.
template <class... Also>
std::string common_refusal(const Scene& scene) {
  const std::string reason = kind_refusal<Also...>(scene);
  return reason.empty() ? feature_refusal(scene) : reason;
}

/// The first refusal among all geometries of the scene; "" if there is none. `refuse` maps each type of geometry to the
/// reason why the engine cannot run it, "" if it can.
template <class Refuse>
std::string geometry_refusal(const Scene& scene, const Refuse& refuse) {
  for (const Body& body : scene.bodies) {
    for (const Shape& shape : body.shapes) {
      std::string reason = std::visit(refuse, shape.geometry);
      if (!reason.empty()) return reason;
    }
  }
  return "";
}

/// Distance from the origin, m, within which everything stays that is only moved by gravity and its initial velocity;
/// at least 100. Engines without half-spaces get an edge of that length to either side.
double scene_extent(const Scene&);

/// A half-space as an edge, for engines that have none. The edge lies in a frame with the body's origin whose x axis is
/// parallel to the boundary, so that float errors are errors along the edge.
struct HalfSpaceEdge {
  double angle = 0;  // rad, of that frame
  Segment segment;   // in that frame
};
HalfSpaceEdge edge_of(const Body&, const HalfSpace&, double extent);

struct Load {
  Vec force;          // N at the centre of mass, world frame
  double torque = 0;  // N m about the centre of mass
};

/// What a scene's attractions, springs and constant forces exert on its bodies, for engines without such forces: their
/// adapters apply it before each step as an external force, constant over the step.
class Loads {
 public:
  explicit Loads(const Scene&);

  /// Whether anything but gravity acts.
  bool any() const { return !forces_.empty(); }

  /// The loads on all bodies in these states, in Scene order. Valid until the next call.
  std::span<const Load> at(std::span<const BodyState>);
  /// The same in the present states of a simulation, or where their velocities lead in that many seconds.
  std::span<const Load> at(const Simulation&, double ahead = 0);

 private:
  void add(const Attraction&, std::span<const BodyState>);
  void add(const Spring&, std::span<const BodyState>);
  void add(const Constant&, std::span<const BodyState>);

  struct LoadedBody {
    double mass = 0;  // kg; 0 for an immovable body
    Vec center;       // of mass, body frame
  };
  std::vector<Force> forces_;
  std::vector<LoadedBody> bodies_;
  std::vector<Load> loads_;
  std::vector<BodyState> states_;
};

/// The engine's constant for a type of body.
template <class Type>
Type body_type(BodyType type, Type fixed, Type kinematic, Type dynamic) {
  return type == BodyType::fixed ? fixed : type == BodyType::kinematic ? kinematic : dynamic;
}

/// The points in the engine's own type.
template <class Convert>
auto converted(const std::vector<Vec>& points, const Convert& convert) {
  std::vector<decltype(convert(Vec{}))> all;
  all.reserve(points.size());
  for (const Vec& point : points) all.push_back(convert(point));
  return all;
}

/// The value of an option for a whole number. The settings must be complete.
int whole_number(const Settings&, const std::string& key);

/// Options that several engines have under the same name.
Option restitution_threshold_option();
Option continuous_option();
Option sleep_option();
Option warm_start_option();

/// The simulation, with the bodies of the scene that have a path driven along it: before each step they are given the
/// velocity (x(t + dt) - x(t))/dt, so that they are where they should be after it. Within a step they move straight, at
/// most a dt^2/8 beside their path and a dt/2 beside its velocity, a = amplitude (2 pi frequency)^2. Without paths it
/// is the simulation itself. `build` of every engine ends with this.
std::unique_ptr<Simulation> on_paths(const Scene&, std::unique_ptr<Simulation>);

}  // namespace plumb
