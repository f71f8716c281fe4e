#include <gmock/gmock.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/scene/scene_json.h"
#include "scene_samples.h"

namespace plumb::scene_json_mutations_test {
namespace {

using Json = nlohmann::ordered_json;

// Corrupts a scene file the way typing errors, faulty programs and bad connections do. The same seed gives the same
// changes.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : draw_(seed) {}

  std::string operator()(const std::string& text) { return below(2) == 0 ? bytes(text) : structure(text); }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(draw_() % n); }

  std::string bytes(std::string text) {
    for (std::size_t times = 1 + below(3); times > 0 && !text.empty(); --times) {
      const std::size_t at = below(text.size());
      switch (below(5)) {
        case 0:
          text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
          break;
        case 1:
          text.insert(at, 1, static_cast<char>(below(256)));
          break;
        case 2:
          text.erase(at, 1 + below(20));
          break;
        case 3:
          copy(text, at);
          break;
        default:
          text.resize(at);
      }
    }
    return text;
  }

  // Draws one after the other, which arguments of a call need not be.
  void copy(std::string& text, std::size_t to) {
    const std::size_t from = below(text.size());
    text.insert(to, text.substr(from, below(200)));
  }

  std::string structure(const std::string& text) {
    Json json = Json::parse(text);
    for (std::size_t times = 1 + below(3); times > 0; --times) change(json);
    return json.dump();
  }

  // A random value somewhere in the tree.
  Json& place(Json& json) {
    Json* at = &json;
    while (at->is_structured() && !at->empty() && below(5) != 0) {
      auto child = at->begin();
      std::advance(child, static_cast<std::ptrdiff_t>(below(at->size())));
      at = &*child;
    }
    return *at;
  }

  Json odd_value() {
    static const std::vector<Json> values{nullptr,
                                          true,
                                          "",
                                          "box",
                                          "x\ty",
                                          0,
                                          -1,
                                          1e300,
                                          5e-324,
                                          -0.0,
                                          4294967296,
                                          0.5,
                                          1e7,
                                          Json::array(),
                                          "end",
                                          "kinematic",
                                          {1, 2},
                                          {{"type", 1}},
                                          Json::object(),
                                          {0, 0, 0},
                                          std::string(3000, 'n')};
    return values[below(values.size())];
  }

  void change(Json& json) {
    Json& at = place(json);
    switch (below(4)) {
      case 0:
        at = odd_value();
        break;
      case 1:
        at = Json(place(json));
        break;
      case 2:
        if (at.is_array()) at.push_back(at.empty() ? odd_value() : at.front());
        if (at.is_object()) at["type"] = odd_value();
        break;
      default:
        if (at.is_structured() && !at.empty()) at.erase(at.begin());
    }
  }

  std::mt19937_64 draw_;
};

std::vector<std::string> exported() {
  std::vector<std::string> texts;
  for (const Scenario* scenario : Catalog<Scenario>::all()) {
    const Scene scene = scenario->scene(complete(*scenario, {}));
    if (scene.bodies.size() < 50) texts.push_back(write_scene({scene, {}}));
  }
  for (std::uint64_t seed = 1; seed <= 20; ++seed) texts.push_back(write_scene(RandomScene(seed).make()));
  return texts;
}

// Each file is either read completely, so that it can be written again, or refused with the location of the error.
TEST(ReadScene, ReadsOrRefusesTenThousandMutatedFiles) {
  const testing::Matcher<std::string> says_where =
      testing::ContainsRegex(R"re(^m\.json: (line [0-9]+, column [0-9]+|top level|([^ "]|"([^"\\]|\\.)*")+): .)re");
  const std::vector<std::string> texts = exported();
  Mutator mutated(1);
  int refused = 0;
  for (std::size_t i = 0; i < 10'000; ++i) {
    const std::string text = mutated(texts[i % texts.size()]);
    try {
      write_scene(read_scene(text, "m.json"));
    } catch (const std::invalid_argument& error) {
      ++refused;
      ASSERT_TRUE(says_where.Matches(error.what())) << error.what() << '\n' << text;
    }
  }
  EXPECT_GT(refused, 5'000);
  EXPECT_LT(refused, 9'900);  // the mutations are mild enough that some files are still valid
}

}  // namespace
}  // namespace plumb::scene_json_mutations_test
