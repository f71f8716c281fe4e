#include "core/method_list.h"

#include <gtest/gtest.h>

namespace {

using namespace impulse;

struct Way {};

const MethodList<Way>::Entry fine{{"fine", "", ""}, [] { return std::make_unique<Way>(); }};
const MethodList<Way>::Entry spoilt{{"spoilt", "", ""}, [] { return std::make_unique<Way>(); }, Offer::unlisted};

TEST(MethodList, OffersWhatIsListed) {
  ASSERT_EQ(MethodList<Way>::infos().size(), 1U);
  EXPECT_EQ(MethodList<Way>::infos().front().name, "fine");
}

TEST(MethodList, MakesByNameWhatIsNotOffered) {
  EXPECT_TRUE(MethodList<Way>::knows("spoilt"));
  EXPECT_NE(MethodList<Way>::make("spoilt"), nullptr);
  EXPECT_FALSE(MethodList<Way>::knows("other"));
  EXPECT_EQ(MethodList<Way>::make("other"), nullptr);
}

}  // namespace
