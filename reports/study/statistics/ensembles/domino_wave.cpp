// The front that runs along a row of dominoes.

#include <cmath>
#include <stdexcept>

#include "reports/study/statistics/ensemble.h"
#include "reports/study/statistics/ensembles/models.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"

namespace plumb::ensembles::domino_wave {
namespace {

constexpr DominoRow row{.height = 1, .thickness = 0.1, .pitch = 0.5};  // m
constexpr int dominoes = 20;
constexpr int first = 8;  // timed from there on
constexpr int last = 18;
constexpr double irregular = 0.05;  // of a pitch, either way
constexpr double leaning = 0.02;    // rad, at which the front has reached one

// Geometric mixing: 0.02 between dominoes, 1 on the ground, so that feet stay where they are.
Scene row_of_dominoes(Random& random) {
  Scene scene{.name = "domino-wave", .about = "A row of dominoes, of which the first is pushed.", .duration = 8};
  scene.bodies.push_back(level_ground(surface(50, 0)));
  const double push = random.between(2, 4);
  for (int i = 0; i < dominoes; ++i) {
    const double x = (i + (i == 0 ? 0 : random.between(-irregular, irregular))) * row.pitch;
    scene.bodies.push_back(
        box("domino " + std::to_string(i + 1), {x, row.height / 2}, {row.thickness, row.height}, surface(0.02, 0)));
  }
  Body& pushed = scene.bodies[1];
  pushed.angular_velocity = -push;
  pushed.velocity = {push * row.height / 2, push * row.thickness / 2};
  return scene;
}

std::vector<EnsembleDraw> draws(EnsembleRun& run, std::uint64_t seed) {
  Random random(seed);
  const Scene scene = row_of_dominoes(random);
  std::vector<double> reached(dominoes, -1), before(dominoes, 0);
  run.watch(scene, [&](double time, std::span<const BodyState> states) {
    for (std::size_t i = 0; i < dominoes; ++i) {
      const double lean = -states[i + 1].angle;
      if (reached[i] < 0 && lean >= leaning && i > 0)
        reached[i] = time - run.dt() * (lean - leaning) / (lean - before[i]);
      before[i] = lean;
    }
    return reached[last] < 0;
  });
  if (reached[last] < 0)
    throw std::domain_error("the dominoes stop falling before the " + std::to_string(last + 1) + "th");
  const double way = scene.bodies[last + 1].position.x - scene.bodies[first + 1].position.x;
  return {{way / (reached[last] - reached[first]) / std::sqrt(row.height * standard_gravity)}};
}

// When the front one is upright, those behind it lean by 23.6, 44.6, 59.4, 68.3 ... degrees.
constexpr int leaning_steeply = 4;

double in_units(double speed) { return speed / std::sqrt(row.height * standard_gravity); }

const Catalog<Ensemble>::Entry entry{
    {.name = "domino-wave",
     .question = "Does the front run along a row of dominoes as fast as it can with their weight, and no faster?",
     .dt = 1.0 / 240,
     .runs = 16,
     .large = 320,
     .statistics = {{.name = "speed/sqrt(g h)",
                     .low = in_units(row.speed(leaning_steeply)),
                     .high = in_units(row.speed(20)),
                     .resolution = 0.05,
                     .source = "e = 0 without friction: at least the four at the front that lean by less than 60 deg "
                               "push, at most all (van Leeuwen 2010; one alone, Stronge 1987: .27)"}},
     .draws = draws,
     .control = [] { return *Catalog<Control>::find("half-gravity"); }}};

}  // namespace
}  // namespace plumb::ensembles::domino_wave
