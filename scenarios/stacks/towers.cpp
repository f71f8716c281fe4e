#include <algorithm>
#include <cmath>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/sag.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::stacking {
namespace {

constexpr double size = 1;        // m
constexpr double friction = 0.5;  // enough to prevent slipping; the exact solution needs none
constexpr double gravity = 10;    // m/s^2

std::string box_name(int k) { return "box " + std::to_string(k); }

Scene scene(const Parameters& p) {
  const int boxes = static_cast<int>(p.at("boxes"));
  Scene scene{.name = "stacking",
              .about = "A tower of boxes, stacked exactly and at rest.",
              .gravity = {0, -gravity},
              .duration = p.at("duration")};
  scene.bodies.push_back(level_ground(surface(friction, 0)));
  for (int k = 1; k <= boxes; ++k) {
    const double density = k == boxes ? p.at("ratio") : 1;
    scene.bodies.push_back(box(box_name(k), {0, (k - 0.5) * size}, {size, size}, surface(friction, 0, density)));
  }
  return scene;
}

// Nothing moves. The error allowed for box k comes from the k contacts below it:
//   y      each may be off by the engine's gap: k gap; and where contacts are springs, by their depths;
//   angle  one corner of each may be deeper by the slop: slop/size each, k slop/size together;
//   x      each box adds to the lean of the one below: sum over j <= k of size j slop/size = k (k+1)/2 slop. On level
//          ground friction has nothing to hold, and nothing creeps.
// Only the round-off of positions accumulates; that of velocities is stopped by the contacts.
std::vector<Expectation> expectations(const Parameters& p) {
  const double end = p.at("duration");
  const int boxes = static_cast<int>(p.at("boxes"));
  std::vector<double> masses(static_cast<std::size_t>(boxes), size * size);
  masses.back() *= p.at("ratio");
  std::vector<Expectation> all;
  for (int k = 1; k <= boxes; ++k) {
    const double reach = (k + 1) * size;
    all.push_back({.body = box_name(k),
                   .quantity = Quantity::y,
                   .allowed =
                       [=](const Stepping& s) {
                         return k * s.contact_gap() + tower_sinks(s, gravity, masses, static_cast<std::size_t>(k)) +
                                round_off(s, end, reach);
                       },
                   .source = "equilibrium: does not move, within one gap or depth of its spring per contact below"});
  }
  // The impulses of a contact add up to the weight above it times the time. What may be missing is a lag at the start,
  // during which it may not push, and the speed of a last step.
  for (int k = 1; k <= boxes; ++k) {
    const double above = (boxes - k + p.at("ratio")) * size * size * gravity;  // N
    all.push_back(
        {.body = box_name(k),
         .other = k == 1 ? "ground" : box_name(k - 1),
         .quantity = Quantity::load,
         .over = end,
         .expected = above,
         .allowed = [=](const Stepping& s) { return above * (lag(s) + s.h) / end + round_off(s, end, above); },
         .source = "contact k carries (n-k+1) m g on average; a lag at the start and the last step"});
  }
  const int k = boxes;
  const double reach = (k + 1) * size;
  all.push_back({.body = box_name(k),
                 .quantity = Quantity::x,
                 .allowed = [=](const Stepping& s) { return k * (k + 1) / 2.0 * s.slop + round_off(s, end, reach); },
                 .source = "equilibrium: leans at most by one slop per contact"});
  all.push_back({.body = box_name(k),
                 .quantity = Quantity::angle,
                 .allowed = [=](const Stepping& s) { return k * s.slop / size + round_off(s, end, reach / size); },
                 .source = "equilibrium: one corner of each contact may be deeper by the slop"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "stacking",
     .question = "Does a tower of boxes stand still?",
     .parameters = {{.name = "boxes", .value = 10, .min = 1, .max = 100, .about = "in the tower", .whole = true},
                    {.name = "ratio",
                     .value = 1,
                     .min = 0.001,
                     .max = 1000,
                     .about = "mass of the top box divided by that of each other box"},
                    {.name = "duration",
                     .value = 10,
                     .min = 0.1,
                     .max = 100,
                     .unit = "s",
                     .about = "time for which it must stand"}},
     .variants = {{"one", {{"boxes", 1}, {"duration", 2}}}, {"ten", {}}, {"heavy-top", {{"boxes", 2}, {"ratio", 100}}}},
     .closed_form = "rest",
     .scene = scene,
     .expectations = expectations,
     .canonical = true}};

}  // namespace
}  // namespace plumb::scenarios::stacking

