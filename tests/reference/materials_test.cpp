#include "scenarios/scene/surface.h"

#include <gtest/gtest.h>

#include "impulse/material.h"

namespace plumb::materials_test {
namespace {

// A material name must mean the same in the engine and in scene files.
TEST(Materials, AreTheSameInEngineAndSceneFiles) {
  ASSERT_EQ(materials().size(), impulse::materials().size());
  const auto as = [](double number) { return static_cast<impulse::Real>(number); };
  for (const NamedSurface& material : materials()) {
    const impulse::Material* ours = impulse::find_material(material.name);
    ASSERT_NE(ours, nullptr) << material.name;
    EXPECT_EQ(ours->density, as(material.surface.density)) << material.name;
    EXPECT_EQ(ours->static_friction, as(material.surface.static_friction)) << material.name;
    EXPECT_EQ(ours->dynamic_friction, as(material.surface.dynamic_friction)) << material.name;
    EXPECT_EQ(ours->restitution, as(material.surface.restitution)) << material.name;
  }
}

}  // namespace
}  // namespace plumb::materials_test
