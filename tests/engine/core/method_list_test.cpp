#include "core/method_list.h"

#include <gtest/gtest.h>

namespace method_list_test {
namespace {

using namespace impulse;

struct Method {};

const MethodList<Method>::Entry second{{"second", "", ""}, [] { return std::make_unique<Method>(); }};
const MethodList<Method>::Entry first{{"first", "", ""}, [] { return std::make_unique<Method>(); }};

TEST(MethodList, ListsItsEntriesByName) {
  ASSERT_EQ(MethodList<Method>::infos().size(), 2U);
  EXPECT_EQ(MethodList<Method>::infos().front().name, "first");
}

TEST(MethodList, MakesTheMethodOfAName) {
  EXPECT_TRUE(MethodList<Method>::knows("first"));
  EXPECT_NE(MethodList<Method>::make("first"), nullptr);
  EXPECT_FALSE(MethodList<Method>::knows("other"));
  EXPECT_EQ(MethodList<Method>::make("other"), nullptr);
}

TEST(MethodList, AsksItsExtensionForNamesThatAreNotListed) {
  struct Extended {};
  using List = MethodList<Extended>;
  List::extend([](std::string_view name) { return name == "mine" ? std::make_unique<Extended>() : nullptr; });
  EXPECT_TRUE(List::knows("mine"));
  EXPECT_NE(List::make("mine"), nullptr);
  EXPECT_FALSE(List::knows("other"));
  EXPECT_TRUE(List::infos().empty());
}

}  // namespace
}  // namespace method_list_test
