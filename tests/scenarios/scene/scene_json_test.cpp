#include "scenarios/scene/scene_json.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/surface.h"
#include "scene_samples.h"

namespace plumb::scene_json_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

std::string file(const char* name) {
  std::ostringstream text;
  text << std::ifstream(std::string(PLUMB_SOURCE_DIR "/tests/scenarios/scene_files/") + name).rdbuf();
  return text.str();
}

std::string refusal(const std::string& text) {
  try {
    read_scene(text, "scene.json");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ReadScene, ReadsEveryFeature) {
  const SceneFile read = read_scene(file("every_feature.json"), "every_feature.json");
  const Scene& scene = read.scene;
  EXPECT_EQ(scene.name, "every-feature");
  EXPECT_EQ(scene.gravity, (Vec{0, -10}));
  EXPECT_EQ(scene.mixing.friction, FrictionMixing::pythagorean);
  ASSERT_EQ(scene.bodies.size(), 5u);
  EXPECT_EQ(scene.bodies[0].shapes[1].surface.static_friction, 0.6);
  EXPECT_EQ(scene.bodies[0].shapes[1].surface.dynamic_friction, 0.4);
  EXPECT_EQ(std::get<Box>(scene.bodies[1].shapes[0].geometry).size, (Vec{1, 0.5}));
  EXPECT_EQ(scene.bodies[2].layers, 3u);
  EXPECT_EQ(std::get<Polygon>(scene.bodies[3].shapes[0].geometry).vertices[2], (Vec{0.5, 1}));
  EXPECT_EQ(scene.bodies[4].type, BodyType::kinematic);
  EXPECT_EQ(std::get<Distance>(scene.joints[1]).b, 2u);
  EXPECT_TRUE(std::get<Attraction>(scene.forces[0]).mutual);
  EXPECT_EQ(std::get<Spring>(scene.forces[1]).a, 1u);
  EXPECT_EQ(std::get<Spring>(scene.forces[2]).a, std::nullopt);
  EXPECT_EQ(std::get<Spring>(scene.forces[2]).anchor_b, (Vec{0, 0.5}));
  EXPECT_EQ(read.source, "https://example.org/reports/1");
  ASSERT_TRUE(read.origin.has_value());
  EXPECT_EQ(read.origin->engine, "box2d:velocity=2");
  EXPECT_EQ(read.origin->posed, Posed::ambiguous);
  ASSERT_EQ(read.truth.size(), 2u);
  EXPECT_EQ(read.truth[0].time, 0);
  EXPECT_EQ(read.truth[1].time, std::nullopt);
}

TEST(ReadScene, UsesDefaultsForAbsentMembers) {
  const Scene scene = read_scene(R"({"plumb": 1, "name": "least", "gravity": [0, -10], "duration": 1, "bodies": [
      {"name": "disc", "type": "dynamic", "position": [0, 0], "shapes": [{"type": "circle", "radius": 1}]},
      {"name": "ground", "type": "static", "shapes": [{"type": "halfspace"}]}]})",
                                 "least.json")
                          .scene;
  const Body ground{
      .name = "ground", .type = BodyType::fixed, .shapes = {{.geometry = HalfSpace{.normal = {0, 1}, .offset = 0}}}};
  Scene expected{.name = "least", .bodies = {disc("disc", {0, 0}, 1, {}), ground}};
  EXPECT_EQ(SceneBits::of({scene, {}}), SceneBits::of({expected, {}}));
}

TEST(ReadScene, PrefersExplicitValuesToTheMaterials) {
  const Surface surface = read_scene(file("every_feature.json"), "").scene.bodies[2].shapes[0].surface;
  EXPECT_EQ(surface.density, find_material("wood")->density);
  EXPECT_EQ(surface.restitution, find_material("wood")->restitution);
  EXPECT_EQ(surface.dynamic_friction, 0.2);
}

// Each row of refused.json changes every_feature.json in one place. The test of the schema uses the same table.
TEST(ReadScene, SaysThePathAndWhatWasExpectedAndFound) {
  for (const Json& row : Json::parse(file("refused.json"))) {
    Json scene = Json::parse(file("every_feature.json"));
    const Json::json_pointer at(row["at"].get<std::string>());
    if (row.contains("put")) {
      scene[at] = row["put"];
    } else {
      scene[at.parent_pointer()].erase(at.back());
    }
    EXPECT_THAT(refusal(scene.dump()), StartsWith("scene.json: " + row["says"].get<std::string>())) << row["at"];
  }
}

TEST(ReadScene, SaysLineAndColumnIfTheTextIsNotJson) {
  const std::pair<std::string, const char*> broken[] = {
      {"", "line 1, column 1: "},
      {"{\n  \"plumb\": 1,\n  }", "line 3, column 3: "},
      {"{\"plumb\": NaN}", "line 1, column 11: "},
      {"{\"plumb\": Infinity}", "line 1, column 11: "},
      {"{\"plumb\": 01}", "line 1, column 12: "},
      {"{\"name\": \"\xff\"}", "line 1, column 11: "},
      {"{\"name\": \"\xed\xa0\x80\"}", "line 1, column 12: "},
      {file("every_feature.json") + "}", "line 43, column 1: "},
      {"{\"plumb\": 1", "line 1, column 12: "},
  };
  for (const auto& [text, place] : broken) EXPECT_THAT(refusal(text), StartsWith("scene.json: " + std::string(place)));
}

