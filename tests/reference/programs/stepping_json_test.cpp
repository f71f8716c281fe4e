#include "reference/programs/protocol.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "scenarios/scene/json_reader.h"

namespace plumb::protocol {
namespace {

constexpr double dt = 1.0 / 60;

Stepping read_back(const nlohmann::json& json) { return stepping_of(JsonReader(json, "its answer"), dt); }

std::string refusal_of(const nlohmann::json& json) {
  try {
    read_back(json);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SteppingJson, HasTheFieldsOfTheSchema) {
  std::ifstream file(std::string(PLUMB_SOURCE_DIR) + "/reference/programs/engine.schema.json");
  const nlohmann::json schema = nlohmann::json::parse(file);
  std::set<std::string> stated;
  for (const auto& field : schema["$defs"]["stepping"]["properties"]["stepping"]["properties"].items()) {
    stated.insert(field.key());
  }
  std::set<std::string> written;
  const nlohmann::ordered_json json = stepping_as_json({.spring_limit = 2});
  for (const auto& field : json.items()) written.insert(field.key());
  EXPECT_EQ(written, stated);
}

// Of each kind of number, and of what has a range of its own.
TEST(SteppingJson, ComesBackAsItWasStated) {
  const Stepping stated{.dt = dt,
                        .h = dt / 4,
                        .drift = -0.5,
                        .damping_interval = dt,
                        .impact_lag = 8,
                        .slop = 0.005,
                        .angular_slop = 0.035,
                        .held_anchors = true,
                        .position_iterations = 3,
                        .epsilon = 0x1p-24,
                        .whole_impulses = false,
                        .spring_limit = 2};
  const nlohmann::ordered_json written = stepping_as_json(stated);
  const Stepping back = read_back(nlohmann::json::parse(written.dump()));
  EXPECT_EQ(back.dt, dt);
  EXPECT_EQ(back.angular_slop, 0.035);
  EXPECT_EQ(back.position_iterations, 3);
  EXPECT_EQ(stepping_as_json(back), written);
}

TEST(SteppingJson, TakesWhatIsLeftOutForOneStepWithoutErrors) {
  const Stepping least = read_back({{"arithmetic", "double"}});
  EXPECT_EQ(least.h, dt);
  EXPECT_EQ(least.impact_lag, 1);
  EXPECT_EQ(least.epsilon, 0x1p-53);
  EXPECT_FALSE(least.whole_impulses);
  EXPECT_FALSE(least.spring_limit.has_value());
}

TEST(SteppingJson, NamesWhatIsUnknownOrOutOfRange) {
  const nlohmann::json least{{"arithmetic", "double"}};
  const auto with = [&](const char* key, const nlohmann::json& value) {
    nlohmann::json json = least;
    json[key] = value;
    return refusal_of(json);
  };
  EXPECT_EQ(with("slop", 0), "");
  EXPECT_THAT(with("slop", -1), testing::HasSubstr("slop"));
  EXPECT_THAT(with("drift", 2), testing::HasSubstr("drift"));
  EXPECT_THAT(with("substep", 2 * dt), testing::HasSubstr("substep"));
  EXPECT_THAT(with("dampingInterval", 2 * dt), testing::HasSubstr("dampingInterval"));
  EXPECT_THAT(with("heldAnchors", 1), testing::HasSubstr("heldAnchors"));
  EXPECT_THAT(with("skins", 1), testing::HasSubstr("skins"));
  EXPECT_THAT(refusal_of({{"slop", 0}}), testing::HasSubstr("arithmetic"));
}

}  // namespace
}  // namespace plumb::protocol