namespace plumb::scenarios::mass_ratio {
namespace {

constexpr double duration = 5;  // s

std::string name(int k) { return "box " + std::to_string(k); }

// Each box is `ratio` times as heavy as the one below it, so the lightest carries all; up to 1e8 times the lightest,
// whose own weight then has half of the digits of double precision beside that load.
double density_of(const Parameters& p, int k) { return std::min(std::pow(p.at("ratio"), k - 1), 1e8); }

Scene scene(const Parameters& p) {
  Scene scene{
      .name = "mass-ratio", .about = "A tower in which every box is heavier than the one below.", .duration = duration};
  scene.bodies.push_back(level_ground(surface(0.5, 0)));
  for (int k = 1; k <= static_cast<int>(p.at("boxes")); ++k) {
    scene.bodies.push_back(box(name(k), {0, k - 0.5}, {1, 1}, surface(0.5, 0, density_of(p, k))));
  }
  return scene;
}

// As in any tower, nothing moves except by one gap, or the depth of a spring, per contact below.
std::vector<Expectation> expectations(const Parameters& p) {
  std::vector<double> masses;
  for (int k = 1; k <= static_cast<int>(p.at("boxes")); ++k) masses.push_back(density_of(p, k));
  std::vector<Expectation> all;
  for (int k = 1; k <= static_cast<int>(p.at("boxes")); ++k) {
    all.push_back({.body = name(k),
                   .quantity = Quantity::y,
                   .allowed =
                       [=](const Stepping& s) {
                         return k * s.contact_gap() +
                                tower_sinks(s, standard_gravity, masses, static_cast<std::size_t>(k)) +
                                round_off(s, duration, k + 1);
                       },
                   .source = "equilibrium: does not move, within one gap or depth of its spring per contact below"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "mass-ratio",
     .question = "Does a tower stand if each box is heavier than the one below it?",
     .parameters = {{.name = "boxes", .value = 4, .min = 2, .max = 10, .about = "in the tower", .whole = true},
                    {.name = "ratio",
                     .value = 10,
                     .min = 1,
                     .max = 100,
                     .about = "mass of a box divided by that of the one below, up to 1e8 times the lowest"}},
     .variants = {{"3", {{"ratio", 3}}}, {"10", {}}},
     .closed_form = "rest",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::mass_ratio

namespace plumb::scenarios::overhang {
namespace {

constexpr double friction = 0.5;
constexpr double duration = 5;  // s
const Vec block{2, 0.5};        // m

std::string name(int k) { return "block " + std::to_string(k); }

// m, from the left end of block k + 1 to that of block k, counted from the top: each extends beyond the next.
double beyond(double fraction, int k) { return fraction * block.x / (2 * k); }

// What contacts that are springs give way, from the ground up, in m and rad for each block, the top one first. The
// k blocks above a surface rest on the two ends of what it bears, by the law of the lever, and each end is as deep as
// its spring.
std::vector<Sag> given_way(const Stepping& s, int blocks, double fraction) {
  const double mass = block.x * block.y;
  const double inertia = mass * (block.x * block.x + block.y * block.y) / 12;
  const auto count = static_cast<std::size_t>(blocks);
  std::vector<double> x(count);  // of the centres
  for (std::size_t k = count - 1; k > 0; --k) x[k - 1] = x[k] + beyond(fraction, static_cast<int>(k));
  std::vector<Sag> all(count);
  double above = 0;  // sum of x
  std::vector<double> common(count);
  for (std::size_t k = 0; k < count; ++k) common[k] = (above += x[k]) / static_cast<double>(k + 1);
  for (std::size_t k = count; k-- > 0;) {
    const bool on_ground = k + 1 == count;
    const double left = x[k] - block.x / 2;
    const double right = (on_ground ? x[k] : x[k + 1]) + block.x / 2;
    const double load = static_cast<double>(k + 1) * mass * standard_gravity;
    const double share = (common[k] - left) / (right - left);
    const auto height = [&](double end, double borne) {
      double inverse_mass = 1 / mass + (end - x[k]) * (end - x[k]) / inertia;
      if (on_ground) return -spring_depth(s.fixed_contact_frequency, borne, inverse_mass);
      const double arm = end - x[k + 1];
      inverse_mass += 1 / mass + arm * arm / inertia;
      const Sag& below = all[k + 1];
      return below.shift.y + below.turn * arm - spring_depth(s.contact_frequency, borne, inverse_mass);
    };
    const double of_left = height(left, (1 - share) * load);
    const double of_right = height(right, share * load);
    all[k].turn = (of_right - of_left) / (right - left);
    all[k].shift.y = of_left + all[k].turn * (x[k] - left);
  }
  return all;
}

// Counted from the top, block k extends fraction * L/(2 k) beyond the next one; the lowest lies on the ground.
Scene scene(const Parameters& p) {
  const int blocks = static_cast<int>(p.at("blocks"));
  Scene scene{
      .name = "overhang", .about = "Blocks stacked with an overhang near the harmonic limit.", .duration = duration};
  scene.bodies.push_back(level_ground(surface(friction, 0)));
  double x = 0;
  for (int k = blocks; k >= 1; --k) {
    scene.bodies.push_back(box(name(k), {x, (blocks - k + 0.5) * block.y}, block, surface(friction, 0)));
    if (k > 1) x += beyond(p.at("fraction"), k - 1);
  }
  return scene;
}

// Beyond the limit the blocks above each surface have their common centre beyond its edge and turn about it. At the end
// the top block of four or more has come down by at least its own height: wherever it comes to rest, it has left the
// pile. Of fewer it may lean on the one below.
std::vector<Expectation> fallen(int blocks) {
  return {{.body = name(1),
           .quantity = Quantity::y,
           .relation = Relation::at_most,
           .expected = (blocks - 1.5) * block.y,
           .allowed = [=](const Stepping& s) { return round_off(s, duration, block.x * blocks); },
           .source = "topples, as the overhang is above (L/2) sum 1/k; falls by at least one block"}};
}

// Below the limit nothing moves, except by one gap per contact below in height and by the tilt of their slop,
// slop/bearing each. The bearing is the part of L under block k, L (1 - fraction/(2 k)), at least half of it. Contacts
// that are springs give way by their load.
std::vector<Expectation> expectations(const Parameters& p) {
  const int blocks = static_cast<int>(p.at("blocks"));
  if (p.at("fraction") > 1) return fallen(blocks);
  std::vector<Expectation> all;
  for (int k = 1; k <= blocks; ++k) {
    const int below = blocks - k + 1;
    const auto index = static_cast<std::size_t>(k - 1);
    const double fraction = p.at("fraction");
    const double tilt = 2.0 * below / block.x;  // rad per m of slop
    all.push_back(
        {.body = name(k),
         .quantity = Quantity::y,
         .allowed =
             [=](const Stepping& s) {
               return below * s.contact_gap() + tilt * block.x / 2 * below * s.slop +
                      std::abs(given_way(s, blocks, fraction)[index].shift.y) +
                      round_off(s, duration, block.x * blocks);
             },
         .source = "equilibrium, as the overhang is below (L/2) sum 1/k; one gap per contact below, and their tilt"});
    all.push_back({.body = name(k),
                   .quantity = Quantity::angle,
                   .allowed =
                       [=](const Stepping& s) {
                         return tilt * s.slop + std::abs(given_way(s, blocks, fraction)[index].turn) +
                                round_off(s, duration, 1);
                       },
                   .source = "equilibrium: the tilt of one slop or spring per contact below"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "overhang",
     .question = "Do blocks with an overhang up to the harmonic series stand, and fall beyond it?",
     .parameters =
         {{.name = "blocks", .value = 4, .min = 4, .max = 20, .about = "in the pile", .whole = true},
          {.name = "fraction", .value = 0.99, .min = 0, .max = 1.5, .about = "overhang as a fraction of the limit"}},
     .variants = {{"90%", {{"fraction", 0.9}}}, {"99%", {}}, {"101%", {{"fraction", 1.01}}}},
     .closed_form = "rest",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::overhang