TEST(ReadScene, RefusesDuplicateKeys) {
  EXPECT_EQ(refusal(R"({"plumb": 1, "bodies": [{}, {"name": "a", "type": "static", "name": "b"}]})"),
            "scene.json: bodies[1].name: this key is given twice");
  EXPECT_EQ(refusal(R"({"plumb": 1, "a \": b": [{"x": 0, "x": 1}]})"),
            R"(scene.json: "a \": b"[0].x: this key is given twice)");
}

TEST(ReadScene, RefusesNumbersBeyondDoublePrecision) {
  EXPECT_EQ(refusal(R"({"plumb": 1, "gravity": [0, -1e999]})"),
            "scene.json: gravity[1]: expected a number that double precision holds, found -1e999");
}

TEST(ReadScene, RefusesDeepNesting) {
  EXPECT_THAT(refusal(std::string(1'000'000, '[')), HasSubstr("]: is nested deeper than any scene"));
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  EXPECT_THAT(refusal(objects), HasSubstr("a.a.a"));
}

TEST(ReadScene, RefusesFilesThatAreTooLarge) {
  EXPECT_THAT(refusal(file("every_feature.json") + std::string(largest_scene_file, ' ')), HasSubstr("16 MiB"));
}

TEST(ReadScene, NeverShowsControlCharactersFromAFile) {
  const std::string said = refusal("{\"plumb\": 1, \"\\u001b[2J\\u009b\": 1}");
  EXPECT_THAT(said, HasSubstr("unknown key \"?[2J??\""));
  EXPECT_THAT(refusal("{\"plumb\": \x1b[2J}"), ::testing::Not(HasSubstr("\x1b")));
}

std::vector<SceneFile> whole_catalog() {
  std::vector<SceneFile> all;
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    for (const Variant& variant : scenario->variants) {
      all.push_back({scenario->scene(complete(*scenario, variant.changes)), {}});
    }
  }
  return all;
}

void expect_round_trip(const SceneFile& given) {
  const std::string text = write_scene(given);
  const SceneFile read = read_scene(text, "written");
  EXPECT_EQ(SceneBits::of(read), SceneBits::of(given)) << text;
  EXPECT_EQ(write_scene(read), text);
}

TEST(WriteScene, RoundTripsEveryCatalogSceneToTheBit) {
  for (const SceneFile& scene : whole_catalog()) expect_round_trip(scene);
}

TEST(WriteScene, RoundTripsEveryFeature) {
  const SceneFile scene = read_scene(file("every_feature.json"), "every_feature.json");
  expect_round_trip(scene);
  const SceneFile again = read_scene(write_scene(scene), "written");
  EXPECT_EQ(again.source, scene.source);
  EXPECT_EQ(again.origin->engine, scene.origin->engine);
  EXPECT_EQ(again.origin->posed, scene.origin->posed);
}

TEST(WriteScene, RoundTripsRandomScenesToTheBit) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) expect_round_trip(RandomScene(seed).make());
}

TEST(WriteScene, RefusesScenesThatCouldNotBeRead) {
  const auto refused = [](auto change) {
    SceneFile scene{{.name = "bad", .bodies = {disc("disc", {0, 0}, 1, {})}}, {}};
    change(scene.scene);
    try {
      write_scene(scene);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("written");
  };
  EXPECT_THAT(refused([](Scene& scene) { scene.duration = std::nan(""); }), StartsWith("bad: duration: "));
  EXPECT_THAT(refused([](Scene& scene) { scene.bodies[0].angle = std::numeric_limits<double>::infinity(); }),
              StartsWith("bad: bodies[0].angle: "));
  EXPECT_THAT(refused([](Scene& scene) { scene.bodies.push_back(scene.bodies[0]); }), HasSubstr("given twice"));
  EXPECT_THAT(refused([](Scene& scene) { scene.bodies[0].name = "\xff"; }), StartsWith("bad: "));
}

Scene pyramid(int rows) {
  Scene scene{.name = "pyramid", .bodies = {level_ground(surface(0.5, 0))}};
  for (int row = 0; row < rows; ++row) {
    for (int i = row; i < rows; ++i) {
      scene.bodies.push_back(box(std::to_string(row) + "," + std::to_string(i), {1.1 * i - 0.55 * row - 0.1, 0.5 + row},
                                 {1, 1}, surface(0.5, 0)));
    }
  }
  return scene;
}

TEST(ReadScene, Reads5050Bodies) {
  EXPECT_EQ(read_scene(write_scene({pyramid(100), {}}), "pyramid.json").scene.bodies.size(), 5051u);
}

}  // namespace
}  // namespace plumb::scene_json_test
