// Discs in a silo, whose floor carries less than their weight (H. A. Janssen, Z. Ver. dt. Ing. 39, 1895).

#include <cmath>
#include <numbers>

#include "reports/study/statistics/ensemble.h"
#include "reports/study/statistics/ensembles/grains.h"
#include "scenarios/scene/mass.h"

namespace plumb::ensembles::silo {
namespace {

constexpr double friction = 0.5;
constexpr double width = 0.8;   // m
constexpr double sinks = 0.03;  // m/s, of the floor, so that friction at the walls acts upwards all along them
constexpr double duration = 7;  // s
constexpr double settled = 4;   // s, after which the floor is weighed
const Grains grains{.radius = 0.05, .spread = 0.15, .surface = surface(friction, 0)};

constexpr double filling = 0.82;  // of the area, by grains

// Grains that fill it to that many times its width.
int grains_up_to(double height) {
  const double area = std::numbers::pi * grains.radius * grains.radius * (1 + grains.spread * grains.spread / 3);
  return static_cast<int>(std::lround(height * width * width * filling / area));
}

Scene filled(Random& random, int count) {
  Scene scene{.name = "silo", .about = "Discs in a silo, whose floor sinks slowly.", .duration = duration};
  Body walls = half_space("walls", {.normal = {1, 0}, .offset = -width / 2}, grains.surface);
  walls.shapes.push_back({.geometry = HalfSpace{.normal = {-1, 0}, .offset = -width / 2}, .surface = grains.surface});
  Body floor = box("floor", {0, -0.2}, {width - 0.02, 0.4}, grains.surface);
  floor.type = BodyType::kinematic;
  floor.velocity = {0, -sinks};
  scene.bodies = {walls, floor};
  grains.pour(scene, random, width, count);
  return scene;
}

// The load on the floor, kg.
double weighed(EnsembleRun& run, Random& random, int count) {
  const Scene scene = filled(random, count);
  const std::shared_ptr<const Trace> trace = run.record(scene);
  double impulse = 0;
  double time = 0;
  for (std::size_t moment = 1; moment < trace->size(); ++moment) {
    if (trace->time(moment) < settled) continue;
    time += trace->time(moment) - trace->time(moment - 1);
    for (const ContactState& contact : trace->contacts(moment)) {
      // The floor is body 1, its contacts' normals vertical and their friction horizontal.
      if (contact.a == 1) impulse += contact.normal_impulse * contact.normal.y;
      if (contact.b == 1) impulse -= contact.normal_impulse * contact.normal.y;
    }
  }
  return impulse / time / standard_gravity;
}

double mass(Random random, int count) {
  double sum = 0;
  const Scene scene = filled(random, count);
  for (const Body& body : scene.bodies) sum += body.type == BodyType::dynamic ? mass_of(body).mass : 0;
  return sum;
}

std::vector<EnsembleDraw> draws(EnsembleRun& run, std::uint64_t seed) {
  Random random(seed);
  const int low = grains_up_to(2);
  const int high = grains_up_to(4);
  const double low_mass = mass(random, low);
  const double low_load = weighed(run, random, low);
  const double high_mass = mass(random, high);
  const double high_load = weighed(run, random, high);
  return {{low_load / low_mass, high_load / high_mass, high_load / low_load}};
}

// Janssen in two dimensions: a wall that slips on either side carries mu K s per unit of height where the vertical
// stress is s, so that s' = rho g - 2 mu K s/D. The floor's share of the weight is (1 - e^-x)/x, x = 2 mu K H/D. K lies
// between Rankine's limits for the angle of internal friction, (1 - sin phi)/(1 + sin phi) and its inverse. Here phi is
// at most the angle of friction of the grains, which can roll: phi = arctan mu is the widest band.
const double sine = friction / std::sqrt(1 + friction * friction);
const double least_k = (1 - sine) / (1 + sine);
double share(double k, double height) {
  const double x = 2 * friction * k * height;
  return (1 - std::exp(-x)) / x;
}
double growth(double k) { return 2 * share(k, 4) / share(k, 2); }

Statistic share_at(const char* name, double height) {
  return {.name = name,
          .low = share(1 / least_k, height),
          .high = share(least_k, height),
          .resolution = 0.15,
          .source = "Janssen: (1 - e^-x)/x, x = 2 mu K H/D; K within Rankine's limits for phi = arctan mu"};
}

const Catalog<Ensemble>::Entry entry{
    {.name = "silo",
     .question = "Do the walls of a silo carry what Janssen says, so that its floor's load saturates?",
     .dt = 1.0 / 120,
     .runs = 12,
     .large = 200,
     .statistics = {share_at("load/weight, height 2 D", 2),
                    share_at("load/weight, height 4 D", 4),
                    {.name = "load at 4 D / at 2 D",
                     .low = 1,
                     .high = growth(least_k),
                     .resolution = 0.4,
                     .source = "from saturated to Janssen's growth at the least K; 2 without walls that carry"}},
     .draws = draws,
     .control = [] { return *Catalog<Control>::find("frictionless"); }}};

}  // namespace
}  // namespace plumb::ensembles::silo
