#include "reports/writers/run_curves.h"

#include <gmock/gmock.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sample.h"

namespace plumb::run_curves_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(Series, IsThinnedButKeepsBothEnds) {
  const Report report = sample_report();
  const Json series = series_of(run_curves(report), 300)[1];
  EXPECT_EQ(series["t"].size(), 300u);
  EXPECT_EQ(series["t"].front(), 0);
  EXPECT_EQ(series["t"].back(), 16.6667) << "six digits";
  for (const char* column :
       {"energy", "momentum_x", "momentum_y", "angular_momentum", "fastest", "pose_difference", "overlap"}) {
    EXPECT_EQ(series[column].size(), 300u) << column;
  }
  EXPECT_EQ(series["energy"][7], 1);
  EXPECT_EQ(series["momentum_x"][7], 2);
  EXPECT_EQ(series["fastest"][7], 1);
  EXPECT_EQ(series["pose_difference"][7], 0) << "from the closed form";
}

TEST(Series, HasNoDifferenceBeyondTheEndOfTheTruth) {
  Report report = sample_report();
  const auto brief = std::make_shared<Trace>(1);
  const BodyState state;
  brief->record(0, std::span(&state, 1), {});
  report.runs[0].trace = brief;
  const Json series = series_of(run_curves(report), 10)[1];
  EXPECT_EQ(series["pose_difference"][0], 0);
  EXPECT_TRUE(series["pose_difference"][1].is_null());
}

}  // namespace
}  // namespace plumb::run_curves_test
