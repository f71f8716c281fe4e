// Light and heavy elastic discs without friction: a gas of two kinds, spinning.

#include <algorithm>
#include <cmath>

#include "reports/study/statistics/ensemble.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"
#include "scenarios/scene/mass.h"

namespace plumb::ensembles::equipartition {
namespace {

constexpr int side = 6;          // discs along each side at the start
constexpr double spacing = 0.4;  // m
constexpr double radius = 0.1;   // m
constexpr double speed = 3;      // m/s, of all at the start, along x
constexpr double spin = 2;       // rad/s, at most, at the start
constexpr double heavier = 4;    // ratio of masses
constexpr double mixed = 5;      // s, more than 30 impacts of each disc
constexpr double duration = 15;  // s

Scene gas(Random& random) {
  Scene scene{.name = "equipartition",
              .about = "Light and heavy elastic discs fly about in a box, all along x at first.",
              .gravity = {0, 0},
              .duration = duration};
  const double half = side * spacing / 2;
  const std::pair<const char*, Vec> walls[] = {
      {"floor", {0, 1}}, {"lid", {0, -1}}, {"left", {1, 0}}, {"right", {-1, 0}}};
  for (const auto& [name, normal] : walls)
    scene.bodies.push_back(half_space(name, {.normal = normal, .offset = -half}, surface(0, 1)));
  const double jitter = spacing / 2 - radius;
  for (int i = 0; i < side * side; ++i) {
    const int row = i / side;
    const int column = i % side;
    const double density = (row + column) % 2 == 0 ? 1 : heavier;
    const Vec at{(column + 0.5) * spacing - half + random.between(-jitter, jitter),
                 (row + 0.5) * spacing - half + random.between(-jitter, jitter)};
    Body one = disc("disc " + std::to_string(i + 1), at, radius, surface(0, 1, density));
    one.velocity = {random.between(0, 1) < 0.5 ? speed : -speed, 0};
    one.angular_velocity = random.between(-spin, spin);
    scene.bodies.push_back(one);
  }
  return scene;
}

std::vector<EnsembleDraw> draws(EnsembleRun& run, std::uint64_t seed) {
  Random random(seed);
  const Scene scene = gas(random);
  std::vector<double> masses;
  double mean_mass = 0;
  for (const Body& body : scene.bodies) masses.push_back(body.type == BodyType::fixed ? 0 : mass_of(body).mass);
  for (const double mass : masses) mean_mass += mass / (side * side);
  double along_x = 0, along_y = 0, light = 0, heavy = 0, turned = 0;  // twice the energies; rad/s
  run.watch(scene, [&](double time, std::span<const BodyState> states) {
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (masses[i] == 0) continue;
      const Vec v = states[i].velocity;
      turned = std::max(turned, std::abs(states[i].angular_velocity - scene.bodies[i].angular_velocity));
      if (time < mixed) continue;
      along_x += masses[i] * v.x * v.x;
      along_y += masses[i] * v.y * v.y;
      (masses[i] > mean_mass ? heavy : light) += masses[i] * (v.x * v.x + v.y * v.y);
    }
    return true;
  });
  return {{(along_x - along_y) / (along_x + along_y), (heavy - light) / (heavy + light), turned / spin}};
}

// Between walls only the energy is kept, so that all states of it are equally likely: each of the 2N terms m v^2/2 has
// the same mean, exactly, for any number of discs. Without friction the contact force goes through the centre; a lever
// arm that is rounding, 2^-24 of the box's 2.4 m, lets the hundred impacts of a disc, each at most 2 m v of twice its
// speed, turn it by 100 (2 * 6 m/s) 1.4e-7 m/(r^2/2) = .035 rad/s if all err to one side: .017 of the largest spin.
const Catalog<Ensemble>::Entry entry{
    {.name = "equipartition",
     .question = "Do elastic discs share their energy equally, between directions and between masses?",
     .dt = 1.0 / 120,
     .runs = 16,
     .large = 320,
     .statistics = {{.name = "(Ex - Ey)/E", .resolution = 0.04, .source = "equipartition between x and y"},
                    {.name = "(heavy - light)/E",
                     .resolution = 0.04,
                     .source = "equipartition between 18 heavy and 18 light discs"},
                    {.name = "change of spin",
                     .high = 0.017,
                     .resolution = 0.01,
                     .source = "kept without friction, to the rounding of lever arms; of the largest initial spin"}},
     .draws = draws,
     .control = [] { return *Catalog<Control>::find("coasting"); }}};

}  // namespace
}  // namespace plumb::ensembles::equipartition
