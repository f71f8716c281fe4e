#include "scenarios/scene/materials.h"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Materials, AreFoundByNameOrNotAtAll) {
  ASSERT_NE(find_material("wood"), nullptr);
  EXPECT_EQ(find_material("wood")->density, 0.3);
  EXPECT_EQ(find_material("wood")->restitution, 0.2);
  EXPECT_EQ(find_material("static")->density, 0);
  EXPECT_EQ(find_material("Wood"), nullptr);
  EXPECT_EQ(find_material(""), nullptr);
}

}  // namespace
}  // namespace plumb
