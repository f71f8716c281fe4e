#include "reports/find/shrink.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/joints.h"

namespace plumb::cuts::ties {
namespace {

template <class Item>
void add_without_each(const Scene& scene, std::vector<Item> Scene::*list, std::vector<Scene>& into) {
  for (std::size_t i = (scene.*list).size(); i-- > 0;) {
    Scene simpler = scene;
    (simpler.*list).erase((simpler.*list).begin() + static_cast<std::ptrdiff_t>(i));
    into.push_back(std::move(simpler));
  }
}

// Without any joint or force, without one, without a limit, a motor or a damper.
std::vector<Scene> fewer_ties(const Scene& scene, const Failure&) {
  std::vector<Scene> all;
  if (scene.joints.size() > 1 || scene.forces.size() > 1) {
    Scene none = scene;
    none.joints.clear();
    none.forces.clear();
    all.push_back(std::move(none));
  }
  add_without_each(scene, &Scene::joints, all);
  add_without_each(scene, &Scene::forces, all);
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    if (motor_of(scene.joints[i]) == nullptr) continue;
    all.push_back(scene);
    std::visit(
        [](auto& joint) {
          if constexpr (requires { joint.motor; }) joint.motor.reset();
        },
        all.back().joints[i]);
  }
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    if (limits_of(scene.joints[i]) == nullptr) continue;
    all.push_back(scene);
    std::visit(
        [](auto& joint) {
          if constexpr (requires { joint.limits; }) joint.limits.reset();
        },
        all.back().joints[i]);
  }
  for (std::size_t i = 0; i < scene.forces.size(); ++i) {
    const auto* spring = std::get_if<Spring>(&scene.forces[i]);
    if (spring == nullptr || spring->damping == 0) continue;
    all.push_back(scene);
    std::get<Spring>(all.back().forces[i]).damping = 0;
  }
  return all;
}

const Catalog<Cut>::Entry entry{{.name = "drop joints and forces", .order = 2, .simpler = fewer_ties}};

}  // namespace
}  // namespace plumb::cuts::ties
