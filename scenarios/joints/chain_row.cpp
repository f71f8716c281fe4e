#include <cmath>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/sag.h"
#include "scenarios/scenario.h"

// The chains of the classical comparison of physics engines (A. Boeing, T. Braeunl, GRAPHITE 2007).
namespace plumb::scenarios::chain_row {
namespace {

constexpr double length = 0.4;     // m, of a link
constexpr double apart = 0.6;      // m, from chain to chain
constexpr double thickness = 0.1;  // m

std::string name(int chain, int link) { return "link " + std::to_string(link) + " of " + std::to_string(chain); }

// Every link is a box on a hinge at its upper end.
Scene scene(const Parameters& p) {
  Scene scene{.name = "chain-row",
              .about = "Chains of one link, of two, and so on hang side by side from a beam.",
              .duration = p.at("duration")};
  scene.bodies.push_back({.name = "beam", .type = BodyType::fixed, .layers = 0});
  for (int chain = 1; chain <= static_cast<int>(p.at("chains")); ++chain) {
    for (int k = 1; k <= chain; ++k) {
      const double x = apart * chain;
      Body link = box(name(chain, k), {x, -(k - 0.5) * length}, {thickness, length}, {});
      link.layers = 0;
      const std::size_t above = k == 1 ? 0 : scene.bodies.size() - 1;
      scene.joints.push_back(Revolute{.a = above, .b = scene.bodies.size(), .anchor = {x, -(k - 1) * length}});
      scene.bodies.push_back(link);
    }
  }
  return scene;
}

// Nothing moves, within one slop per hinge above, and what they give way where they are springs.
std::vector<Expectation> expectations(const Parameters& p) {
  const double end = p.at("duration");
  const Scene row = scene(p);
  std::vector<Expectation> all;
  for (int chain = 1; chain <= static_cast<int>(p.at("chains")); ++chain) {
    const double reach = chain * (apart + length) + 1;
    const auto last = static_cast<std::size_t>(chain * (chain + 1) / 2);  // bodies of all chains up to this one
    for (const Quantity along : {Quantity::x, Quantity::y}) {
      all.push_back(
          {.body = name(chain, chain),
           .quantity = along,
           .expected = along == Quantity::x ? apart * chain : -(chain - 0.5) * length,
           .allowed =
               [=](const Stepping& s) { return chain * s.joint_slop + sag(s, row, last) + round_off(s, end, reach); },
           .source = "hangs at rest: one slop per hinge above, or the springs' under the links' weight"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "chain-row",
     .question = "Do chains of 1, 2, ... 10 links all hold?",
     .parameters =
         {{.name = "chains", .value = 10, .min = 1, .max = 20, .about = "links of the longest", .whole = true},
          {.name = "duration", .value = 3, .min = 1, .max = 60, .unit = "s", .about = "for which they must hold"}},
     .variants = {{"10", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::chain_row
