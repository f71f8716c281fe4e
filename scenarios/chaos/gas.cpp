#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::gas {
namespace {

constexpr double duration = 30;  // s
constexpr double mixed = 4;      // s, the time from which the speeds are sampled
constexpr double speed = 2;      // m/s, of every disc at the start
constexpr double radius = 0.1;   // m
constexpr double spacing = 0.5;  // m

int side(const Parameters& p) { return static_cast<int>(p.at("side")); }

Scene scene(const Parameters& p) {
  const Surface elastic = surface(0, 1);
  Scene scene{.name = "gas",
              .about = "Discs fly about in a box, all equally fast at first, without friction or energy loss.",
              .gravity = {0, 0},
              .duration = duration};
  const double half = side(p) * spacing / 2;
  const std::pair<const char*, Vec> walls[] = {
      {"floor", {0, 1}}, {"lid", {0, -1}}, {"left", {1, 0}}, {"right", {-1, 0}}};
  for (const auto& [name, normal] : walls) {
    scene.bodies.push_back(half_space(name, {.normal = normal, .offset = -half}, elastic));
  }
  Random random(20);
  for (int i = 0; i < side(p) * side(p); ++i) {
    const int row = i / side(p);
    const int column = i % side(p);
    const Vec place{(column + 0.5) * spacing - half, (row + 0.5) * spacing - half};
    Body one = disc("disc " + std::to_string(i + 1), place, radius, elastic);
    const double direction = random.between(0, 2 * std::numbers::pi);
    one.velocity = {speed * std::cos(direction), speed * std::sin(direction)};
    scene.bodies.push_back(one);
  }
  return scene;
}

// Energy: constant, whenever impacts are detected. Impacts slower than a threshold u are inelastic: each loses at most
// m u^2/4. Of all impacts (u/v)^2/2 are that slow (at equilibrium the normal speed g of colliding discs has the density
// g exp(-g^2/(2 v^2))/v^2), and each disc has sqrt(2) n 2d v impacts a second, with n discs per square metre and
// diameter d. If a disc has two impacts in a step, iterations leave a fraction of both energies unsolved: at worst
// always.
//
// Speeds: in the long run every state of that energy is equally likely. Then the N squared speeds are uniformly
// distributed over the simplex sum v^2 = const, with the moments
//   E<v^4>/<v^2>^2 = 2N/(N+1),   Var = 4 N^2 (N-1)/((N+1)^2 (N+2) (N+3)):
// Maxwell's 2 for large N. The fourth moment relaxes at half the rate of collisions L (the first Sonine coefficient of
// hard discs; Chapman, Cowling 1970), so that a mean over a time T has the variance Var 4/(L T), L at least sqrt(2) n
// 2d times the mean speed sqrt(pi)/2 v. Four sigma, as one run in 16 000 is off by that much. And what is left of the
// start, where the ratio is 1: e^(-L t/2). Inelastic impacts change the distribution itself: if all were, by 32/57 (van
// Noije, Ernst 1998); in their proportion if they are those slower than a threshold.
std::vector<Expectation> expectations(const Parameters& p) {
  const double n = side(p) * side(p);
  const double mass = mass_of(scene(p).bodies.back()).mass;
  const double energy = n * mass * speed * speed / 2;
  const double meetings = n / 2 * duration * std::numbers::sqrt2 / (spacing * spacing) * 4 * radius * speed;
  const double sigma = 2 * n / (n + 1) * std::sqrt((n - 1) / ((n + 2) * (n + 3)));
  const double rate = std::numbers::sqrt2 / (spacing * spacing) * 4 * radius * speed * std::sqrt(std::numbers::pi) / 2;
  const double of_mean = sigma * std::sqrt(4 / (rate * (duration - mixed)));
  const auto lost = [=](const Stepping& s, double time) {
    const double u = s.restitution_threshold;
    const double met = meetings * time / duration;
    const double slow = met * u * u / (2 * speed * speed);
    const double coincident = 2 * met * mass * speed * speed * unsolved(s, 2);
    return slow * mass * u * u / 4 + coincident + 2 * energy / speed * round_off(s, time, speed);
  };
  const auto spread = [=](const Stepping& s) {
    const double u = s.restitution_threshold;
    const double left = std::max(1 - lost(s, duration) / energy, 0.0);  // of the energy
    const double slow = u > 0 ? std::min(u * u / (2 * speed * speed) / std::max(left, 0.01), 1.0) : 0;
    return 4 * of_mean + std::exp(-rate * mixed / 2) + 32.0 / 57 * slow + round_off(s, duration, 1);
  };
  std::vector<Expectation> all;
  for (const double time : {1.0, duration}) {
    all.push_back({.quantity = Quantity::energy,
                   .time = time,
                   .expected = energy,
                   .allowed = [=](const Stepping& s) { return lost(s, time); },
                   .source = "N m v^2/2, constant as e = 1; impacts slower than a threshold"});
  }
  all.push_back({.quantity = Quantity::speed_spread,
                 .over = duration - mixed,
                 .expected = 2 * n / (n + 1),
                 .allowed = spread,
                 .chance = 4 * of_mean,
                 .source = "2D Maxwell distribution: <v^4>/<v^2>^2 = 2N/(N+1); four sigma of its mean over time"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "gas",
     .question = "Do elastic discs conserve energy and reach Maxwell's distribution of speeds?",
     .parameters = {{.name = "side",
                     .value = 16,
                     .min = 4,
                     .max = 40,
                     .about = "discs along each side of the box at the start",
                     .whole = true}},
     .variants = {{"256", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::gas
