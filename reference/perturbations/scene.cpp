// Errors in what a scene says: our engine runs a scene that is slightly off the given one.

#include <optional>
#include <utility>
#include <variant>

#include "reference/faults/altered_engine.h"
#include "reference/scene_facts.h"
#include "scenarios/scene/vec.h"

namespace plumb::scene_perturbations {
namespace {

/// Puts a relative error into a scene; returns whether there was anything to put it into.
using Change = bool (*)(Scene&, double error);

Perturbation of_scene(std::string name, std::string about, Change change, std::string unit = "") {
  return {.name = std::move(name),
          .about = std::move(about),
          .unit = std::move(unit),
          .applies = [change](Scene scene) { return change(scene, 0); },
          .build =
              [change](Scene scene, const Settings& settings, double error) {
                change(scene, error);
                return build_ours(scene, settings);
              }};
}

// Multiplies by 1 + error; returns whether that is a change.
bool scale(double& value, double error) {
  value *= 1 + error;
  return value != 0;
}

template <class Of>
bool each_dynamic(Scene& scene, Of of) {
  bool any = false;
  for (Body& body : scene.bodies) {
    if (body.type == BodyType::dynamic && of(body)) any = true;
  }
  return any;
}

// Of the surfaces of all bodies, so that a mixed coefficient has at least the same error.
bool each_surface(Scene& scene, double Surface::*value, double error) {
  bool any = false;
  for (Body& body : scene.bodies) {
    for (Shape& shape : body.shapes) any = scale(shape.surface.*value, error) || any;
  }
  return any;
}

const Catalog<Perturbation>::Entry gravity{
    of_scene("gravity", "the acceleration of gravity", [](Scene& scene, double error) {
      scene.gravity = (1 + error) * scene.gravity;
      return scene.gravity != Vec{};
    })};

const Catalog<Perturbation>::Entry mass{
    of_scene("mass", "the density of every body, and with it mass and inertia", [](Scene& scene, double error) {
      return each_dynamic(scene, [error](Body& body) {
        for (Shape& shape : body.shapes) shape.surface.density *= 1 + error;
        return true;
      });
    })};

const Catalog<Perturbation>::Entry restitution{
    of_scene("restitution", "the restitution of every surface",
             [](Scene& scene, double error) { return each_surface(scene, &Surface::restitution, error); })};

const Catalog<Perturbation>::Entry static_friction{
    of_scene("static friction", "the coefficient of friction while sticking, of every surface",
             [](Scene& scene, double error) { return each_surface(scene, &Surface::static_friction, error); })};

const Catalog<Perturbation>::Entry dynamic_friction{
    of_scene("dynamic friction", "the coefficient of friction while sliding, of every surface",
             [](Scene& scene, double error) { return each_surface(scene, &Surface::dynamic_friction, error); })};

const Catalog<Perturbation>::Entry linear_damping{
    of_scene("linear damping", "the damping of velocities, where there is any", [](Scene& scene, double error) {
      return each_dynamic(scene, [error](Body& body) { return scale(body.linear_damping, error); });
    })};

const Catalog<Perturbation>::Entry angular_damping{of_scene(
    "angular damping", "the damping of angular velocities, where there is any", [](Scene& scene, double error) {
      return each_dynamic(scene, [error](Body& body) { return scale(body.angular_damping, error); });
    })};

// A damping below zero makes no sense, so that a negative error is none.
const Catalog<Perturbation>::Entry no_linear_damping{of_scene(
    "no linear damping", "damping of velocities where there is none",
    [](Scene& scene, double error) {
      return each_dynamic(scene, [error](Body& body) {
        if (body.linear_damping > 0) return false;
        body.linear_damping = error > 0 ? error : 0;
        return true;
      });
    },
    "1/s")};

const Catalog<Perturbation>::Entry no_angular_damping{of_scene(
    "no angular damping", "damping of angular velocities where there is none",
    [](Scene& scene, double error) {
      return each_dynamic(scene, [error](Body& body) {
        if (body.angular_damping > 0 || body.fixed_rotation) return false;
        body.angular_damping = error > 0 ? error : 0;
        return true;
      });
    },
    "1/s")};

// The body that the anchor's error is relative to.
const Body& held_body(const Scene& scene, std::size_t a, std::size_t b) {
  return scene.bodies[scene.bodies[b].type == BodyType::dynamic ? b : a];
}

const Catalog<Perturbation>::Entry anchors{
    of_scene("joint anchors", "the distance of a hinge from the centre of mass of the body that it holds",
             [](Scene& scene, double error) {
               bool any = false;
               for (Joint& joint : scene.joints) {
                 auto* hinge = std::get_if<Revolute>(&joint);
                 if (hinge == nullptr) continue;
                 const Vec arm = hinge->anchor - start_of(held_body(scene, hinge->a, hinge->b)).position;
                 hinge->anchor = hinge->anchor + error * arm;
                 any = any || arm != Vec{};
               }
               return any;
             })};

// Rails and welds hold their bodies as they start, wherever their anchors are: those are no parameters of a motion.
const Catalog<Perturbation>::Entry rail_axis{of_scene(
    "rail axis", "the direction of rails",
    [](Scene& scene, double error) {
      bool any = false;
      for (Joint& joint : scene.joints) {
        auto* slider = std::get_if<Prismatic>(&joint);
        if (slider == nullptr) continue;
        slider->axis = rotated(slider->axis, error);
        any = true;
      }
      return any;
    },
    "rad")};

Distance* rod_in(Joint& joint) {
  auto* rod = std::get_if<Distance>(&joint);
  return rod != nullptr && rod->stiffness == 0 ? rod : nullptr;
}

const Catalog<Perturbation>::Entry rod_anchors{of_scene(
    "rod anchors", "the distances of a rod's ends from the centres of mass of the bodies that it holds",
    [](Scene& scene, double error) {
      bool any = false;
      for (Joint& joint : scene.joints) {
        Distance* rod = rod_in(joint);
        if (rod == nullptr) continue;
        const double before = length(rod->anchor_b - rod->anchor_a);
        for (const auto& [body, anchor] : {std::pair{rod->a, &rod->anchor_a}, std::pair{rod->b, &rod->anchor_b}}) {
          if (scene.bodies[body].type != BodyType::dynamic) continue;
          const Vec arm = *anchor - start_of(scene.bodies[body]).position;
          *anchor = *anchor + error * arm;
          any = any || arm != Vec{};
        }
        rod->length += length(rod->anchor_b - rod->anchor_a) - before;
      }
      return any;
    })};

const Catalog<Perturbation>::Entry rod_length{
    of_scene("rod length", "the length of rods", [](Scene& scene, double error) {
      bool any = false;
      for (Joint& joint : scene.joints) {
        if (Distance* rod = rod_in(joint)) any = scale(rod->length, error) || any;
      }
      return any;
    })};

const Catalog<Perturbation>::Entry limits{
    of_scene("joint limits", "the angles and ways at which hinges and sliders stop, from their start",
             [](Scene& scene, double error) {
               bool any = false;
               const auto change = [&](std::optional<Limits>& of) {
                 if (!of) return;
                 const bool low = scale(of->low, error);
                 const bool high = scale(of->high, error);
                 any = any || low || high;
               };
               for (Joint& joint : scene.joints) {
                 if (auto* hinge = std::get_if<Revolute>(&joint)) change(hinge->limits);
                 if (auto* slider = std::get_if<Prismatic>(&joint)) change(slider->limits);
               }
               return any;
             })};

// Of the motors of hinges and sliders.
bool each_motor(Scene& scene, double Motor::*value, double error) {
  bool any = false;
  const auto change = [&](std::optional<Motor>& motor) { any = (motor && scale((*motor).*value, error)) || any; };
  for (Joint& joint : scene.joints) {
    if (auto* hinge = std::get_if<Revolute>(&joint)) change(hinge->motor);
    if (auto* slider = std::get_if<Prismatic>(&joint)) change(slider->motor);
  }
  return any;
}

const Catalog<Perturbation>::Entry motor_strength{
    of_scene("motor strength", "the largest torques and forces of motors",
             [](Scene& scene, double error) { return each_motor(scene, &Motor::strength, error); })};

const Catalog<Perturbation>::Entry motor_speed{
    of_scene("motor speed", "the speeds of motors",
             [](Scene& scene, double error) { return each_motor(scene, &Motor::speed, error); })};

const Catalog<Perturbation>::Entry path_frequency{
    of_scene("path frequency", "the frequency of kinematic bodies on paths", [](Scene& scene, double error) {
      bool any = false;
      for (Body& body : scene.bodies) any = (body.path && scale(body.path->frequency, error)) || any;
      return any;
    })};

const Catalog<Perturbation>::Entry path_amplitude{
    of_scene("path amplitude", "how far kinematic bodies are taken by their paths", [](Scene& scene, double error) {
      bool any = false;
      for (Body& body : scene.bodies) {
        if (!body.path) continue;
        body.path->amplitude = (1 + error) * body.path->amplitude;
        any = any || body.path->amplitude != Vec{};
      }
      return any;
    })};

// Of springs between bodies, as forces and as joints.
bool each_spring(Scene& scene, double Spring::*of_force, double Distance::*of_joint, double error) {
  bool any = false;
  for (Force& force : scene.forces) {
    if (auto* spring = std::get_if<Spring>(&force)) any = scale(spring->*of_force, error) || any;
  }
  for (Joint& joint : scene.joints) {
    if (auto* spring = std::get_if<Distance>(&joint)) any = scale(spring->*of_joint, error) || any;
  }
  return any;
}

const Catalog<Perturbation>::Entry stiffness{of_scene(
    "spring stiffness", "the stiffness of springs and of soft joints",
    [](Scene& scene, double error) { return each_spring(scene, &Spring::stiffness, &Distance::stiffness, error); })};

const Catalog<Perturbation>::Entry damping{of_scene(
    "spring damping", "the damping of springs and of soft joints",
    [](Scene& scene, double error) { return each_spring(scene, &Spring::damping, &Distance::damping, error); })};

}  // namespace
}  // namespace plumb::scene_perturbations
