#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::stacking {
namespace {

constexpr double size = 1;        // m
constexpr double friction = 0.5;  // enough that nothing slips by itself; the truth needs none
constexpr double gravity = 10;    // m/s^2

std::string box_name(int k) { return "box " + std::to_string(k); }

Scene scene(const Parameters& p) {
  const int boxes = static_cast<int>(p.at("boxes"));
  Scene scene{.name = "stacking",
              .about = "A tower of boxes, exactly upon each other, at rest.",
              .gravity = {0, -gravity},
              .duration = p.at("duration")};
  scene.bodies.push_back(level_ground(surface(friction, 0)));
  for (int k = 1; k <= boxes; ++k) {
    const double density = k == boxes ? p.at("ratio") : 1;
    scene.bodies.push_back(box(box_name(k), {0, (k - 0.5) * size}, {size, size}, surface(friction, 0, density)));
  }
  return scene;
}

// Nothing moves. What an engine may be off by are the k contacts below box k, each of
// which may stand off by the engine's gap:
//   y      k gap;
//   angle  a contact may gape by the gap on one side and sink in by it on the other: 2 gap/size each, so 2 k gap/size;
//   x      each box carries on the lean of the one below: sum over j <= k of size 2 j gap/size = k (k+1) gap, and the
//   creep
//          of k sticking contacts.
// Round-off of places alone adds up: that of speeds is stopped by the contacts.
std::vector<Expectation> expectations(const Parameters& p) {
  const double end = p.at("duration");
  const int boxes = static_cast<int>(p.at("boxes"));
  std::vector<Expectation> all;
  for (int k = 1; k <= boxes; ++k) {
    const double reach = (k + 1) * size;
    all.push_back({.body = box_name(k),
                   .quantity = Quantity::y,
                   .allowed = [=](const Stepping& s) { return k * s.gap + round_off(s, end, reach); },
                   .source = "equilibrium: stays where it is, within one gap a contact below"});
  }
  // The impulses of a contact add up to the weight above it times the time: what may lack is a lag at the start, in
  // which it may not push, and the speed of a last step.
  for (int k = 1; k <= boxes; ++k) {
    const double above = (boxes - k + p.at("ratio")) * size * size * gravity;  // N
    all.push_back(
        {.body = box_name(k),
         .other = k == 1 ? "ground" : box_name(k - 1),
         .quantity = Quantity::load,
         .over = end,
         .expected = above,
         .allowed = [=](const Stepping& s) { return above * (lag(s) + s.h) / end + round_off(s, end, above); },
         .source = "contact k carries (n-k+1) m g, in the mean; a lag at the start and the last step"});
  }
  const int k = boxes;
  const double reach = (k + 1) * size;
  all.push_back(
      {.body = box_name(k),
       .quantity = Quantity::x,
       .allowed = [=](const Stepping& s) { return k * (k + 1) * s.gap + k * s.creep * end + round_off(s, end, reach); },
       .source = "equilibrium: no lean but what one gap a contact and the creep make"});
  all.push_back({.body = box_name(k),
                 .quantity = Quantity::angle,
                 .allowed = [=](const Stepping& s) { return 2 * k * s.gap / size + round_off(s, end, reach / size); },
                 .source = "equilibrium: each contact may gape by its gap on one side and sink in on the other"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "stacking",
     .question = "Does a tower of boxes stand still?",
     .parameters =
         {{.name = "boxes", .value = 10, .min = 1, .max = 100, .about = "in the tower", .whole = true},
          {.name = "ratio", .value = 1, .min = 0.001, .max = 1000, .about = "mass of the top box to the others"},
          {.name = "duration", .value = 10, .min = 0.1, .max = 100, .unit = "s", .about = "how long it must stand"}},
     .variants = {{"one", {{"boxes", 1}, {"duration", 2}}}, {"ten", {}}, {"heavy-top", {{"boxes", 2}, {"ratio", 100}}}},
     .closed_form = "rest",
     .scene = scene,
     .expectations = expectations,
     .canonical = true}};

}  // namespace
}  // namespace plumb::scenarios::stacking
