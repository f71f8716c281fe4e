#include <cmath>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

// More bodies than an engine may test every pair of, all moving or hardly any: it may have another way to find pairs
// for each.
namespace plumb::scenarios::crowd {
namespace {

constexpr double duration = 2;  // s
constexpr double radius = 0.4;  // m
constexpr double pitch = 1;     // m, from pair to pair
constexpr double apart = 1.03;  // m between the two of a pair

int pairs(const Parameters& p) { return static_cast<int>(p.at("pairs")); }
bool moves(const Parameters& p, int pair) { return pair % static_cast<int>(p.at("every")) == 0; }
double speed(int pair) { return 1.5 + 0.25 * (pair % 7); }  // m/s
std::string left(int pair) { return "left " + std::to_string(pair + 1); }
std::string right(int pair) { return "right " + std::to_string(pair + 1); }

// Each pair has a line of its own; a fixed disc stands far behind the last, so that the number of bodies is odd.
Scene scene(const Parameters& p) {
  const Surface ivory = surface(0, 1);
  Scene scene{.name = "crowd",
              .about = "Many pairs of equal discs, one of which hits the other.",
              .gravity = {0, 0},
              .duration = duration};
  for (int i = 0; i < pairs(p); ++i) {
    scene.bodies.push_back(disc(left(i), {-radius - apart / 2, i * pitch}, radius, ivory));
    scene.bodies.push_back(disc(right(i), {radius + apart / 2, i * pitch}, radius, ivory));
    if (moves(p, i)) scene.bodies[scene.bodies.size() - 2].velocity = {speed(i), 0};
  }
  scene.bodies.push_back(fixed(disc("post", {0, (pairs(p) + 1) * pitch}, radius, ivory)));
  return scene;
}

// Equal masses with e = 1 swap velocities. As in a head-on impact, positions are off by the velocity jump times the lag
// and the penetration. Two pairs are read, and the sums over all bodies.
std::vector<Expectation> expectations(const Parameters& p) {
  const Scene all_bodies = scene(p);
  const double mass = mass_of(all_bodies.bodies.front()).mass;
  const double count = static_cast<double>(all_bodies.bodies.size());
  double momentum = 0;
  double energy = 0;
  int last = 0;
  for (int i = 0; i < pairs(p); ++i) {
    if (!moves(p, i)) continue;
    momentum += mass * speed(i);
    energy += mass * speed(i) * speed(i) / 2;
    last = i;
  }
  std::vector<Expectation> all;
  for (const int pair : {0, last}) {
    const double v = speed(pair);
    const auto exact = [=](const Stepping& s) { return round_off(s, duration, pair * pitch + apart + v * duration); };
    const auto place = [=](const Stepping& s) { return 3 * v * lag(s) + s.contact_gap() + exact(s); };
    const double half = radius + apart / 2;
    const char* law = "equal discs swap velocities; the velocity jump times the lag, and the penetration";
    all.push_back({.body = right(pair), .quantity = Quantity::vx, .expected = v, .allowed = exact, .source = law});
    all.push_back(
        {.body = left(pair), .quantity = Quantity::x, .expected = -half + apart, .allowed = place, .source = law});
    all.push_back({.body = right(pair),
                   .quantity = Quantity::x,
                   .expected = half + v * duration - apart,
                   .allowed = place,
                   .source = law});
    if (last == 0) break;
  }
  const auto rounded = [=](const Stepping& s) { return count * mass * round_off(s, duration, 3); };
  all.push_back({.quantity = Quantity::momentum_x,
                 .expected = momentum,
                 .allowed = rounded,
                 .source = "constant: no external force"});
  all.push_back({.quantity = Quantity::energy,
                 .expected = energy,
                 .allowed = [=](const Stepping& s) { return 3 * rounded(s); },
                 .source = "constant, as e = 1: none is lost and none hits twice"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "crowd",
     .question = "Does each pair of a crowd collide as if alone?",
     .parameters =
         {{.name = "pairs", .value = 150, .min = 1, .max = 5000, .about = "pairs of discs", .whole = true},
          {.name = "every", .value = 1, .min = 1, .max = 1000, .about = "of how many pairs one moves", .whole = true}},
     .variants = {{"all move", {}}, {"few move", {{"every", 16}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::crowd
